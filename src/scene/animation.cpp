// Monotone cubic interpolation.

#include "scene/animation.h"

#include <algorithm>
#include <cmath>

namespace glint::scene {

using Values = std::function<double(std::size_t)>;

double Timeline::within(double frame) const {
    const double first = frames.front(), last = frames.back();
    if (loop && last > first) frame -= std::floor((frame - first) / (last - first)) * (last - first);
    return std::clamp(frame, first, last);
}

std::size_t Timeline::keyframe(double frame) const {
    const auto after = std::upper_bound(frames.begin(), frames.end(), frame);
    const auto key = static_cast<std::size_t>(after - frames.begin());
    return key == 0 ? 0 : key - 1;
}

double Timeline::slope(std::size_t segment, const Values& value) const {
    return (value(segment + 1) - value(segment)) / (frames[segment + 1] - frames[segment]);
}

// Slope at a keyframe: the weighted harmonic mean of the adjacent slopes, 0 if their signs differ.
double Timeline::speed(std::size_t key, const Values& value) const {
    const std::size_t last = frames.size() - 1;
    const bool end = key == 0 || key == last;
    if (end && !loop) return 0;
    const std::size_t before = end ? last - 1 : key - 1;
    const std::size_t after = end ? 0 : key;
    const double slope_before = slope(before, value), slope_after = slope(after, value);
    const bool onward = (slope_before > 0 && slope_after > 0) || (slope_before < 0 && slope_after < 0);
    if (!onward) return 0;
    const double width_before = frames[before + 1] - frames[before];
    const double width_after = frames[after + 1] - frames[after];
    const double weight_before = 2 * width_after + width_before;
    const double weight_after = width_after + 2 * width_before;
    return (weight_before + weight_after) / (weight_before / slope_before + weight_after / slope_after);
}

double Timeline::at(double frame, const Values& value) const {
    const std::size_t key = keyframe(frame);
    const double start = value(key);
    if (interpolation == Interpolation::step || key + 1 == frames.size()) return start;
    const double end = value(key + 1);
    const double width = frames[key + 1] - frames[key];
    const double t = (frame - frames[key]) / width;
    double result = start + (end - start) * t;
    if (interpolation == Interpolation::smooth) {
        const double rest = 1 - t;
        const double bend = speed(key, value) * rest - speed(key + 1, value) * t;
        result = start + (end - start) * (t * t * (3 - 2 * t)) + width * (t * rest * bend);
    }
    // Clamp, as rounding could leave the range.
    return std::clamp(result, std::min(start, end), std::max(start, end));
}

} // namespace glint::scene
