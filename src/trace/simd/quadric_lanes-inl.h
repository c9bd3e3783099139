// The equations of quadrics and planes for vectors of rays, for every SIMD target: the shared header compiled
// again with the types of math/lanes-inl.h.

#include "geometry/quadric.shared.h"

#include <hwy/highway.h>

#include "math/lanes-inl.h"

#if defined(GLINT_TRACE_SIMD_QUADRIC_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SIMD_QUADRIC_LANES_INL_H
#undef GLINT_TRACE_SIMD_QUADRIC_LANES_INL_H
#else
#define GLINT_TRACE_SIMD_QUADRIC_LANES_INL_H
#endif

#pragma push_macro("GLINT_SHARED_BEGIN")
#pragma push_macro("GLINT_SHARED_END")
#pragma push_macro("GLINT_FN")
#undef GLINT_SHARED_BEGIN
#undef GLINT_SHARED_END
#undef GLINT_FN
#define GLINT_SHARED_BEGIN namespace glint::HWY_NAMESPACE::double_lanes {
#define GLINT_SHARED_END }
#define GLINT_FN HWY_INLINE
#define GLINT_LANES

// Without its guard it is included again.
#undef GLINT_GEOMETRY_QUADRIC_SHARED_H

HWY_BEFORE_NAMESPACE();
#include "geometry/quadric.shared.h"
HWY_AFTER_NAMESPACE();

#undef GLINT_LANES
#pragma pop_macro("GLINT_SHARED_BEGIN")
#pragma pop_macro("GLINT_SHARED_END")
#pragma pop_macro("GLINT_FN")

#endif
