// A hit that is ready to be shaded and the shadow rays from it, one a turn of an estimator's loop. The steps are those
// of shading/whitted.shared.h.

// The surface that the path has hit.
SurfaceRecord surface;
MaterialRecord material;
uint surface_object;
bool entering; // hit from outside

// The light that it is asked about.
uint light;
LightArrival arrival;
float passing; // the share of the light that passes what the shadow ray has met so far
uvec4 shadow_interiors;

bool enters(SurfacePoint point) { return dot(point.n, ray.direction) < 0.0f; }

/// Surfaces inside a transparent solid of higher rank are passed over on the same ray, one by one.
bool passes_hidden(Hit hit, SurfacePoint point) {
    if (!interiors_hide(path.interiors, hit.object)) return false;
    path.interiors = interiors_across(path.interiors, hit.object, enters(point));
    after = hit;
    return true;
}

/// Makes the path's hit ready to be shaded.
void meet_surface(Hit hit, SurfacePoint point) {
    phase = phase_lights;
    light = 0u;
    surface_object = hit.object;
    material = objects[hit.object].material;
    entering = enters(point);
    surface.p = point.p;
    surface.p_error = point.p_error;
    surface.v = -ray.direction;
    surface.n_g = entering ? point.n : -point.n;
    surface.n = surface.n_g;
    surface.color = material.color;
    bool behind = entering == object_is(hit.object, object_turned);
    surface.lit_side = object_is(hit.object, object_lit_as_stored) && behind ? -1.0f : 1.0f;
    interpolate(hit, surface);
}

/// The next light that is worth a shadow ray, if there is any.
void next_light() {
    for (; light < settings.light_count; ++light) {
        arrival = light_arrival(lights[light], surface);
        if (!is_worth_shadow_ray(material, arrival)) continue;
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

/// What the shadow ray has met takes its share of the light. False if the ray goes on behind it.
bool ends_shadow_ray(Hit hit, SurfacePoint point) {
    if (hit.kind != kind_none && any_hit) {
        passing = 0.0f;
    } else if (hit.kind != kind_none) {
        if (!interiors_hide(shadow_interiors, hit.object))
            passing *= shadow_transmittance(settings.modes, objects[hit.object].material.transparency);
        shadow_interiors = interiors_across(shadow_interiors, hit.object, enters(point));
        after = hit;
        if (passing > 0.0f) return false;
    }
    phase = phase_lights;
    ++light;
    return true;
}
