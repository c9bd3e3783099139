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

Json settings_json(const Scene& scene) {
    Json json = Json::object();
    for (const auto& setting : picture_settings(scene)) json[setting_name(setting.first)] = setting.second;
    return json;
}

Json material_json(const Material& material) {
    Json json{{"name", material.name}};
    for (const KeySpec& key : description_table("material").keys) {
        const KeyValue value = key.get(KeyOwner(material));
        if (const auto* number = std::get_if<double>(&value))
            json[std::string(key.key)] = *number;
        else if (const auto* vector = std::get_if<Vec3>(&value))
            json[std::string(key.key)] = vector_json(*vector);
        else if (const auto* flag = std::get_if<bool>(&value))
            json[std::string(key.key)] = *flag;
        else
            json[std::string(key.key)] = plain_text(key, value);
    }
    return json;
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

std::string stats_list_json(const std::vector<std::string>& documents) {
    Json list = Json::array();
    for (const std::string& each : documents) list.push_back(Json::parse(each));
    return document(list);
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
