// A double rounded to float stays rounded: g++ 12 loses this when it vectorizes.

#include "math/vec.h"

#include <gtest/gtest.h>

namespace glint::geometry {
namespace {

dvec3 through_float(const dvec3& v) { return dvec3(vec3(v)); }

TEST(Rounding, ToFloatIsKeptOnTheWayBackToDouble) {
    // Read through volatile, so that the compiler cannot fold constants.
    dvec3 (*volatile round_trip)(const dvec3&) = through_float;
    EXPECT_EQ(round_trip({0.1, 0.2, 0.3}), dvec3(double(0.1f), double(0.2f), double(0.3f)));
}

} // namespace
} // namespace glint::geometry
