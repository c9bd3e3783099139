#pragma once

#include "math/vec.h"

namespace glint {

/// The inverse by cofactors: homogeneous in every column, so that it scales by 2^k to the bit. Not finite
/// where m is singular.
inline dmat3 inverted(const dmat3& m) {
    const dvec3 r0 = glm::cross(m[1], m[2]);
    const dvec3 r1 = glm::cross(m[2], m[0]);
    const dvec3 r2 = glm::cross(m[0], m[1]);
    const double determinant = glm::dot(m[0], r0);
    return glm::transpose(dmat3(r0 / determinant, r1 / determinant, r2 / determinant));
}

} // namespace glint
