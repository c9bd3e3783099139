// What first hits show in place of the light (render/aov.shared.h): numbers of a ray tree without branches.

float first_t;
float hidden; // lights, whole or in part

void at_surface(Hit hit, SurfacePoint point) {
    slot.covered = hit.kind != kind_none;
    if (slot.covered && settings.aov != shown_cost && passes_hidden(hit, point)) return;
    first_t = hit.t;
    hidden = 0.0f;
    phase = phase_lights;
    if (slot.covered) meet_surface(hit, point);
    if (!slot.covered || settings.aov != shown_shadows) light = settings.light_count;
}

bool needs_shadow_ray() { return reflects_light(material, arrival); }

void add_light() { hidden = hidden_with(hidden, max(passing.x, max(passing.y, passing.z))); }

void finish() {
    add_to_pixel(0u, settings.aov == shown_cost
                         ? cost_number(steps_to_nodes, steps_to_shapes)
                         : first_hit_number(settings.aov, slot.covered, first_t, surface.n, hidden));
    phase = phase_next;
}
