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

void fill_row_from_blocks(const Image& known, int step, int y, Image& out) {
    for (int x = 0; x < out.width; ++x) {
        const float* source = known.at(x / step * step, y / step * step);
        std::copy(source, source + 3, out.at(x, y));
    }
}

/// `shares` holds k / step.
void fill_row_smoothly(const Image& known, int step, const std::vector<float>& shares, int y, Image& out) {
    const Between rows(y, step, known.height);
    // Down first, at the known columns, then along the row.
    for (int x = 0; x < out.width; x += step)
        for (int c = 0; c < 3; ++c)
            out.at(x, y)[c] = mixed(known.at(x, rows.before)[c], known.at(x, rows.after)[c], rows.share);
    for (int x = 0; x < out.width; x += step) {
        float* pixel = out.at(x, y);
        const float* after = x + step < out.width ? pixel + 3 * step : pixel;
        const int end = std::min(step, out.width - x);
        for (int k = 1; k < end; ++k)
            for (int c = 0; c < 3; ++c)
                pixel[3 * k + c] = mixed(pixel[c], after[c], shares[static_cast<std::size_t>(k)]);
    }
}

} // namespace

void upsample(const Image& known, int step, bool smooth, Image& out, parallel::TaskPool& pool) {
    constexpr int rows_per_task = 32;
    std::vector<float> shares(static_cast<std::size_t>(step));
    for (int k = 0; k < step; ++k)
        shares[static_cast<std::size_t>(k)] = static_cast<float>(k) / static_cast<float>(step);
    const int tasks = (out.height + rows_per_task - 1) / rows_per_task;
    pool.run(static_cast<std::size_t>(tasks), [&](std::size_t task, int) {
        const int first = static_cast<int>(task) * rows_per_task;
        for (int y = first; y < std::min(first + rows_per_task, out.height); ++y)
            smooth ? fill_row_smoothly(known, step, shares, y, out)
                   : fill_row_from_blocks(known, step, y, out);
    });
}

} // namespace glint::rendering
