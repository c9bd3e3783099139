// Bins, quantiles and texts of frame times.
#include "times.h"

#include "clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

constexpr double min_seconds = 1e-4;
constexpr double growth = 1.05;

/// The camera counts as moving for this long after its last movement.
constexpr double moving_seconds = 0.1;
/// Longer pauses between pictures are not part of a movement.
constexpr double max_pause = 0.5;

/// The upper end of a bin.
double end_of(std::size_t bin) { return min_seconds * std::pow(growth, static_cast<double>(bin)); }

std::string milliseconds(double seconds) { return fmt::format("{:.1f} ms", seconds * 1000); }

} // namespace

void FrameTimes::add(double seconds) {
    std::size_t bin = 0;
    while (bin + 1 < bins && end_of(bin) < seconds) ++bin;
    ++counts_[bin];
    ++count_;
    longest_ = std::max(longest_, seconds);
}

double FrameTimes::quantile(double share) const {
    std::uint64_t sum = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        sum += counts_[bin];
        if (count_ > 0 && static_cast<double>(sum) >= share * static_cast<double>(count_))
            return std::min(end_of(bin), longest_);
    }
    return 0;
}

std::string FrameTimes::summary() const {
    if (count_ == 0) return "no frames";
    const double median = quantile(0.5);
    return fmt::format("{} frames, median {} ({:.1f} a second), 99 % within {}, 99.9 % within {}, longest {}",
                       count_, milliseconds(median), 1 / median, milliseconds(quantile(0.99)),
                       milliseconds(quantile(0.999)), milliseconds(longest_));
}

std::string FrameTimes::histogram() const {
    // Eight bins a line: the time grows by about a half from line to line.
    constexpr std::size_t bins_per_line = 8;
    constexpr double max_bar = 50;
    std::string text;
    for (std::size_t first = 0; first < bins; first += bins_per_line) {
        std::uint64_t sum = 0;
        const std::size_t end = std::min(first + bins_per_line, bins);
        for (std::size_t bin = first; bin < end; ++bin) sum += counts_[bin];
        if (sum == 0) continue;
        const double bar = std::ceil(max_bar * static_cast<double>(sum) / static_cast<double>(count_));
        text += fmt::format("up to {:>10} {:>8} {}\n", milliseconds(end_of(end - 1)), sum,
                            std::string(static_cast<std::size_t>(bar), '#'));
    }
    return text;
}

void Statistics::frame_drawn(double seconds, double last_move) {
    frames_.add(seconds);
    if (now() - seconds - last_move < moving_seconds) moving_frames_.add(seconds);
}

void Statistics::picture_shown(double last_move) {
    const double time = now();
    if (time - last_move < moving_seconds && time - last_picture_ < max_pause)
        pictures_.add(time - last_picture_);
    last_picture_ = time;
}

std::string Statistics::text() const {
    std::string text = "window: " + frames_.summary() + "\n" + frames_.histogram();
    if (moving_frames_.count() > 0)
        text +=
            "window while the camera moved: " + moving_frames_.summary() + "\n" + moving_frames_.histogram();
    if (pictures_.count() > 0)
        text += "pictures while the camera moved: " + pictures_.summary() + "\n" + pictures_.histogram();
    return text;
}

} // namespace glint::viewer
