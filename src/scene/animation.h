#pragma once
// Interpolation of numbers between keyframes.

#include "glint/enum_names.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace glint::scene {

enum class Interpolation { linear, smooth, step };
} // namespace glint::scene

namespace glint {

template <>
inline constexpr NamesUpTo<scene::Interpolation::step> enum_names<scene::Interpolation>{"linear", "smooth",
                                                                                        "step"};

} // namespace glint

namespace glint::scene {

/// Keyframe times and the interpolation between them. linear: piecewise linear. smooth: the monotone cubic of
/// Fritsch and Butland (A method for constructing local monotone piecewise cubic interpolants, 1984):
/// continuous speed, and no value leaves the range of its two keyframes, so values valid at the keyframes are
/// valid between them. Speed is zero at extrema, and at both ends unless the timeline loops. step: the value
/// of the previous keyframe. Before the first and after the last frame their values hold. A loop restarts at
/// the last frame.
struct Timeline {
    std::vector<double> frames; ///< ascending, at least one
    Interpolation interpolation = Interpolation::linear;
    bool loop = false;

    /// The frame clamped to the first and last, or wrapped in a loop.
    double within(double frame) const;
    /// Index of the keyframe at or before a frame, which must be a result of within().
    std::size_t keyframe(double frame) const;
    /// The interpolated value at a frame, a result of within(), where value(i) is that of keyframe i.
    /// Keyframe values are reproduced exactly; only + − × ÷ are used.
    double at(double frame, const std::function<double(std::size_t)>& value) const;

  private:
    double slope(std::size_t segment, const std::function<double(std::size_t)>& value) const;
    double speed(std::size_t key, const std::function<double(std::size_t)>& value) const;
};

} // namespace glint::scene
