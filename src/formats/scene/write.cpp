// Writing descriptions as scene files.

#include "formats/scene/write.h"
#include "glint/document.h"
#include "glint/scene.h"
#include "scene/text.h"

#include <array>
#include <cmath>

namespace glint::formats {

namespace {

/// A value in TOML.
struct Written {
    const KeySpec& key;

    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(std::uint64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return scene_value(value); }
    template <class Number>
    std::string operator()(const std::optional<Number>& value) const {
        return value ? (*this)(*value) : "\"auto\"";
    }
    std::string operator()(Choice value) const { return scene_value(key.choices[value.index]); }
    std::string operator()(const std::string& value) const { return scene_value(value); }
    std::string operator()(const std::array<int, 2>& pair) const {
        return list({std::to_string(pair[0]), std::to_string(pair[1])});
    }
    std::string operator()(const Vec3& v) const {
        const bool even = v.x == v.y && v.y == v.z;
        return key.type == KeyType::scale && even ? scene_value(v.x) : scene_value(v);
    }
    std::string operator()(const std::array<Vec3, 3>& points) const {
        return list({scene_value(points[0]), scene_value(points[1]), scene_value(points[2])});
    }
    std::string operator()(const Mat4& matrix) const {
        if (matrix == Mat4(1)) return "[]";
        std::vector<std::string> rows;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) rows.push_back(scene_value(matrix[column][row]));
        return "[{ matrix = " + list(rows) + " }]";
    }
    std::string operator()(const std::vector<double>& numbers) const {
        std::vector<std::string> texts;
        for (const double x : numbers) texts.push_back(scene_value(x));
        return list(texts);
    }

    static std::string list(const std::vector<std::string>& values) {
        return "[" + scene::listed(values) + "]";
    }
};

bool is_bare_key(std::string_view key) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !key.empty() && key.find_first_not_of(letters) == std::string_view::npos;
}

/// A table of what the owner holds: its keys in their order, without those that have their defaults.
std::string table_text(const TableSpec& table, const KeyOwner& owner, std::string_view name = {}) {
    std::string_view type;
    std::string lines;
    for (const KeySpec& key : table.keys) {
        const KeyValue value = key.get ? key.get(owner) : KeyValue();
        if (const auto* choice = std::get_if<Choice>(&value); choice && key.key == table.selector)
            type = key.choices[choice->index];
        const auto* text = std::get_if<std::string>(&value);
        const bool absent = std::holds_alternative<std::monostate>(value) || (text && text->empty());
        if (absent || !key.belongs_to(type)) continue;
        const std::string line = toml_text(key, value);
        if (line != default_text(key)) lines += std::string(key.key) + " = " + line + "\n";
    }
    // Settings that all have their defaults need no header.
    if (lines.empty() && table.form == TableForm::one) return {};
    return table.header(is_bare_key(name) ? name : scene_value(name)) + "\n" + lines;
}

std::string object_text(const Object& object) {
    const auto* mesh = std::get_if<MeshShape>(&object.shape);
    if (mesh && mesh->file.empty())
        throw Error(ErrorKind::output, "a mesh made in memory cannot be written into a scene file",
                    "write it as PLY first and name that file");
    return table_text(description_table(name_of(object.shape)), KeyOwner(object));
}

} // namespace

std::string toml_text(const KeySpec& key, const KeyValue& value) { return std::visit(Written{key}, value); }

std::string default_text(const KeySpec& key) {
    if (!key.initial) return {};
    const KeyValue value = key.initial();
    const auto* text = std::get_if<std::string>(&value);
    return text && text->empty() ? "" : toml_text(key, value);
}

} // namespace glint::formats

namespace glint {

std::string scene_value(double value) {
    std::string text = scene::show(value);
    // Without a decimal point TOML reads an integer, which has no −0 and is limited to 2^63.
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
    std::string text;
    const auto add = [&](const std::string& table) {
        if (!table.empty()) text += (text.empty() ? "" : "\n") + table;
    };
    if (description.camera) add(camera_text(*description.camera));
    for_settings(description, [&](std::string_view name, const auto& settings) {
        add(formats::table_text(description_table(name), KeyOwner(settings)));
    });
    for (const Material& material : description.materials)
        add(formats::table_text(description_table("material"), KeyOwner(material), material.name));
    for (const Object& object : description.objects) add(formats::object_text(object));
    for (const Light& light : description.lights)
        add(formats::table_text(description_table("light"), KeyOwner(light)));
    return text;
}

std::string camera_text(const CameraDescription& camera) {
    return formats::table_text(description_table("camera"), KeyOwner(camera));
}

} // namespace glint
