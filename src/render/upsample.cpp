#include "render/upsample.h"

#include <algorithm>
#include <vector>

namespace glint::rendering {
namespace {

/// The known coordinate at or before x, the next one, and how far x is between them.
struct Between {
    int before;
    int after;
    float share;

    Between(int x, int step, int size)
        : before(x / step * step), after(before + step < size ? before + step : before),
          share(static_cast<float>(x - before) / static_cast<float>(step)) {}
};

/// Exact at both ends, where the other value may be infinite.
float mixed(float a, float b, float share) { return share == 0.0f ? a : a + (b - a) * share; }

/// What upsample() is given.
struct Upsampling {
    std::span<const float> known;
    Layout layout;
    int step;
    std::span<float> out;
    std::vector<float> shares; ///< k / step for k = 0 … step − 1

    void copy_row(int y) const {
        const auto channels = static_cast<std::size_t>(layout.channels);
        for (int x = 0; x < layout.width; ++x)
            std::copy_n(&known[layout.at(x / step * step, y / step * step)], channels, &out[layout.at(x, y)]);
    }

    void interpolate_row(int y) const {
        const int channels = layout.channels;
        const Between rows(y, step, layout.height);
        // Down first, at the known columns, then along the row.
        for (int x = 0; x < layout.width; x += step) {
            const float* before = &known[layout.at(x, rows.before)];
            const float* after = &known[layout.at(x, rows.after)];
            float* pixel = &out[layout.at(x, y)];
            for (int c = 0; c < channels; ++c) pixel[c] = mixed(before[c], after[c], rows.share);
        }
        for (int x = 0; x < layout.width; x += step) {
            float* pixel = &out[layout.at(x, y)];
            const float* after = x + step < layout.width ? pixel + channels * step : pixel;
            const int end = std::min(step, layout.width - x);
            for (int k = 1; k < end; ++k)
                for (int c = 0; c < channels; ++c)
                    pixel[channels * k + c] = mixed(pixel[c], after[c], shares[static_cast<std::size_t>(k)]);
        }
    }
};

} // namespace

void upsample(std::span<const float> known, const Layout& layout, int step, bool smooth, std::span<float> out,
              parallel::TaskPool& pool) {
    constexpr int rows_per_task = 32;
    Upsampling upsampling{known, layout, step, out, {}};
    for (int k = 0; k < step; ++k)
        upsampling.shares.push_back(static_cast<float>(k) / static_cast<float>(step));
    const int tasks = (layout.height + rows_per_task - 1) / rows_per_task;
    pool.run(static_cast<std::size_t>(tasks), [&](std::size_t task, int) {
        const int first = static_cast<int>(task) * rows_per_task;
        for (int y = first; y < std::min(first + rows_per_task, layout.height); ++y)
            smooth ? upsampling.interpolate_row(y) : upsampling.copy_row(y);
    });
}

} // namespace glint::rendering
