#ifndef GLINT_IMAGING_FILTER_SHARED_H
#define GLINT_IMAGING_FILTER_SHARED_H
#include "math/shared.h"

GLINT_SHARED_BEGIN

/// How far from the centre a filter of that radius has the share `tail` of its |f| beyond it, where that lies
/// in one of the `steps` equal steps from the rim inward, with the shares `outer` and `inner` at its two
/// ends.
GLINT_FN float filter_distance(float radius, int step, int steps, float tail, float outer, float inner) {
    float share = (tail - outer) / (inner - outer);
    return radius * (1.0f - (float(step) + share) / float(steps));
}

GLINT_SHARED_END
#endif
