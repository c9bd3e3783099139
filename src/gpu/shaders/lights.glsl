// A hit that is ready to be shaded and the shadow rays from it, one an iteration of the loop.

// The surface that the path has hit.
SurfaceRecord surface;
MaterialRecord material;
uvec4 beyond;  // the solids around a ray behind it
vec3 tint;     // of light that goes through it and what coincides with it
bool refracts; // it bounds a transparent solid
float others;  // the share of refracted light that what coincides with it lets through

// The light whose share is measured.
uint light;
LightArrival arrival;
vec3 passing;  // the share of the light that passes what the shadow ray has met so far
uvec4 shadow_interiors;

/// Lets the ray go on behind a hit and what coincides with it.
void pass_through(Hit hit, SurfacePoint point, inout uvec4 interiors) {
    interiors = interiors_behind(interiors, hit, point);
    after = last_met(hit);
}

/// Skips a surface inside a transparent solid of higher rank.
bool passes_hidden(Hit hit, SurfacePoint point) {
    if (!interiors_hide(path.interiors, hit.object)) return false;
    pass_through(hit, point, path.interiors);
    return true;
}

/// Prepares the path's hit for shading.
void meet_surface(Hit hit, SurfacePoint point) {
    phase = phase_lights;
    light = 0u;
    material = objects[hit.object].material;
    material.emission = emitted(material, enters(point.n, ray.direction));
    beyond = interiors_behind(path.interiors, hit, point);
    refracts = objects[hit.object].interior != 0u;
    others = 1.0f;
    tint = tint_at(hit);
#if GLINT_CONTACTS
    if (contact.exists) {
        refracts = contact.refracts;
        others = transparency_at(hit) / material.transparency;
        point.p_error += vec3(contact.margin);
    }
#endif
    surface = surface_record(point, ray.direction, material.color, object_is(hit.object, object_lit_as_stored),
                             object_is(hit.object, object_turned));
    interpolate(hit, surface);
}

bool needs_shadow_ray(); // of `surface` in the light that arrives: the estimator's

/// The next light that is worth a shadow ray, if there is any.
void next_light() {
    for (; light < settings.light_count; ++light) {
        arrival = light_arrival(lights[light], surface);
        if (!needs_shadow_ray()) continue;
        phase = phase_shadow;
        passing = vec3(1.0f);
        // Light on a back that is lit as stored arrives on the other side of the surface.
        shadow_interiors = surface.lit_side < 0.0f ? beyond : path.interiors;
        bool may_pass = GLINT_GLASS != 0 && (settings.modes.opaque_shadows == 0 || shadow_interiors.x != 0u);
        start_ray(shadow_ray(lights[light], surface, arrival), !may_pass);
        ++rays.w;
        return;
    }
}

/// Takes the share of light that a hit of the shadow ray blocks. False if the ray goes on behind it.
bool ends_shadow_ray(Hit hit, SurfacePoint point) {
    if (hit.kind != kind_none) {
        if (!interiors_hide(shadow_interiors, hit.object))
            passing *= tint_at(hit) * shadow_transmittance(settings.modes, transparency_at(hit));
        if (!is_dark(passing)) {
            pass_through(hit, point, shadow_interiors);
            return false;
        }
    }
    phase = phase_lights;
    ++light;
    return true;
}
