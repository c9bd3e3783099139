#pragma once
// Numbers that move between keyframes.

#include <cstddef>
#include <functional>
#include <vector>

namespace glint {

enum class Interpolation { linear, smooth, step };

/// The frames at which values are known, and the way between them.
///
/// linear: at even speed. smooth: the monotone cubic of Fritsch and Butland (A method for constructing local
/// monotone piecewise cubic interpolants, 1984): the speed has no jumps, and no value leaves the range of its
/// two keyframes, so that what is in order at the keyframes is so between them. It rests where the direction
/// turns, and at both ends unless the timeline loops. step: the value of the keyframe before.
///
/// Before the first frame and after the last one, their values hold. A loop starts again at the last frame.
struct Timeline {
    std::vector<double> frames; ///< ascending, at least one
    Interpolation interpolation = Interpolation::linear;
    bool loop = false;

    /// A frame brought between the first and the last.
    double within(double frame) const;
    /// The keyframe at or before the frame, which is one of within().
    std::size_t keyframe(double frame) const;
    /// The number at the frame, of within(), where value(i) is that of keyframe i. The values of keyframes
    /// come out exactly; only + − × ÷ are used.
    double at(double frame, const std::function<double(std::size_t)>& value) const;

  private:
    double slope(std::size_t segment, const std::function<double(std::size_t)>& value) const;
    double speed(std::size_t key, const std::function<double(std::size_t)>& value) const;
};

} // namespace glint
