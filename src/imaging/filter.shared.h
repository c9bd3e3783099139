#ifndef GLINT_IMAGING_FILTER_SHARED_H
#define GLINT_IMAGING_FILTER_SHARED_H
#include "math/shared.h"

// The pixel filter as a table of its tails: the share of |f| beyond a distance of radius · (1 − i /
// filter_steps), for i = 0 … filter_steps.

GLINT_SHARED_BEGIN

/// A multiple of 14, so that steps of Mitchell's filter end at 1 (where its pieces meet) and at 8/7 (where
/// its sign changes).
const int filter_steps = 896;

/// The share of |f| beyond the offset that u in [0, 1) stands for. Both halves share one table; twice the
/// distance to the nearer end of [0, 1) is exact.
GLINT_FN float filter_tail(float u) { return u < 0.5f ? 2.0f * u : 2.0f - 2.0f * u; }

/// An offset along one axis, in pixels from the pixel's centre, and what the sample counts: +1, or −1 where
/// the filter is negative.
struct FilterOffset {
    float distance_to;
    float weight;
};

/// The offset that u stands for, where filter_tail(u) lies in the table's given step, between the shares
/// `outer` and `inner` at its two ends. The filter is below 0 on the outermost `negative_steps`.
GLINT_FN FilterOffset filter_offset(float u, float radius, int step, int negative_steps, float outer,
                                    float inner) {
    float share = (filter_tail(u) - outer) / (inner - outer);
    float distance_to = radius * (1.0f - (float(step) + share) / float(filter_steps));
    FilterOffset offset;
    offset.distance_to = u < 0.5f ? -distance_to : distance_to;
    offset.weight = step < negative_steps ? -1.0f : 1.0f;
    return offset;
}

GLINT_SHARED_END
#endif
