#pragma once
#include "math/vec.h"

namespace glint {

/// A point of a surface with the unit normal there, both in double.
struct ExactPoint {
    dvec3 p;
    dvec3 n;
};

} // namespace glint
