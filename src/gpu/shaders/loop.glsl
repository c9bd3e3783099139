// The loop of an estimator, whitted.glsl or first_hit.glsl: each iteration traces one ray, to a surface or to a light.

layout(local_size_x = 64) in;

void main() {
    if (!open_slot()) return;
    while (phase != phase_next || next_path()) {
        Hit hit = trace_ray();
        SurfacePoint point;
        if (hit.kind != kind_none && !any_hit) point = surface_at(hit, ray.origin, ray.direction);
#if GLINT_CONTACTS
        bool shows_cost = GLINT_COUNT != 0 && settings.aov == shown_cost;
        if (phase == phase_path && !shows_cost && collects(hit, point, path.interiors)) continue;
        if (phase == phase_shadow && !any_hit && collects(hit, point, shadow_interiors)) continue;
#endif
        if (phase == phase_path)
            at_surface(hit, point);
        else if (ends_shadow_ray(hit, point))
            add_light();
        if (phase == phase_lights) next_light();
        if (phase == phase_lights) finish();
    }
    close_slot();
}
