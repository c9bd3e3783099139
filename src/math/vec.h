#pragma once
// GLM's vectors and matrices, without SIMD types, in namespace glint; norms and the inverse.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace glint {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// The maximum norm: largest |coordinate|.
inline double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The matrix norm induced by largest().
inline double norm(const dmat3& m) {
    const dvec3 rows = glm::abs(m[0]) + glm::abs(m[1]) + glm::abs(m[2]);
    return std::max({rows.x, rows.y, rows.z});
}

inline bool is_finite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

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
