#include "explain_command.h"

#include "camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace glint::viewer {
namespace {

bool is_scene_file(const std::string& file) { return std::filesystem::path(file).extension() == ".toml"; }

/// A bare mesh stands on a stage of which not everything has a name for -D.
bool is_for_a_mesh(const std::string& path) {
    constexpr std::array<std::string_view, 5> open{"render.", "whitted.", "camera.", "material.clay.",
                                                   "material.floor."};
    return std::any_of(open.begin(), open.end(), [&](auto start) { return path.starts_with(start); });
}

std::string path_of(const Override& change) { return change.substr(0, change.find('=')); }

/// The camera of a question as values for -D. Of where it looks a file has one of two keys.
void add_camera(const CameraDescription& camera, bool looks_at, std::vector<Override>& values) {
    constexpr std::array axes{"y", "x", "smaller", "larger"};
    values.push_back("camera.eye=" + scene_value(camera.eye));
    values.push_back(looks_at ? "camera.look_at=" + scene_value(camera.eye + camera.direction)
                              : "camera.direction=" + scene_value(camera.direction));
    values.push_back("camera.up=" + scene_value(camera.up));
    values.push_back("camera.fov=" + scene_value(camera.fov));
    values.push_back(std::string("camera.fov_axis=") + axes[static_cast<std::size_t>(camera.fov_axis)]);
}

} // namespace

std::string quoted(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

ExplainCommand explain_command(const ShownFile& shown, const PixelQuestion& question) {
    ExplainCommand command;
    command.file = shown.file;
    command.load = shown.load;
    command.load.progress = {};
    command.load.overrides.clear();
    const bool is_mesh = !is_scene_file(shown.file);
    // Those of a mesh's stage are in its document from the start.
    if (is_mesh) command.load.overrides = shown.load.overrides;
    if (shown.frame) {
        command.frame = static_cast<int>(std::lround(*shown.frame));
        if (*command.frame != *shown.frame)
            command.lacks = "it stands between two frames, and --frame takes whole ones";
    }
    const bool has_camera = !is_mesh && shown.document && shown.document->value("camera.eye");
    const bool is_home =
        has_camera && shown.description.camera && same_view(*shown.description.camera, question.camera);
    for (const Override& change : shown.document ? shown.document->changes() : std::vector<Override>()) {
        const std::string path = path_of(change);
        // What moves is where the frame has it: -D would hold it still.
        const bool moves = std::find(shown.moving.begin(), shown.moving.end(), path) != shown.moving.end();
        if (command.frame && moves) continue;
        if (!is_home && path.starts_with("camera.")) continue;
        if (is_mesh && !is_for_a_mesh(path))
            command.lacks =
                "\"" + path + "\" of a bare mesh cannot be given: save the scene with Ctrl+S first";
        else
            command.load.overrides.push_back(change);
    }
    if (!is_home)
        add_camera(question.camera, has_camera && shown.document->value("camera.look_at"),
                   command.load.overrides);

    command.line =
        "glint explain " + quoted(std::filesystem::absolute(shown.file).lexically_normal().string());
    command.line +=
        fmt::format(" --size {}x{} --pixel {},{}", question.width, question.height, question.x, question.y);
    if (command.frame) command.line += fmt::format(" --frame {}", *command.frame);
    if (is_mesh && command.load.up)
        command.line += std::string(" --up ") + (*command.load.up == Axis::y ? "y" : "z");
    if (command.load.allow_outside) command.line += " --allow-outside";
    for (const Override& value : command.load.overrides) command.line += " -D " + quoted(value);
    return command;
}

void check(ExplainCommand& command, const ShownFile& shown) {
    // A mesh's stage cannot be had without reading the mesh.
    if (!command.lacks.empty() || !is_scene_file(command.file)) return;
    try {
        LoadOptions load = command.load;
        load.load_meshes = false;
        const LoadedScene loaded = load_scene(command.file, load);
        SceneDescription there = command.frame ? scene_at(loaded, *command.frame) : loaded.description;
        SceneDescription here = shown.description;
        // These the question has.
        here.camera = there.camera;
        here.render.width = there.render.width;
        here.render.height = there.render.height;
        if (scene_text(there) != scene_text(here))
            command.lacks =
                "the file is not the one that the changes were made to: save it with Ctrl+S first";
    } catch (const Error& error) {
        command.lacks = error.diagnostics().front().message;
    }
}

} // namespace glint::viewer
