// The loop of an estimator, whitted.glsl or first_hit.glsl: each iteration traces one ray, to a surface or to a light.

layout(local_size_x = 64) in;

void main() {
    if (!open_slot()) return;
    while (phase != phase_next || next_path()) {
        Hit hit = trace_ray();
        SurfacePoint point;
        if (hit.kind != kind_none && !any_hit) point = surface_at(hit, ray.origin, ray.direction);
        if (phase == phase_path)
            at_surface(hit, point);
        else if (ends_shadow_ray(hit, point))
            add_light();
        if (phase == phase_lights) next_light();
        if (phase == phase_lights) finish();
    }
    close_slot();
}
