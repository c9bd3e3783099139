#pragma once
// The tables that scene files have besides those of a description: the top, entries of transforms,
// animations.

#include "formats/scene/colors.h"
#include "glint/keys.h"
#include "scene/animation.h"

#include <array>
#include <string>
#include <vector>

namespace glint {

/// The top of the file.
struct FileTop {
    int version = 1;
    ColorValues color_values = ColorValues::srgb;
};

/// An entry of `transform`: one of its members is set, or rotate and angle.
struct TransformEntry {
    Vec3 translate{0};
    Vec3 rotate{0, 0, 1};
    double angle = 0; ///< degrees
    Vec3 scale{1};
    Mat4 matrix{1};
};

/// [animation]
struct AnimationTable {
    std::array<int, 2> frames{}; ///< the first and the last
    double fps = 24;
};

/// [[animate]], without its values
struct AnimateTable {
    std::string key;
    std::vector<double> frames;
    Interpolation interpolation = Interpolation::linear;
    bool loop = false;
};

TableSpec top_table();
TableSpec transform_table();
TableSpec animation_table();
TableSpec animate_table();

} // namespace glint
