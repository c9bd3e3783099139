#pragma once
// Rays.

#include "math/vec.h"

#include <limits>

namespace glint {

/// Points origin + t · direction for tmin < t < tmax. The direction need not be normalized; t is in units of
/// its length.
struct Ray {
    vec3 origin{0.0f};
    float tmin = 0.0f;
    vec3 direction{0.0f, 0.0f, 1.0f};
    float tmax = std::numeric_limits<float>::infinity();
};

/// Whether the ray can hit anything: false for NaN, infinite origins or directions, a zero direction, and an
/// empty interval.
inline bool is_traceable(const Ray& ray) {
    // Each product is 0, or NaN where a value is not finite.
    const vec3 zero = ray.origin * 0.0f + ray.direction * 0.0f;
    return zero == vec3(0.0f) && ray.direction != vec3(0.0f) && ray.tmin < ray.tmax;
}

} // namespace glint
