#ifndef GLINT_GPU_INTERIORS_SHARED_H
#define GLINT_GPU_INTERIORS_SHARED_H
#include "math/shared.h"

// The list of the transparent solids around a ray, for nested dielectrics (render/interior_list.h), in the
// form that rays carry it on the GPU: up to eight numbers of solids, of 16 bits each, highest rank first,
// then zeros. Numbers grow with rank.

GLINT_SHARED_BEGIN

const int max_interiors = 8;

GLINT_FN uint interiors_entry(uvec4 list, int i) {
    return i < max_interiors ? list[i / 2] >> (16 * (i % 2)) & 0xffffu : 0u;
}

GLINT_FN bool interiors_full(uvec4 list) { return interiors_entry(list, max_interiors - 1) != 0u; }

/// The list with one more solid; from a full list the lowest falls out.
GLINT_FN uvec4 interiors_with(uvec4 list, uint interior) {
    uvec4 longer = uvec4(0u);
    uint lower = interior;
    for (int i = 0; i < max_interiors; ++i) {
        uint entry = interiors_entry(list, i);
        longer[i / 2] |= max(entry, lower) << (16 * (i % 2));
        lower = min(entry, lower);
    }
    return longer;
}

/// The list without one entry of a solid; the same list if it has none.
GLINT_FN uvec4 interiors_without(uvec4 list, uint interior) {
    uvec4 shorter = uvec4(0u);
    int skipped = 0;
    for (int i = 0; i < max_interiors; ++i) {
        if (interiors_entry(list, i) == interior) skipped = 1;
        shorter[i / 2] |= interiors_entry(list, i + skipped) << (16 * (i % 2));
    }
    return shorter;
}

GLINT_SHARED_END
#endif
