#pragma once
// The axis of a picture along which a camera's field of view is measured.

#include "glint/enum_names.h"

namespace glint {

enum class FovAxis { y, x, smaller, larger };
template <>
inline constexpr NamesUpTo<FovAxis::larger> enum_names<FovAxis>{"y", "x", "smaller", "larger"};

/// The side of the picture, in pixels, that the field of view spans.
constexpr double fov_side(FovAxis axis, double width, double height) {
    switch (axis) {
    case FovAxis::x:
        return width;
    case FovAxis::smaller:
        return width < height ? width : height;
    case FovAxis::larger:
        return width > height ? width : height;
    case FovAxis::y:
        break;
    }
    return height;
}

} // namespace glint
