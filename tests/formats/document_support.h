#pragma once
// What the tests of scene documents share.

#include "glint/document.h"
#include "scene_support.h"

namespace glint::test {

inline std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// What a text says, in one form: what is written anew from its description.
inline std::string meaning(const std::string& text, std::vector<Override> overrides = {}) {
    LoadOptions options;
    options.overrides = std::move(overrides);
    options.load_meshes = false;
    options.allow_outside = true;
    return scene_text(parse_scene(text, "scenes/a.toml", options).description);
}

inline SceneDocument document(const std::string& text) { return {text, "scenes/a.toml"}; }

// Every way of writing a table, with comments, blanks and line ends that must survive.
inline constexpr const char* odd_scene = R"(# A scene.
#   Written by hand.
version=1 # the only one

whitted . max_depth = 3  # dotted
whitted."clamp" = false
camera = {eye=[0,-9, 2], look_at = [ 0,0 , 0 ],fov = 30 } # braces

  [render]   # indented
    size = [ 64,
             48 ] # over lines
    # spp stays the default

[material]
red.color = "crimson"
red.diffuse = 0.50
glass = { index = 1.50, transparency = 1 }
plain = {}
[material."a.b"]

[[sphere]]
name = "ball"
center=[0,0,0]
radius =+1.0
material = "red"
transform = [
    { translate = [1, 0, 0] }, # aside
    { rotate = [0,0,1], angle = 30 },
]

[[light]]	# with a tab
type = 'point'
position = [ 3, -4, 5]
intensity = 4_0

[[light]]
type = "ambient"

[[plane]]
normal = [0, 0, 1]
material = "a.b")";

} // namespace glint::test
