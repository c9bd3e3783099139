// A hit that is ready to be shaded and the shadow rays from it, one an iteration of the loop.

// The surface that the path has hit.
SurfaceRecord surface;
MaterialRecord material;
uint surface_object;
bool entering; // hit from outside

// The light whose share is measured.
uint light;
LightArrival arrival;
float passing; // the share of the light that passes what the shadow ray has met so far
uvec4 shadow_interiors;

/// Lets the ray go on behind a hit.
void pass_through(Hit hit, SurfacePoint point, inout uvec4 interiors) {
    interiors = interiors_across(interiors, hit.object, enters(point.n, ray.direction));
    after = hit;
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
    surface_object = hit.object;
    material = objects[hit.object].material;
    entering = enters(point.n, ray.direction);
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
        passing = 1.0f;
        shadow_interiors = path.interiors;
        // Light on a back that is lit as stored arrives on the other side of the surface.
        if (surface.lit_side < 0.0f)
            shadow_interiors = interiors_across(shadow_interiors, surface_object, entering);
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
            passing *= shadow_transmittance(settings.modes, objects[hit.object].material.transparency);
        if (passing > 0.0f) {
            pass_through(hit, point, shadow_interiors);
            return false;
        }
    }
    phase = phase_lights;
    ++light;
    return true;
}
