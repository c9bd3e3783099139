#pragma once
// Which pixels differ so much from a neighbour that they get more samples.

#include "glint/image.h"
#include "glint/render.h"
#include "math/vec.h"
#include "parallel/task_pool.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glint::rendering {

/// The pixels that a pixel is compared with, as offsets.
struct Neighbour {
    int dx = 0;
    int dy = 0;
};
inline constexpr std::array<Neighbour, 4> neighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// True if two colours differ by more than 1/24 in a channel on a scale of square roots, which is about that
/// of displays: 11 of 255.
bool differ(const vec3& a, const vec3& b);

/// By pixel of the image: 1 if it lies in `among` and its colour or coverage (none: empty) differs from that
/// of a neighbour.
std::vector<std::uint8_t> pixels_that_differ(const Image& image, std::span<const float> coverage,
                                             const Rect& among, parallel::TaskPool& pool);

} // namespace glint::rendering
