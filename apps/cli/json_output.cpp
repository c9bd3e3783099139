#include "json_output.h"

#include "text.h"

#include "glint/gpu.h"
#include "glint/keys.h"

#include <nlohmann/json.hpp>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json scene_json(const SceneStats& stats) {
    Json json{{"objects", stats.objects}, {"triangles", stats.triangles}};
    for (const PrimitiveCount& quadric : stats.quadrics) json[quadric.kind] = quadric.count;
    json.update({{"planes", stats.planes},
                 {"lights", stats.lights},
                 {"tree_nodes", stats.tree_nodes},
                 {"tree_depth", stats.tree_depth},
                 {"tree_quality", stats.tree_quality},
                 {"bytes", stats.bytes}});
    // Where there is nothing finite, there are no bounds.
    if (stats.bounds_min.x <= stats.bounds_max.x) {
        json["bounds_min"] = vector_json(stats.bounds_min);
        json["bounds_max"] = vector_json(stats.bounds_max);
    }
    return json;
}

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;

/// Numbers, booleans and lists as such, everything else as text.
Json value_json(const KeySpec& key, const KeyValue& value) {
    return std::visit(
        [&]<class T>(const T& held) -> Json {
            if constexpr (std::is_arithmetic_v<T>) return held;
            if constexpr (std::is_same_v<T, Vec3>) return vector_json(held);
            if constexpr (std::is_same_v<T, std::array<int, 2>>) return held;
            if constexpr (is_optional<T>)
                if (held) return *held;
            return plain_text(key, value);
        },
        value);
}

/// The settings that decide a picture.
Json settings_json(const Scene& scene) {
    Json json{{"version", version()}};
    const auto add = [&](const char* table, const KeyOwner& owner) {
        for (const KeySpec& key : description_table(table).keys)
            if (key.in_metadata) json[std::string(key.key)] = value_json(key, key.get(owner));
    };
    add("render", KeyOwner(scene.description().render));
    add("whitted", KeyOwner(scene.description().whitted));
    return json;
}

Json material_json(const Material& material) {
    Json json{{"name", material.name}};
    for (const KeySpec& key : description_table("material").keys)
        json[std::string(key.key)] = value_json(key, key.get(KeyOwner(material)));
    return json;
}

Json diagnostics_json(const std::vector<Diagnostic>& diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& d : diagnostics) {
        Json json{{"message", d.message}, {"hint", d.hint}, {"file", d.location.file}};
        if (d.location.line > 0) json.update({{"line", d.location.line}, {"column", d.location.column}});
        if (d.location.byte) json["byte"] = *d.location.byte;
        list.push_back(std::move(json));
    }
    return list;
}

/// Names of files may hold any bytes; those that are not UTF-8 are replaced.
std::string document(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

double samples_per_pixel(const Picture& picture) {
    return double(picture.stats.primary_rays) / (double(picture.image.width) * picture.image.height);
}

std::string stats_json(const RenderRecord& record, const Scene& scene, const Picture& picture) {
    const RenderStats& stats = picture.stats;
    const double total =
        record.load_seconds + record.build_seconds + stats.wall_seconds + record.write_seconds;
    Json json{{"glint", version()}, {"file", record.scene}, {"output", record.output}};
    if (record.frame) json["frame"] = *record.frame;
    json.update(Json{
        {"device", record.device.empty() ? "cpu" : record.device},
        {"complete", picture.complete},
        {"fraction", record.fraction},
        {"width", picture.image.width},
        {"height", picture.image.height},
        {"hash", record.hash},
        {"scene", scene_json(scene.stats())},
        {"settings", settings_json(scene)},
        {"samples_per_pixel", samples_per_pixel(picture)},
        {"rays",
         {{"primary", stats.primary_rays},
          {"reflected", stats.reflected_rays},
          {"refracted", stats.refracted_rays},
          {"shadow", stats.shadow_rays},
          {"total", stats.rays()}}},
        {"left_out", {{"rays", stats.left_out_rays}, {"share", left_out_share(stats, scene)}}},
        {"seconds",
         {{"load", record.load_seconds},
          {"build", record.build_seconds},
          {"render", stats.wall_seconds},
          {"render_cpu", stats.cpu_seconds},
          {"write", record.write_seconds},
          {"total", total}}},
        {"mrays_per_second", mega_rays(stats.rays(), stats.wall_seconds)},
        {"threads", stats.threads},
    });
    return document(json);
}

std::string picture_event_json(const RenderRecord& record, const Picture& picture) {
    const Json json{{"event", "picture"},
                    {"output", record.output},
                    {"complete", picture.complete},
                    {"width", picture.image.width},
                    {"height", picture.image.height},
                    {"rays", picture.stats.rays()},
                    {"seconds", picture.stats.wall_seconds},
                    {"hash", record.hash}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string stats_list_json(const std::vector<std::string>& documents) {
    Json list = Json::array();
    for (const std::string& each : documents) list.push_back(Json::parse(each));
    return document(list);
}

std::string check_json(const std::vector<CheckedFile>& files) {
    Json list = Json::array();
    for (const CheckedFile& each : files) {
        Json json{{"file", each.file},
                  {"ok", each.errors.empty()},
                  {"errors", diagnostics_json(each.errors)},
                  {"warnings", diagnostics_json(each.warnings)},
                  {"notes", each.notes}};
        if (each.stats) json["scene"] = scene_json(*each.stats);
        list.push_back(std::move(json));
    }
    return document({{"glint", version()}, {"files", list}});
}

std::string devices_json() {
    std::string why;
    Json devices = Json::array();
    for (const GpuDevice& d : gpu_devices(&why)) {
        Json device{{"number", devices.size()},
                    {"name", d.name},
                    {"usable", d.fault.empty()},
                    {"software", d.software}};
        if (!d.fault.empty()) device["fault"] = d.fault;
        if (!d.driver.empty())
            device.update({{"driver", d.driver},
                           {"largest_buffer", d.max_buffer},
                           {"buffers", d.buffers},
                           {"largest_group", d.max_group}});
        devices.push_back(std::move(device));
    }
    Json json{{"glint", version()}, {"devices", devices}};
    if (devices.empty()) json["fault"] = why;
    return document(json);
}

std::string info_json(const std::string& file, const SceneDescription& description, const Scene& scene) {
    const CameraDescription& camera = scene.camera();
    Json materials = Json::array();
    for (const Material& material : description.materials) materials.push_back(material_json(material));
    return document({
        {"glint", version()},
        {"file", file},
        {"scene", scene_json(scene.stats())},
        {"settings", settings_json(scene)},
        {"camera",
         {{"framed", !description.camera.has_value()},
          {"eye", vector_json(camera.eye)},
          {"direction", vector_json(camera.direction)},
          {"up", vector_json(camera.up)},
          {"fov", camera.fov}}},
        {"materials", materials},
    });
}

} // namespace glint::cli
