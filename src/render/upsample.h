#pragma once
// Fills in an image of which only every n-th pixel of each row and column is known.

#include "parallel/task_pool.h"

#include <cstddef>
#include <span>

namespace glint::rendering {

/// The size of an image: rows from the top, pixels from the left, the channels of a pixel together.
struct Layout {
    int width = 0;
    int height = 0;
    int channels = 3;

    std::size_t at(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

/// Fills `out` from the pixels of `known` at multiples of `step`; both have the same layout. `smooth`
/// interpolates linearly between them; otherwise each is copied to the pixels to the right of it and below.
void upsample(std::span<const float> known, const Layout& layout, int step, bool smooth, std::span<float> out,
              parallel::TaskPool& pool);

} // namespace glint::rendering
