// The shared headers for vectors of rays, for every SIMD target: the same text as for one ray, read once more
// in the vocabulary of math/lanes-inl.h.

#include "shading/whitted.shared.h"

#include <hwy/highway.h>

#include "math/lanes-inl.h"

#if defined(GLINT_SHADING_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SHADING_LANES_INL_H
#undef GLINT_SHADING_LANES_INL_H
#else
#define GLINT_SHADING_LANES_INL_H
#endif

#pragma push_macro("GLINT_SHARED_BEGIN")
#pragma push_macro("GLINT_SHARED_END")
#pragma push_macro("GLINT_FN")
#undef GLINT_SHARED_BEGIN
#undef GLINT_SHARED_END
#undef GLINT_FN
#define GLINT_SHARED_BEGIN namespace glint::HWY_NAMESPACE::lanes {
#define GLINT_SHARED_END }
#define GLINT_FN HWY_INLINE
#define GLINT_LANES

// Without their guards they are read again.
#undef GLINT_MATH_OFFSET_SHARED_H
#undef GLINT_MATH_ELEMENTARY_SHARED_H
#undef GLINT_SHADING_RECORDS_SHARED_H
#undef GLINT_SHADING_WHITTED_SHARED_H

HWY_BEFORE_NAMESPACE();
#include "shading/whitted.shared.h"
HWY_AFTER_NAMESPACE();

#undef GLINT_LANES

#pragma pop_macro("GLINT_SHARED_BEGIN")
#pragma pop_macro("GLINT_SHARED_END")
#pragma pop_macro("GLINT_FN")

#endif
