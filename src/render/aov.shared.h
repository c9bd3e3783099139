#ifndef GLINT_RENDER_AOV_SHARED_H
#define GLINT_RENDER_AOV_SHARED_H
#include "math/shared.h"

// AOVs of first hits, on the CPU and on the GPU.

GLINT_SHARED_BEGIN

// The numbers of Aov (glint/render.h).
const int shown_shadows = 8;
const int shown_normal = 9;
const int shown_depth = 10;
const int shown_cost = 11;

/// Shadows: lights that are hidden, whole or in part, with one more that gets through by `shadow`.
GLINT_FN float hidden_with(float hidden, float shadow) { return hidden + (1.0f - shadow); }

/// Shadows, normal or depth of a ray; `found`: it met something, at distance t, with the shading normal n
/// toward the viewer.
GLINT_FN vec3 first_hit_number(int shown, bool found, float t, vec3 n, float hidden) {
    vec3 depth = vec3(pick(found, t, intBitsToFloat(0x7f800000)));
    vec3 normal = pick(found, n, vec3(0.0f));
    vec3 number = pick(shown == shown_depth, depth, normal);
    return pick(shown == shown_shadows, vec3(hidden), number);
}

/// Cost: steps of a walk through the tree.
GLINT_FN vec3 cost_number(uint nodes, uint shapes) { return vec3(float(nodes), float(shapes), 0.0f); }

GLINT_SHARED_END
#endif
