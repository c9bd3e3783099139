#include "times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glint::viewer {
namespace {

constexpr double least_seconds = 1e-4;
constexpr double growth = 1.05;

/// The upper end of a step.
double end_of(std::size_t step) { return least_seconds * std::pow(growth, static_cast<double>(step)); }

std::string milliseconds(double seconds) { return fmt::format("{:.1f} ms", seconds * 1000); }

} // namespace

void FrameTimes::add(double seconds) {
    std::size_t step = 0;
    while (step + 1 < steps && end_of(step) < seconds) ++step;
    ++counts_[step];
    ++count_;
    longest_ = std::max(longest_, seconds);
}

double FrameTimes::within(double share) const {
    std::uint64_t sum = 0;
    for (std::size_t step = 0; step < steps; ++step) {
        sum += counts_[step];
        if (count_ > 0 && static_cast<double>(sum) >= share * static_cast<double>(count_))
            return std::min(end_of(step), longest_);
    }
    return 0;
}

double FrameTimes::share_within(double seconds) const {
    if (count_ == 0) return 1;
    std::uint64_t sum = 0;
    for (std::size_t step = 0; step < steps && std::min(end_of(step), longest_) <= seconds; ++step)
        sum += counts_[step];
    return static_cast<double>(sum) / static_cast<double>(count_);
}

std::string FrameTimes::summary() const {
    if (count_ == 0) return "no frames";
    const double median = within(0.5);
    return fmt::format("{} frames, median {} ({:.1f} a second), 99 % within {}, 99.9 % within {}, longest {}",
                       count_, milliseconds(median), 1 / median, milliseconds(within(0.99)),
                       milliseconds(within(0.999)), milliseconds(longest_));
}

std::string FrameTimes::histogram() const {
    // Eight steps a line: times grow by about a half.
    constexpr std::size_t together = 8;
    constexpr double widest = 50;
    std::string text;
    for (std::size_t first = 0; first < steps; first += together) {
        std::uint64_t sum = 0;
        const std::size_t end = std::min(first + together, steps);
        for (std::size_t step = first; step < end; ++step) sum += counts_[step];
        if (sum == 0) continue;
        const double bar = std::ceil(widest * static_cast<double>(sum) / static_cast<double>(count_));
        text += fmt::format("up to {:>10} {:>8} {}\n", milliseconds(end_of(end - 1)), sum,
                            std::string(static_cast<std::size_t>(bar), '#'));
    }
    return text;
}

} // namespace glint::viewer
