#pragma once
// A picture of which only every so-many-th pixel is known, filled in.

#include "glint/image.h"
#include "parallel/task_pool.h"

namespace glint {

/// Fills `out` from the pixels of `known` at multiples of `step`; both have one size. `smooth` interpolates
/// linearly between them, else each stands for those to the right of it and below.
void upsample(const Image& known, int step, bool smooth, Image& out, TaskPool& pool);

} // namespace glint
