// The equations of quadrics and planes for vectors of rays, for every SIMD target: the same text as for one
// ray, read once more in the vocabulary of math/double_lanes-inl.h.

#include "geometry/quadric.shared.h"

#include <hwy/highway.h>

#include "math/double_lanes-inl.h"

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

// Without its guard it is read again.
#undef GLINT_GEOMETRY_QUADRIC_SHARED_H

HWY_BEFORE_NAMESPACE();
#include "geometry/quadric.shared.h"
HWY_AFTER_NAMESPACE();

#undef GLINT_LANES
#pragma pop_macro("GLINT_SHARED_BEGIN")
#pragma pop_macro("GLINT_SHARED_END")
#pragma pop_macro("GLINT_FN")

#endif
