// Rays alone, without light: gpu/rays.h. A ray's words are overwritten by those of its hit.

layout(local_size_x = 64) in;

const uint words_of_ray = 7u; // origin, direction, limit; then t, u, v, object, number in it, steps

void main() {
    uint ray_number = settings.first_slot + gl_GlobalInvocationID.x;
    if (ray_number >= settings.end_slot) return;
    uint at = words_of_ray * ray_number;
    vec3 origin = uintBitsToFloat(uvec3(work[at], work[at + 1u], work[at + 2u]));
    vec3 direction = uintBitsToFloat(uvec3(work[at + 3u], work[at + 4u], work[at + 5u]));
    Hit hit = trace(origin, direction, uintBitsToFloat(work[at + 6u]), no_hit(0.0f), settings.any_hit != 0u);
    work[at] = floatBitsToUint(hit.t);
    work[at + 1u] = floatBitsToUint(hit.u);
    work[at + 2u] = floatBitsToUint(hit.v);
    work[at + 3u] = hit.kind == kind_none ? invalid_index : hit.object;
    work[at + 4u] = hit.prim;
#if GLINT_COUNT
    work[at + 5u] = steps_to_nodes;
    work[at + 6u] = steps_to_shapes;
#endif
}
