// The tables of keys that only files have, and lookup in all tables.

#include "formats/scene/key_table.h"

#include "scene/keys/bind.h"

namespace glint::formats {

namespace keys = scene::keys;

namespace {

constexpr NumberRange frame_number{.low = -1e6, .high = 1e6};

/// Read by TrackReader: their form is that of another key.
keys::KeyRow values() { return keys::KeyRow({.key = "values", .type = KeyType::values}); }

TableSpec top_table() {
    using namespace keys;
    return {.name = "",
            .form = TableForm::root,
            .help = "Before the first table.",
            .keys = {
                integer<&FileTop::version>("version").help("of this format; there is no other yet"),
                choice<&FileTop::color_values>("color_values")
                    .help("how colours given by name or `#` become light: decoded from sRGB, or plain "
                          "numbers / 255"),
            }};
}

TableSpec transform_table() {
    using namespace keys;
    using E = TransformEntry;
    return {.name = "transform",
            .form = TableForm::entry,
            .help = "Each entry holds one of these. Rotations and scalings are about the world's origin.",
            .keys = {
                point<&E::translate>("translate").no_default(),
                direction<&E::rotate>("rotate").no_default().help("the axis; goes with `angle`"),
                number<&E::angle>("angle")
                    .unit("degrees")
                    .range(coordinate)
                    .no_default()
                    .help("goes with `rotate`; counter-clockwise looking against the axis"),
                scale<&E::scale>("scale").no_default().help("negative mirrors"),
                bound<Mat4, &E::matrix>("matrix", KeyType::matrix)
                    .no_default()
                    .help("affine and regular: the last row is 0, 0, 0, 1"),
            }};
}

TableSpec animation_table() {
    using namespace keys;
    using A = AnimationTable;
    return {.name = "animation",
            .help = "What frames there are. `--frames` of the command line chooses among them.",
            .keys = {
                bound<std::array<int, 2>, &A::frames>("frames", KeyType::frame_range)
                    .unit("frames")
                    .range(frame_number)
                    .no_default()
                    .help("the first and the last; without it from 0 to the last keyframe"),
                number<&A::fps>("fps")
                    .unit("frames per second")
                    .range({.low = 0, .high = 1000, .low_open = true})
                    .help("how fast they are to be shown"),
            }};
}

TableSpec animate_table() {
    using namespace keys;
    using A = AnimateTable;
    return {
        .name = "animate",
        .form = TableForm::list,
        .help =
            "One value of the scene that moves from keyframe to keyframe. A picture without `--frames` shows "
            "the scene as its other tables say.",
        .keys = {
            text<&A::key>("key", KeyType::key_path)
                .required()
                .help("what moves, named as for `-D`: `\"camera.eye\"`, `\"mesh.cat.transform.0.angle\"`"),
            bound<std::vector<double>, &A::frames>("frames", KeyType::frames)
                .unit("frames")
                .range(frame_number)
                .required()
                .help("the keyframes"),
            values().required().help(
                "what the key has at each of them; colours by name may stand beside numbers"),
            choice<&A::interpolation>("interpolation")
                .help("between keyframes: at even speed; without jumps of speed and without overshooting; "
                      "not at all. What has no values in between (`true`, names, files) steps"),
            boolean<&A::loop>("loop").help(
                "start again at the last keyframe; without it the first and the last value hold"),
        }};
}

} // namespace

const std::vector<TableSpec>& table_specs() {
    static const std::vector<TableSpec> tables = [] {
        std::vector<TableSpec> all{top_table()};
        all.insert(all.end(), description_tables().begin(), description_tables().end());
        for (TableSpec& table : std::vector{transform_table(), animation_table(), animate_table()})
            all.push_back(std::move(table));
        return all;
    }();
    return tables;
}

const TableSpec* find_table(std::string_view name) {
    for (const TableSpec& table : table_specs())
        if (table.name == name) return &table;
    return nullptr;
}

std::vector<std::string> table_names() {
    std::vector<std::string> names;
    for (const TableSpec& spec : table_specs())
        if (spec.form != TableForm::root && spec.form != TableForm::entry) names.emplace_back(spec.name);
    return names;
}

std::vector<std::string> key_names(const TableSpec& table, std::string_view type) {
    std::vector<std::string> names;
    for (const KeySpec& spec : table.keys) {
        const bool new_one = names.empty() || names.back() != spec.key;
        if (new_one && find_key(table, spec.key, type)) names.emplace_back(spec.key);
    }
    return names;
}

std::vector<std::string> choice_names(const KeySpec& key) { return {key.choices.begin(), key.choices.end()}; }

} // namespace glint::formats
