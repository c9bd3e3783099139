// Whitted's model. Each turn of the loop traces one ray, to a surface or to a light. Trees of rays are followed depth
// first; a ray carries its weight, so nothing is brought back from its branches.

layout(local_size_x = 64) in;

LocalTerms local;

void at_surface(Hit hit, SurfacePoint point) {
    if (hit.kind == kind_none) {
        // What never leaves a solid brings nothing; what misses everything gets the background.
        if (path.interiors.x == 0u)
            add_term(path.term == invalid_index ? term_emission : path.term, path.weight * settings.background);
        phase = phase_next;
        return;
    }
    if (passes_hidden(hit, point)) return;
    if (path.depth == 0u) slot.covered = true;
    path.weight *= interiors_transmittance(path.interiors, hit.t);
    meet_surface(hit, point);
    local = ambient_terms(settings.ambient_light, surface, material);
}

void at_light(Hit hit, SurfacePoint point) {
    if (!ends_shadow_ray(hit, point)) return;
    ShownLight shown = shown_light(settings.modes, surface, material, arrival, passing);
    local.diffuse += shown.diffuse;
    local.highlight += shown.highlight;
}

void add_local(LocalTerms shown) {
    if (path.term == invalid_index && GLINT_TERMS != 1) {
        add_term(term_ambient, path.weight * shown.ambient);
        add_term(term_diffuse, path.weight * shown.diffuse);
        add_term(term_highlight, path.weight * shown.highlight);
        add_term(term_clamp, path.weight * shown.clamp);
        add_term(term_emission, path.weight * material.emission);
    } else {
        add_term(path.term, path.weight * ((local_sum(shown) + shown.clamp) + material.emission));
    }
}

Path branch(SpawnedRay next_ray, float share, uint term, uvec4 interiors) {
    return Path(next_ray.origin, next_ray.direction, path.weight * share, path.depth + 1u,
                path.term == invalid_index ? term : path.term, interiors);
}

/// The mirror ray is the next path; the refracted ray waits meanwhile.
void bounce() {
    Split split = split_at_sheet(surface, material);
    uvec4 beyond = path.interiors;
    if (GLINT_GLASS != 0 && objects[surface_object].interior != 0u) {
        beyond = interiors_across(path.interiors, surface_object, entering);
        float index_before = interiors_index(path.interiors);
        float index_after = interiors_index(beyond);
        Refraction refraction = refraction_at(surface, index_before / index_after);
        split = split_at_solid(material, refraction, index_before, index_after);
    }
    bool reflects = split.reflected > 0.0f;
    bool refracts = split.refracted > 0.0f;
    slot.has_path = reflects || refracts;
    if (refracts) {
        ++rays.z;
        Path refracted = branch(spawn_ray(surface, split.direction), split.refracted, term_transmission, beyond);
        if (reflects)
            let_wait(refracted);
        else
            path = refracted;
    }
    if (reflects) {
        ++rays.y;
        path = branch(reflected_ray(surface), split.reflected, term_reflection, path.interiors);
    }
}

/// All lights are known: the local terms, and the branches.
void finish() {
    bool goes_on = has_bounces(material) && path.depth < settings.max_depth;
    float weight = goes_on ? local_weight(settings.modes, material) : 1.0f;
    add_local(weighted_terms(limited_terms(settings.modes, local), weight));
    phase = phase_next;
    if (goes_on) bounce();
}

void main() {
    if (!open_slot()) return;
    for (;;) {
        if (phase == phase_next) {
            if (!next_path()) break;
            start_path();
        }
        Hit hit = trace_ray();
        SurfacePoint point;
        if (hit.kind != kind_none && !any_hit) point = surface_at(hit, ray.origin, ray.direction);
        if (phase == phase_path)
            at_surface(hit, point);
        else
            at_light(hit, point);
        if (phase == phase_lights) next_light();
        if (phase == phase_lights) finish();
    }
    close_slot();
}
