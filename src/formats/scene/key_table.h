#pragma once
// All tables of scene files: those of a description, and those of files alone.

#include "formats/scene/colors.h"
#include "glint/keys.h"
#include "scene/animation.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace glint::formats {

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
    scene::Interpolation interpolation = scene::Interpolation::linear;
    bool loop = false;
};

/// All tables, in the order of the reference page.
const std::vector<TableSpec>& table_specs();

/// The table with that name; null if there is none. The name of the file itself is "".
const TableSpec* find_table(std::string_view name);

/// The names of all tables that a file may have.
std::vector<std::string> table_names();

/// The keys of a table of that type, in the order of the reference page.
std::vector<std::string> key_names(const TableSpec& table, std::string_view type);

/// The choices of a key.
std::vector<std::string> choice_names(const KeySpec& key);

} // namespace glint::formats
