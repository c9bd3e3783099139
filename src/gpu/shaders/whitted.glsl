// Whitted's model. Ray trees are followed depth first; a ray carries its weight, so branches bring nothing back.

LocalTerms local;

void at_surface(Hit hit, SurfacePoint point) {
    if (hit.kind == kind_none) {
        // What never leaves a solid brings nothing; what misses everything gets the background.
        bool shown = path.depth > 0u || settings.hides_background == 0u;
        if (path.interiors.x == 0u && shown) add_to_pixel(term_emission, settings.background);
        phase = phase_next;
        return;
    }
    if (passes_hidden(hit, point)) return;
    if (path.depth == 0u) slot.covered = true;
    if (GLINT_GLASS != 0)
        path.weight *= transmittance(objects[interiors_owner(path.interiors)].material.absorption, hit.t);
    meet_surface(hit, point);
    local = ambient_terms(settings.ambient_light, surface, material);
}

bool needs_shadow_ray() { return is_worth_shadow_ray(settings.modes, surface, material, arrival); }

void add_light() {
    local = with_light(local, shown_light(settings.modes, surface, material, arrival, passing));
}

void add_local(LocalTerms shown) {
    if (path.term == invalid_index && GLINT_TERMS != 1) {
        add_to_pixel(term_ambient, shown.ambient);
        add_to_pixel(term_diffuse, shown.diffuse);
        add_to_pixel(term_highlight, shown.highlight);
        add_to_pixel(term_clamp, shown.clamp);
        add_to_pixel(term_emission, material.emission);
    } else {
        add_to_pixel(term_emission, (local_sum(shown) + shown.clamp) + material.emission);
    }
}

void branch(Path from, SpawnedRay next_ray, vec3 share, uint term, uvec4 interiors) {
    if (is_dark(share)) return;
    vec3 weight = from.weight * share;
    if (!is_worth_following(weight, settings.min_weight)) {
        ++left_out;
        return;
    }
    ++rays[term == term_reflection ? 1 : 2];
    follow(Path(next_ray.origin, next_ray.direction, weight, from.depth + 1u,
                from.term == invalid_index ? term : from.term, interiors));
}

/// The mirror ray is the next path; the refracted ray waits meanwhile.
void bounce() {
    Path from = path;
    Split split = split_at_sheet(surface, material);
    if (GLINT_GLASS != 0 && refracts) {
        float index_1 = objects[interiors_owner(from.interiors)].material.index;
        float index_2 = objects[interiors_owner(beyond)].material.index;
        split = split_at_solid(material, refraction_at(surface, index_1 / index_2), index_1, index_2);
    }
    vec3 refracted = tint * (split.refracted * others);
    branch(from, spawn_ray(surface, split.direction), refracted, term_transmission, beyond);
    branch(from, reflected_ray(surface), material.reflected_tint * split.reflected, term_reflection, from.interiors);
}

/// All lights are known: the local terms, and the branches.
void finish() {
    bool goes_on = has_bounces(material) && path.depth < settings.max_depth;
    float weight = goes_on ? local_weight(settings.modes, material) : 1.0f;
    add_local(weighted_terms(limited_terms(settings.modes, local), weight));
    phase = phase_next;
    if (goes_on) bounce();
}
