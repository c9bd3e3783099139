#pragma once
// Matrix inversion.

#include "math/vec.h"

namespace glint {

/// The inverse by cofactors. Homogeneous in every column: scaling by 2^k is exact. Not finite if m is
/// singular.
inline dmat3 inverted(const dmat3& m) {
    const dvec3 r0 = glm::cross(m[1], m[2]);
    const dvec3 r1 = glm::cross(m[2], m[0]);
    const dvec3 r2 = glm::cross(m[0], m[1]);
    const double determinant = glm::dot(m[0], r0);
    return glm::transpose(dmat3(r0 / determinant, r1 / determinant, r2 / determinant));
}

} // namespace glint
