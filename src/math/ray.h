#pragma once

#include "math/vec.h"

#include <limits>

namespace glint {

/// Points origin + t · direction for tmin < t < tmax. The direction need not be of unit length; t counts in
/// it.
struct Ray {
    vec3 origin{0.0f};
    float tmin = 0.0f;
    vec3 direction{0.0f, 0.0f, 1.0f};
    float tmax = std::numeric_limits<float>::infinity();
};

} // namespace glint
