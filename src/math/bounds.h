#pragma once
// Axis-aligned boxes.

#include "math/vec.h"

#include <glm/vector_relational.hpp>

#include <limits>

namespace glint {

/// A closed axis-aligned box. Empty if lo > hi, as initially.
struct Bounds {
    vec3 lo{std::numeric_limits<float>::infinity()};
    vec3 hi{-std::numeric_limits<float>::infinity()};

    bool empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
    vec3 extent() const { return hi - lo; }
    void grow(const vec3& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void grow(const Bounds& b) {
        lo = glm::min(lo, b.lo);
        hi = glm::max(hi, b.hi);
    }
    /// Largest |coordinate|.
    float max_coordinate() const {
        const vec3 far = glm::max(glm::abs(lo), glm::abs(hi));
        return std::max({far.x, far.y, far.z});
    }
    bool contains(const vec3& p) const {
        return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z && p.z <= hi.z;
    }
    /// Half the surface area, as used by the surface area heuristic.
    float half_area() const {
        const vec3 d = extent();
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// What two boxes have in common; empty if they do not touch.
inline Bounds common_box(const Bounds& a, const Bounds& b) {
    return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)};
}

/// Whether two boxes have a point in common.
inline bool touch(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

} // namespace glint
