// Whitted's model, a turn at a time: each turn of the loop traces one ray, to a surface or to a light.
// Trees are followed depth first; a ray carries its weight, so that nothing comes back from its branches.
// With GLINT_FIRST_HIT the rays are those of a tree without branches, and numbers are shown in place of light.

layout(local_size_x = 64) in;

const uint phase_next = 0u;   // a new ray is wanted
const uint phase_path = 1u;   // on the way to a surface
const uint phase_lights = 2u; // at a surface, a light is wanted
const uint phase_shadow = 3u; // on the way to a light

// What a sample's light is made of so far.
vec3 terms[GLINT_TERMS];

void add_term(uint term, vec3 value) { terms[GLINT_TERMS == 1 ? 0u : term] += value; }

void add_to_film(uint slot, float weight, bool covered) {
    uint stride = settings.slot_count;
    uint at = slot + (weight > 0.0f ? 0u : film_fields_of_term / 2u * uint(GLINT_TERMS) * stride);
    for (int i = 0; i < GLINT_TERMS; ++i)
        for (int axis = 0; axis < 3; ++axis) film[at + uint(3 * i + axis) * stride] += terms[i][axis];
    uint counts = slot + film_fields_of_term * uint(GLINT_TERMS) * stride;
    if (weight > 0.0f) film[counts] += 1.0f;
    if (covered) film[counts + stride] += 1.0f;
}

void save_slot(uint slot, uint number, uint state) {
    work[slot_field(slot, field_sample)] = number - settings.first_sample;
    work[slot_field(slot, field_state)] = state;
    for (uint i = 0u; i < uint(GLINT_TERMS); ++i) save_vector(slot_field(slot, field_terms + fields_of_term * i), terms[i]);
    if (number >= settings.end_sample) atomicAdd(work[counter_unfinished], 0xffffffffu); // one less
}

void main() {
    uint slot = settings.first_slot + gl_GlobalInvocationID.x;
    if (slot >= settings.end_slot) return;
    uvec2 pixel = slot_pixel(slot);
    uint number = work[slot_field(slot, field_sample)] + settings.first_sample;
    if (any(greaterThanEqual(pixel, uvec2(settings.end_x, settings.end_y))) || number >= settings.end_sample) return;

    uint state = work[slot_field(slot, field_state)];
    // The driver ended the loop below before its end: see gpu/pace.h.
    if ((state & state_running) != 0u) {
        atomicOr(work[counter_faults], fault_loops);
        return;
    }
    work[slot_field(slot, field_state)] = state | state_running;
    atomicAdd(work[counter_unfinished], 1u);
    for (uint i = 0u; i < uint(GLINT_TERMS); ++i) terms[i] = saved_vector(slot_field(slot, field_terms + fields_of_term * i));
    uint waiting = state & state_waiting;
    bool begun = (state & state_begun) != 0u;
    float weight = (state & state_negative) != 0u ? -1.0f : 1.0f;
    bool covered = (state & state_covered) != 0u;

    uvec4 rays = uvec4(0u);
    uint budget = settings.max_nodes;
    uint phase = phase_next;
    Path path;
    Path sibling;
    bool has_path = false; // `path` is the next to be followed
    Lit s;
    Material m;
    Arriving arriving;
    uint light = 0u;
    vec3 diffuse = vec3(0.0f);
    vec3 highlight = vec3(0.0f);
    float shadow = 1.0f;
    bool walking = false;
    uvec4 shadow_media = uvec4(0u);
    vec3 origin = vec3(0.0f);
    vec3 direction = vec3(0.0f);
    float limit = 0.0f;
    Hit after = no_hit(0.0f);
#if GLINT_FIRST_HIT
    int shown = int(settings.aov);
    float hidden = 0.0f;
    float first_t = 0.0f;
#endif
    for (;;) {
        if (phase == phase_next) {
            bool idle = !has_path && waiting == 0u;
            if (idle && begun) {
                add_to_film(slot, weight, covered);
                for (int i = 0; i < GLINT_TERMS; ++i) terms[i] = vec3(0.0f);
                begun = false;
                ++number;
            }
            if ((idle && number >= settings.end_sample) || budget == 0u || turns >= settings.max_walk_steps) {
                // Here and not behind the loop: a driver may have ended that.
                if (has_path) save_path(slot, waiting++, path);
                save_slot(slot, number,
                          waiting | (begun ? state_begun : 0u) | (weight < 0.0f ? state_negative : 0u) |
                              (covered ? state_covered : 0u));
                break;
            }
            if (idle) {
                path = primary_path(pixel, number, settings.samples, weight);
                begun = true;
                covered = false;
                ++rays.x;
            } else if (!has_path) {
                path = saved_path(slot, --waiting);
            }
            has_path = false;
            --budget;
            phase = phase_path;
            origin = path.origin;
            direction = path.direction;
            limit = 3.40282347e38f;
            after = no_hit(0.0f);
            walking = true;
        }

        Hit hit = trace(origin, direction, limit, after, !walking);
        Surface surface;
        if (hit.kind != kind_none && walking) surface = surface_of(hit, origin, direction);

        if (phase == phase_path) {
#if GLINT_FIRST_HIT
            if (shown == shown_cost || hit.kind == kind_none) {
                add_term(0u, shown == shown_cost ? cost_number(steps_to_nodes, steps_to_shapes)
                                                 : first_hit_number(shown, false, 0.0f, vec3(0.0f), 0.0f));
                covered = hit.kind != kind_none;
                phase = phase_next;
                continue;
            }
#else
            if (hit.kind == kind_none) {
                // What never leaves a solid brings nothing; what misses everything gets the background.
                if (path.media.x == 0u)
                    add_term(path.term == none ? term_emission : path.term, path.weight * settings.background);
                phase = phase_next;
                continue;
            }
#endif
            if (media_hide(path.media, hit.object)) {
                uint medium = object_medium(hit.object);
                if (medium != 0u)
                    path.media = media_across(path.media, medium, dot(surface.n, direction) < 0.0f);
                after = hit;
                continue;
            }
            if (path.depth == 0u) covered = true;
            if (path.media.x != 0u) {
                vec3 sigma = material_absorption(object_material(media_object(media_head(path.media))));
                if (sigma != vec3(0.0f)) path.weight *= transmittance(sigma, hit.t);
            }
            s = lit_surface(hit, surface, direction);
            m = material_at(object_material(hit.object));
            diffuse = vec3(0.0f);
            highlight = vec3(0.0f);
            light = 0u;
            phase = phase_lights;
#if GLINT_FIRST_HIT
            hidden = 0.0f;
            first_t = hit.t;
            if (shown != shown_shadows) light = settings.light_count;
#endif
        } else {
            if (hit.kind != kind_none) {
                if (!walking) {
                    shadow = 0.0f;
                } else {
                    if (!media_hide(shadow_media, hit.object)) {
                        float tau = material_transparency(object_material(hit.object));
                        shadow = settings.opaque_shadows != 0u || !(tau > 0.0f) ? 0.0f : shadow * tau;
                    }
                    uint medium = object_medium(hit.object);
                    if (medium != 0u)
                        shadow_media = media_across(shadow_media, medium, dot(surface.n, direction) < 0.0f);
                    after = hit;
                    if (shadow > 0.0f) continue;
                }
            }
#if GLINT_FIRST_HIT
            hidden = hidden_with(hidden, shadow);
#else
            add_light(s, m, arriving, shadow, diffuse, highlight);
#endif
            ++light;
            phase = phase_lights;
        }

        // The next light that is worth a ray. It ends at t = 1 for a light with a place.
        bool shines = m.diffuse > 0.0f || m.highlight > 0.0f;
        for (; shines && light < settings.light_count; ++light) {
            Light source = light_at(light);
            arriving = arriving_from(source, s);
            if (arriving.light == vec3(0.0f)) continue;
            origin = offset_ray_origin(s.p, s.p_error, s.n_g, arriving.direction);
            direction = arriving.direction;
            limit = 3.40282347e38f;
            if (source.kind != light_directional) {
                direction = source.position - origin;
                limit = 0.99999994f;
            }
            phase = phase_shadow;
            break;
        }
        if (phase == phase_shadow) {
            ++rays.w;
            shadow = 1.0f;
            after = no_hit(0.0f);
            shadow_media = path.media;
            uint medium = object_medium(s.object);
            if (s.lit_side < 0.0f && medium != 0u) shadow_media = media_across(shadow_media, medium, s.entering);
            walking = GLINT_GLASS != 0 && (settings.opaque_shadows == 0u || shadow_media.x != 0u);
            continue;
        }

#if GLINT_FIRST_HIT
        add_term(0u, first_hit_number(shown, true, first_t, s.n, hidden));
        phase = phase_next;
#else
        // The local terms, limited and weighed, and what becomes of the light that goes on.
        vec3 ambient = ambient_term(settings.ambient_light, s.color, m.ambient);
        vec3 clamped = vec3(0.0f);
        if (settings.clamp_light != 0u) {
            ambient = limit_to_range(ambient);
            highlight = limit_to_range(highlight);
            vec3 sum = (ambient + diffuse) + highlight;
            clamped = limit_to_one(sum) - sum;
        }
        bool goes_on = (m.reflectivity > 0.0f || m.transparency > 0.0f) && path.depth < settings.max_depth;
        float local = goes_on ? local_weight(m.reflectivity, m.transparency, settings.balanced_energy != 0u) : 1.0f;
        if (path.term == none && GLINT_TERMS != 1) {
            add_term(term_ambient, path.weight * (ambient * local));
            add_term(term_diffuse, path.weight * (diffuse * local));
            add_term(term_highlight, path.weight * (highlight * local));
            add_term(term_clamp, path.weight * (clamped * local));
            add_term(term_emission, path.weight * m.emission);
        } else {
            vec3 sum = (((ambient * local + diffuse * local) + highlight * local) + clamped * local) + m.emission;
            add_term(path.term, path.weight * sum);
        }
        phase = phase_next;
        if (!goes_on) continue;
        Split split = split_at(path, s, m);
        bool reflects = split.reflected > 0.0f;
        bool transmits = split.refracted > 0.0f;
        if (transmits) {
            ++rays.z;
            sibling = transmitted_path(path, s, split);
            if (reflects) save_path(slot, waiting++, sibling);
        }
        if (reflects) {
            ++rays.y;
            path = reflected_path(path, s, split.reflected);
        } else if (transmits) {
            path = sibling;
        }
        has_path = reflects || transmits;
#endif
    }

    if (media_overflowed) atomicOr(work[counter_faults], fault_interiors);
    for (uint i = 0u; i < 4u; ++i)
        if (rays[i] != 0u) atomicAdd(work[counter_rays + i], rays[i]);
}
