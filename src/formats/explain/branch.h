#pragma once
// Branches of ray trees.

#include "glint/explanation.h"

namespace glint::formats {

/// The number of rays of a branch: the ray and all its descendants.
inline int rays_in_branch(const ExplainedSample& sample, std::size_t ray) {
    int count = 1;
    for (const int child : {sample.rays[ray].reflected, sample.rays[ray].refracted})
        if (child >= 0) count += rays_in_branch(sample, static_cast<std::size_t>(child));
    return count;
}

} // namespace glint::formats
