#pragma once
// Scenes that together show every kind of object, light and material, for promises that hold for all scenes.

#include "glint/scene.h"

#include <ostream>
#include <string>
#include <vector>

namespace glint::kit {

struct Exhibit {
    std::string name; ///< one word
    SceneDescription scene;

    friend void PrintTo(const Exhibit& exhibit, std::ostream* out) { *out << exhibit.name; } // for GoogleTest
};

/// At least twelve scenes, small pictures, one sample a pixel.
std::vector<Exhibit> gallery();

} // namespace glint::kit
