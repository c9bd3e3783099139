#pragma once
// What the tests of scene files share.

#include "glint/scene_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
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

/// A fresh folder that goes away with the object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "glint-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string at(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file, with the folders above it; its path.
    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return at(name);
    }

  private:
    std::filesystem::path path_;
};

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
