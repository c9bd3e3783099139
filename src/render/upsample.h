#pragma once
// Fills in a picture of which only every n-th pixel of each row and column is known.

#include "glint/image.h"
#include "parallel/task_pool.h"

namespace glint::rendering {

/// Fills `out` from the pixels of `known` at multiples of `step`; both have one size. `smooth` interpolates
/// linearly between them; otherwise each is copied to the pixels to the right of it and below.
void upsample(const Image& known, int step, bool smooth, Image& out, parallel::TaskPool& pool);

} // namespace glint::rendering
