#include "scene/keys/tables.h"

#include "glint/scene.h"
#include "scene/text.h"

#include <algorithm>
#include <stdexcept>

namespace glint {

namespace keys = scene::keys;

using scene::show;

std::string NumberRange::text() const {
    const bool below = low > -std::numeric_limits<double>::infinity();
    const bool above = high < std::numeric_limits<double>::infinity();
    if (below && above && !low_open && !high_open) return "between " + show(low) + " and " + show(high);
    std::string text;
    if (below) text = (low_open ? "above " : "at least ") + show(low);
    if (below && above) text += " and ";
    if (above) text += (high_open ? "below " : "at most ") + show(high);
    return text;
}

bool KeySpec::belongs_to(std::string_view table_type) const {
    return table_type.empty() || types.empty() ||
           std::find(types.begin(), types.end(), table_type) != types.end();
}

std::string TableSpec::header(std::string_view name_of_it) const {
    switch (form) {
    case TableForm::root:
        return "the file's top";
    case TableForm::one:
        return "[" + std::string(name) + "]";
    case TableForm::named:
        return "[" + std::string(name) + "." + std::string(name_of_it) + "]";
    case TableForm::list:
        return "[[" + std::string(name) + "]]";
    case TableForm::entry:
        break;
    }
    return "an entry of " + scene::in_quotes(name);
}

const std::vector<TableSpec>& description_tables() {
    static const std::vector<TableSpec> tables = [] {
        std::vector<TableSpec> all{keys::camera_table(),
                                   keys::render_table(),
                                   keys::whitted_table(),
                                   keys::path_table(),
                                   keys::ambient_occlusion_table(),
                                   keys::material_table()};
        for (TableSpec& table : keys::object_tables()) all.push_back(std::move(table));
        all.push_back(keys::light_table());
        return all;
    }();
    return tables;
}

const TableSpec& description_table(std::string_view name) {
    for (const TableSpec& table : description_tables())
        if (table.name == name) return table;
    throw std::out_of_range("no table of a scene is named " + scene::in_quotes(name));
}

const KeySpec* find_key(const TableSpec& table, std::string_view key, std::string_view type) {
    for (const KeySpec& spec : table.keys)
        if (spec.key == key && spec.belongs_to(type)) return &spec;
    return nullptr;
}

namespace {

struct PlainText {
    const KeySpec& key;

    static std::string list(const double* first, std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + show(first[i]);
        return "(" + text + ")";
    }

    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(std::uint64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return show(value); }
    template <class Number>
    std::string operator()(const std::optional<Number>& value) const {
        return value ? (*this)(*value) : "auto";
    }
    std::string operator()(Choice value) const { return std::string(key.choices[value.index]); }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(const std::array<int, 2>& size) const {
        return std::to_string(size[0]) + "x" + std::to_string(size[1]);
    }
    std::string operator()(const Vec3& v) const { return list(&v.x, 3); }
    std::string operator()(const std::array<Vec3, 3>& points) const { return list(&points[0].x, 9); }
    std::string operator()(const Mat4& m) const { return list(&m[0].x, 16); }
    std::string operator()(const std::vector<double>& all) const { return list(all.data(), all.size()); }
};

} // namespace

std::string plain_text(const KeySpec& key, const KeyValue& value) {
    return std::visit(PlainText{key}, value);
}

} // namespace glint
