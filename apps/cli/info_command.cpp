#include "backend.h"
#include "commands.h"
#include "frames.h"
#include "json_output.h"
#include "scene_input.h"
#include "text.h"

#include "glint/keys.h"
#include "glint/limits.h"
#include "glint/render.h"
#include "glint/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace glint::cli {
namespace {

std::string row(const char* label, const std::string& text) {
    return fmt::format("  {:<11}{}\n", label, text);
}

std::string point(const Vec3& v, int digits = 6) {
    return fmt::format("({0:.{3}g}, {1:.{3}g}, {2:.{3}g})", v.x, v.y, v.z, digits);
}

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Digits of positions: six of the scene's size, and those that the scene lies farther out.
int position_digits(const SceneStats& stats) {
    const double size = largest(stats.bounds_max - stats.bounds_min);
    int digits = 6;
    for (double far = largest(stats.bounds_max); size > 0 && far > 10 * size && digits < 15; far /= 10)
        ++digits;
    return digits;
}

/// "2 planes, 1 mesh": how many items there are of each kind. `kind_of` gives the index of an item's kind.
template <class Item, class Names>
std::string counts_text(const std::vector<Item>& items, std::size_t (*kind_of)(const Item&),
                        const Names& names, const Names& plurals) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto is_one = [&](const Item& item) { return kind_of(item) == i; };
        const auto count = static_cast<std::uint64_t>(std::count_if(items.begin(), items.end(), is_one));
        if (count > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", with_commas(count),
                                count > 1 ? plurals[i] : names[i]);
    }
    return text.empty() ? "none" : text;
}

std::size_t shape_index(const Object& object) { return object.shape.index(); }
std::size_t light_index(const Light& light) { return light.kind.index(); }

/// A value with six digits.
std::string shown(const KeySpec& key, const KeyValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
    if (const auto* vector = std::get_if<Vec3>(&value)) return point(*vector);
    return plain_text(key, value);
}

/// What sets a material apart; the usual values go without saying.
std::string properties(const Material& material) {
    std::string text;
    for (const KeySpec& key : description_table("material").keys) {
        if (!key.belongs_to(name_of(material.model))) continue;
        const KeyValue value = key.get(KeyOwner(material));
        if (std::holds_alternative<std::monostate>(value)) continue;
        const bool tells = key.key == "color" || (key.key == "index" && is_transparent(material));
        if (!tells && key.initial && value == key.initial()) continue;
        text += (text.empty() ? "" : ", ") + std::string(key.key);
        if (key.type != KeyType::boolean) text += " " + shown(key, value);
    }
    return text;
}

std::string geometry_rows(const SceneStats& stats) {
    const bool bounded = stats.bounds_min.x <= stats.bounds_max.x;
    std::string text = row("triangles", with_commas(stats.triangles));
    const int digits = position_digits(stats);
    text += row("bounds", bounded ? point(stats.bounds_min, digits) + " to " + point(stats.bounds_max, digits)
                                  : "nothing finite");
    text += row("tree", fmt::format("{}, depth {}", counted(stats.tree_nodes, "node"), stats.tree_depth));
    return text + row("memory", bytes_text(static_cast<double>(stats.bytes)));
}

std::string info_text(const std::string& file, const SceneDescription& description, const Scene& scene) {
    std::string text = printable(file) + "\n";
    text += row("objects", counts_text(description.objects, shape_index, shape_names, shape_plurals));
    text += row("lights", counts_text(description.lights, light_index, light_names, light_names));
    text += geometry_rows(scene.stats());
    const CameraDescription& camera = scene.camera();
    text +=
        row("camera", fmt::format("eye {}, direction {}, fov {:.6g}°{}",
                                  point(camera.eye, position_digits(scene.stats())), point(camera.direction),
                                  camera.fov, description.camera ? "" : " (framed)"));
    text += "materials\n";
    for (const Material& material : description.materials)
        text += fmt::format("  {:<11}{}\n", printable(material.name), " " + properties(material));
    text += "picture settings\n";
    for (const auto& setting : picture_settings(scene))
        text += fmt::format("  {:<18}{}\n", setting_name(setting.first), setting.second);
    return text;
}

} // namespace

int info_command(const Arguments& arguments, Console& console) {
    if (arguments.has("devices")) {
        if (!arguments.operands().empty())
            throw Error(ErrorKind::usage, "--devices takes no file", "glint info --devices");
        print_data(arguments.has("json") ? devices_json() : devices_text());
        return exit_code::done;
    }
    const std::string& file = arguments.operands().front();
    const LoadedScene loaded = read_scene(file, load_options(arguments));
    report(loaded, console);
    const SceneDescription description = at_frame(arguments, loaded);
    BuildSceneOptions how;
    how.threads = threads(arguments);
    const Scene scene = build_scene(description, how);
    console.warnings(warnings(scene));
    print_data(arguments.has("json") ? info_json(file, description, scene)
                                     : info_text(file, description, scene));
    return exit_code::done;
}

} // namespace glint::cli
