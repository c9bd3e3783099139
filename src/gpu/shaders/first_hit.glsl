// What first hits show in place of the light (render/aov.shared.h): numbers of a ray tree without branches.

layout(local_size_x = 64) in;

float hidden;  // lights, whole or in part
float first_t;

void show(vec3 number) {
    add_term(0u, number);
    phase = phase_next;
}

void at_surface(Hit hit, SurfacePoint point) {
    int aov = int(settings.aov);
    if (aov == shown_cost || hit.kind == kind_none) {
        slot.covered = hit.kind != kind_none;
        show(aov == shown_cost ? cost_number(steps_to_nodes, steps_to_shapes)
                               : first_hit_number(aov, false, 0.0f, vec3(0.0f), 0.0f));
        return;
    }
    if (passes_hidden(hit, point)) return;
    slot.covered = true;
    meet_surface(hit, point);
    hidden = 0.0f;
    first_t = hit.t;
    if (aov != shown_shadows) light = settings.light_count;
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
        else if (ends_shadow_ray(hit, point))
            hidden = hidden_with(hidden, passing);
        if (phase == phase_lights) next_light();
        if (phase == phase_lights) show(first_hit_number(int(settings.aov), true, first_t, surface.n, hidden));
    }
    close_slot();
}
