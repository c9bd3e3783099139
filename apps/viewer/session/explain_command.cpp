// Builds the command line from the file, its unsaved changes and the camera of the question.
#include "explain_command.h"

#include "camera.h"

#include "glint/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace glint::viewer {
namespace {

/// Of the preview scene of a bare mesh, -D can set only these tables.
bool can_override_preview(const std::string& path) {
    constexpr std::array<std::string_view, 5> tables{"render.", "whitted.", "camera.", "material.clay.",
                                                     "material.floor."};
    return std::any_of(tables.begin(), tables.end(), [&](auto table) { return path.starts_with(table); });
}

std::string path_of(const Override& change) { return change.substr(0, change.find('=')); }

/// Adds a camera as values for -D. `has_look_at`: the file has the key look_at instead of direction.
void add_camera(const CameraDescription& camera, bool has_look_at, std::vector<Override>& values) {
    values.push_back("camera.eye=" + scene_value(camera.eye));
    values.push_back(has_look_at ? "camera.look_at=" + scene_value(camera.eye + camera.direction)
                                 : "camera.direction=" + scene_value(camera.direction));
    values.push_back("camera.up=" + scene_value(camera.up));
    values.push_back("camera.fov=" + scene_value(camera.fov));
    values.push_back("camera.fov_axis=" + std::string(name_of(camera.fov_axis)));
}

/// Adds the unsaved changes and the camera of the question.
void add_changes(const ShownFile& shown, const PixelQuestion& question, ExplainCommand& command) {
    const bool is_mesh = !is_scene_file(shown.file);
    const bool has_camera = !is_mesh && shown.document && shown.document->value("camera.eye");
    const bool is_home =
        has_camera && shown.description.camera && same_view(*shown.description.camera, question.camera);
    for (const Override& change : shown.document ? shown.document->changes() : std::vector<Override>()) {
        const std::string path = path_of(change);
        // --frame sets animated values; -D would override them.
        const bool is_animated =
            std::find(shown.animated.begin(), shown.animated.end(), path) != shown.animated.end();
        if (command.frame && is_animated) continue;
        if (!is_home && path.starts_with("camera.")) continue;
        if (is_mesh && !can_override_preview(path))
            command.limitation =
                "\"" + path + "\" of a bare mesh cannot be given: save the scene with Ctrl+S first";
        else
            command.load.overrides.push_back(change);
    }
    if (!is_home)
        add_camera(question.camera, has_camera && shown.document->value("camera.look_at"),
                   command.load.overrides);
}

std::string command_line(const ExplainCommand& command, const PixelQuestion& question) {
    std::string line =
        "glint explain " + quoted(std::filesystem::absolute(command.file).lexically_normal().string());
    line +=
        fmt::format(" --size {}x{} --pixel {},{}", question.width, question.height, question.x, question.y);
    if (command.frame) line += fmt::format(" --frame {}", *command.frame);
    if (!is_scene_file(command.file) && command.load.up)
        line += std::string(" --up ") + std::string(name_of(*command.load.up));
    if (command.load.allow_outside) line += " --allow-outside";
    for (const Override& value : command.load.overrides) line += " -D " + quoted(value);
    return line;
}

} // namespace

bool is_scene_file(const std::string& file) { return std::filesystem::path(file).extension() == ".toml"; }

std::string quoted(const std::string& argument) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
    std::string text = "'";
    for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

ExplainCommand explain_command(const ShownFile& shown, const PixelQuestion& question) {
    ExplainCommand command;
    command.file = shown.file;
    command.load = shown.load;
    command.load.progress = {};
    command.load.overrides.clear();
    // Those of a preview scene are in its document from the start.
    if (!is_scene_file(shown.file)) command.load.overrides = shown.load.overrides;
    if (shown.frame) {
        command.frame = static_cast<int>(std::lround(*shown.frame));
        if (*command.frame != *shown.frame)
            command.limitation = "it stands between two frames, and --frame takes whole ones";
    }
    add_changes(shown, question, command);
    command.line = command_line(command, question);
    return command;
}

void check(ExplainCommand& command, const ShownFile& shown) {
    // The preview scene of a bare mesh depends on the mesh.
    if (!command.limitation.empty() || !is_scene_file(command.file)) return;
    try {
        LoadOptions load = command.load;
        load.load_meshes = false;
        const LoadedScene loaded = load_scene(command.file, load);
        const SceneDescription read = command.frame ? scene_at(loaded, *command.frame) : loaded.description;
        SceneDescription expected = shown.description;
        // Camera and size are those of the question.
        expected.camera = read.camera;
        expected.render.width = read.render.width;
        expected.render.height = read.render.height;
        if (scene_text(read) != scene_text(expected))
            command.limitation =
                "the file is not the one that the changes were made to: save it with Ctrl+S first";
    } catch (const Error& error) {
        command.limitation = error.diagnostics().front().message;
    }
}

} // namespace glint::viewer
