// From a description back to a scene file.

#include "formats/document_edit.h"
#include "formats/key_table.h"
#include "formats/scene_words.h"
#include "glint/document.h"

#include <array>
#include <cmath>

namespace glint {
namespace {

std::string written(bool value) { return value ? "true" : "false"; }
std::string written(int value) { return std::to_string(value); }
std::string written(std::uint64_t value) { return std::to_string(value); }
std::string written(double value) { return scene_value(value); }
std::string written(const Vec3& value) { return scene_value(value); }
std::string written(const std::string& value) { return scene_value(value); }
std::string written(const std::optional<double>& value) { return value ? scene_value(*value) : "\"auto\""; }

std::string written(const std::array<Vec3, 3>& points) {
    return "[" + scene_value(points[0]) + ", " + scene_value(points[1]) + ", " + scene_value(points[2]) + "]";
}

std::string written(const std::array<int, 2>& size) {
    return "[" + std::to_string(size[0]) + ", " + std::to_string(size[1]) + "]";
}

std::string written(const Mat4& matrix) {
    std::string text;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            text += (text.empty() ? "" : ", ") + scene_value(matrix[column][row]);
    return "[{ matrix = [" + text + "] }]";
}

bool is_bare_key(std::string_view key) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !key.empty() && key.find_first_not_of(letters) == std::string_view::npos;
}

/// Writes tables, leaving out what says the same as the key table's defaults.
class SceneWriter {
  public:
    std::string text() && { return std::move(text_); }

    void open(std::string_view table, std::string_view name = {}, std::string_view type = {}) {
        spec_ = find_table(table);
        type_ = type;
        opening_ =
            (text_.empty() ? "" : "\n") + spec_->header(is_bare_key(name) ? name : scene_value(name)) + "\n";
        // Settings that are all left out need no header.
        if (spec_->form != TableForm::one) write_header();
    }

    template <class T>
    void put(std::string_view key, const T& value) {
        const std::string text = written(value);
        const std::string_view fallback = find_key(*spec_, key, type_)->fallback;
        if (!fallback.empty() && same_value(*parse_tree_value(text, {}), *parse_tree_value(fallback, {})))
            return;
        write_header();
        text_ += std::string(key) + " = " + text + "\n";
    }

    /// An enumeration whose values stand in the order of the key's choices.
    template <class Enum>
    void put_choice(std::string_view key, Enum value) {
        put(key, split_words(find_key(*spec_, key, type_)->choices)[static_cast<std::size_t>(value)]);
    }

    void put_named(std::string_view key, const std::string& name) {
        if (!name.empty()) put(key, name);
    }

    void put_scale(const Vec3& scale) {
        if (scale.x == scale.y && scale.y == scale.z)
            put("scale", scale.x);
        else
            put("scale", scale);
    }

  private:
    void write_header() {
        text_ += opening_;
        opening_.clear();
    }

    std::string text_;
    std::string opening_;
    const TableSpec* spec_ = nullptr;
    std::string_view type_;
};

void write_camera(SceneWriter& out, const CameraDescription& camera) {
    out.open("camera");
    out.put("eye", camera.eye);
    out.put("direction", camera.direction);
    out.put("up", camera.up);
    out.put("fov", camera.fov);
    out.put_choice("fov_axis", camera.fov_axis);
}

void write_settings(SceneWriter& out, const RenderSettings& render, const WhittedSettings& whitted) {
    out.open("render");
    out.put("size", std::array<int, 2>{render.width, render.height});
    out.put("spp", render.spp);
    out.put("seed", render.seed);
    out.put("integrator", render.integrator);
    out.put_choice("filter", render.filter);
    out.put("background", render.background);
    out.open("whitted");
    out.put("max_depth", whitted.max_depth);
    out.put_choice("shadows", whitted.shadows);
    out.put("clamp", whitted.clamp);
    out.put_choice("energy", whitted.energy);
    out.put_choice("highlight_model", whitted.highlight_model);
    out.put("index", whitted.index);
}

void write_material(SceneWriter& out, const Material& material) {
    out.open("material", material.name);
    out.put("color", material.color);
    out.put("ambient", material.ambient);
    out.put("diffuse", material.diffuse);
    out.put("highlight", material.highlight);
    out.put("shininess", material.shininess);
    out.put("reflectivity", material.reflectivity);
    out.put("transparency", material.transparency);
    out.put("index", material.index);
    out.put("absorption", material.absorption);
    out.put("fresnel", material.fresnel);
    out.put("emission", material.emission);
}

void write_shape(SceneWriter& out, const PlaneShape& plane) {
    out.open("plane");
    out.put("normal", plane.normal);
    out.put("offset", plane.offset);
    out.put("solid", plane.solid);
}

void write_shape(SceneWriter& out, const SphereShape& sphere) {
    out.open("sphere");
    out.put("center", sphere.center);
    out.put("radius", sphere.radius);
}

void write_shape(SceneWriter& out, const CylinderShape& cylinder) {
    out.open("cylinder");
    out.put("base", cylinder.base);
    out.put("axis", cylinder.axis);
    out.put("height", cylinder.height);
    out.put("radius", cylinder.radius);
}

void write_shape(SceneWriter& out, const TriangleShape& triangle) {
    out.open("triangle");
    out.put("vertices", triangle.vertices);
}

void write_shape(SceneWriter& out, const PolyhedronShape& polyhedron) {
    const bool box = polyhedron.kind == PolyhedronKind::box;
    const bool standing =
        polyhedron.kind == PolyhedronKind::prism || polyhedron.kind == PolyhedronKind::pyramid;
    out.open("polyhedron");
    out.put_choice("kind", polyhedron.kind);
    out.put("center", polyhedron.center);
    if (box)
        out.put("size", polyhedron.size);
    else
        out.put("radius", polyhedron.radius);
    if (!standing) return;
    out.put("sides", polyhedron.sides);
    out.put("height", polyhedron.height);
    out.put("axis", polyhedron.axis);
}

void write_shape(SceneWriter& out, const MeshShape& mesh) {
    if (mesh.file.empty())
        throw Error(ErrorKind::output, "a mesh made in memory cannot be written into a scene file",
                    "write it as PLY first and name that file");
    out.open("mesh");
    out.put("file", mesh.file);
    out.put_scale(mesh.scale);
    out.put_choice("normals", mesh.normals);
    out.put_choice("facing", mesh.facing);
    out.put_choice("vertex_colors", mesh.vertex_colors);
    out.put("point_radius", mesh.point_radius);
}

void write_shape(SceneWriter& out, const InstanceShape& instance) {
    out.open("instance");
    out.put("mesh", instance.mesh);
}

void write_object(SceneWriter& out, const Object& object) {
    std::visit([&](const auto& shape) { write_shape(out, shape); }, object.shape);
    out.put_named("name", object.name);
    out.put_named("material", object.material);
    out.put("visible", object.visible);
    out.put("priority", object.priority);
    if (object.transform != Mat4(1)) out.put("transform", object.transform);
}

void write_light(SceneWriter& out, const AmbientLight& light) {
    out.open("light", {}, "ambient");
    out.put("type", std::string("ambient"));
    out.put("color", light.color);
}

void write_light(SceneWriter& out, const PointLight& light) {
    out.open("light", {}, "point");
    out.put("type", std::string("point"));
    out.put("position", light.position);
    out.put("color", light.color);
    out.put("intensity", light.intensity);
}

void write_light(SceneWriter& out, const DirectionalLight& light) {
    out.open("light", {}, "directional");
    out.put("type", std::string("directional"));
    out.put("direction", light.direction);
    out.put("color", light.color);
    out.put("irradiance", light.irradiance);
}

void write_light(SceneWriter& out, const SpotLight& light) {
    out.open("light", {}, "spot");
    out.put("type", std::string("spot"));
    out.put("position", light.position);
    out.put("direction", light.direction);
    out.put("angle", light.angle);
    out.put("blend", light.blend);
    out.put("color", light.color);
    out.put("intensity", light.intensity);
}

} // namespace

std::string scene_value(double value) {
    std::string text = show(value);
    // Without a point TOML reads an integer: it has no −0, and ends at 2^63.
    const bool integer = text.find_first_not_of("-0123456789") == std::string::npos;
    if (integer && ((value == 0 && std::signbit(value)) || std::abs(value) >= 1e18)) text += ".0";
    return text;
}

std::string scene_value(const Vec3& value) {
    return "[" + scene_value(value.x) + ", " + scene_value(value.y) + ", " + scene_value(value.z) + "]";
}

std::string scene_value(std::string_view value) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text = "\"";
    for (const char c : value) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            text += {'\\', c};
        else if (code < 0x20 || code == 0x7f)
            text += {'\\', 'u', '0', '0', digits[code >> 4u], digits[code & 15u]};
        else
            text += c;
    }
    return text + '"';
}

std::string scene_text(const SceneDescription& description) {
    SceneWriter out;
    if (description.camera) write_camera(out, *description.camera);
    write_settings(out, description.render, description.whitted);
    for (const Material& material : description.materials) write_material(out, material);
    for (const Object& object : description.objects) write_object(out, object);
    for (const Light& light : description.lights)
        std::visit([&](const auto& kind) { write_light(out, kind); }, light.kind);
    return std::move(out).text();
}

std::string camera_text(const CameraDescription& camera) {
    SceneWriter out;
    write_camera(out, camera);
    return std::move(out).text();
}

} // namespace glint
