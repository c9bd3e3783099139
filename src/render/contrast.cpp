#include "render/contrast.h"

#include <algorithm>

namespace glint::rendering {
namespace {

constexpr float visible_step = 1.0f / 24;

/// √high − √low > step, without roots: high − low − step² > 2 step √low. Below 0 counts as 0.
bool differ(float a, float b) {
    const float low = std::max(0.0f, std::min(a, b));
    const float excess = std::max(a, b) - low - visible_step * visible_step;
    return excess > 0 && excess * excess > 4 * visible_step * visible_step * low;
}

vec3 color_at(const Image& image, int x, int y) {
    const float* pixel = image.at(x, y);
    return {pixel[0], pixel[1], pixel[2]};
}

} // namespace

bool differ(const vec3& a, const vec3& b) { return differ(a.x, b.x) || differ(a.y, b.y) || differ(a.z, b.z); }

std::vector<std::uint8_t> pixels_that_differ(const Image& image, std::span<const float> coverage,
                                             const Rect& among, parallel::TaskPool& pool) {
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(x);
    };
    std::vector<std::uint8_t> found(index(0, image.height));
    pool.run(static_cast<std::size_t>(among.height), [&](std::size_t row, int) {
        const int y = among.y + static_cast<int>(row);
        for (int x = among.x; x < among.x + among.width; ++x)
            for (const Neighbour& n : neighbours) {
                const int nx = x + n.dx, ny = y + n.dy;
                if (nx < 0 || ny < 0 || nx >= image.width || ny >= image.height) continue;
                if (differ(color_at(image, x, y), color_at(image, nx, ny)) ||
                    (!coverage.empty() && differ(coverage[index(x, y)], coverage[index(nx, ny)])))
                    found[index(x, y)] = 1;
            }
    });
    return found;
}

} // namespace glint::rendering
