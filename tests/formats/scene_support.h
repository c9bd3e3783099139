#pragma once
// What the tests of scene files share.

#include "../kit/temporary_folder.h"

#include "glint/scene_files.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glint::test {

/// parse_scene() of "scenes/a.toml".
inline LoadedScene parse(std::string_view text, std::vector<Override> overrides = {}) {
    LoadOptions options;
    options.overrides = std::move(overrides);
    options.load_meshes = false;
    return parse_scene(text, "scenes/a.toml", options);
}

/// The errors of parsing; none where it succeeds.
inline std::vector<Diagnostic> errors_of(std::string_view text, std::vector<Override> overrides = {}) {
    try {
        parse(text, std::move(overrides));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        return error.diagnostics();
    }
    return {};
}

/// A scene with one material "m" before the given text.
inline std::string with_material(const std::string& text) { return "[material.m]\n" + text; }

/// The only object of a scene, its shape, its only light: of the kind asked for.
inline const Object& only_object(const LoadedScene& scene) {
    EXPECT_EQ(scene.description.objects.size(), 1u);
    return scene.description.objects.front();
}

template <class Shape>
const Shape& only_shape(const LoadedScene& scene) {
    return std::get<Shape>(only_object(scene).shape);
}

template <class Kind>
const Kind& only_light(const LoadedScene& scene) {
    EXPECT_EQ(scene.description.lights.size(), 1u);
    return std::get<Kind>(scene.description.lights.front().kind);
}

} // namespace glint::test
