// The reference page of scene files, generated from the key table.

#include "formats/embedded.h"
#include "formats/scene/key_table.h"
#include "formats/scene/write.h"
#include "glint/limits.h"
#include "glint/scene_files.h"
#include "scene/text.h"

#include <algorithm>
#include <limits>

namespace glint {
namespace {

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string choices_text(const KeySpec& key) {
    std::vector<std::string> words = formats::choice_names(key);
    for (std::string& word : words) word = code('"' + word + '"');
    return scene::listed(words);
}

struct TypeText {
    KeyType type;
    std::string_view text;
};
constexpr TypeText type_texts[] = {
    {KeyType::boolean, "`true` or `false`"},
    {KeyType::whole_number, "integer"},
    {KeyType::number, "number"},
    {KeyType::number_or_auto, "number or `\"auto\"`"},
    {KeyType::whole_number_or_auto, "integer or `\"auto\"`"},
    {KeyType::text, "text"},
    {KeyType::file, "file name"},
    {KeyType::size, "`[width, height]`, integers"},
    {KeyType::point, "`[x, y, z]`"},
    {KeyType::direction, "`[x, y, z]`, not zero, of any length"},
    {KeyType::rgb, "`[r, g, b]`"},
    {KeyType::color, "colour"},
    {KeyType::lengths, "`[x, y, z]`"},
    {KeyType::scale, "number or `[x, y, z]`, not 0"},
    {KeyType::vertices, "`[[x, y, z], [x, y, z], [x, y, z]]`"},
    {KeyType::matrix, "16 numbers by rows"},
    {KeyType::transform, "list of tables"},
    {KeyType::key_path, "key path"},
    {KeyType::frame_range, "`[first, last]`, integers"},
    {KeyType::frames, "list of numbers, ascending"},
    {KeyType::values, "list of values"},
};

std::string type_text(const KeySpec& key) {
    if (key.type == KeyType::choice) return choices_text(key);
    return std::string(std::ranges::find(type_texts, key.type, &TypeText::type)->text);
}

std::string range_text(const KeySpec& key) {
    if (key.range.high == coordinate_limit && key.range.low == 0) return "above 0";
    if (key.range.high == coordinate_limit || key.range.high == std::numeric_limits<int>::max()) return {};
    return key.range.text();
}

std::string value_cell(const KeySpec& key) {
    std::string text = type_text(key);
    if (const std::string range = range_text(key); !range.empty()) text += ", " + range;
    if (!key.unit.empty()) text += "; " + std::string(key.unit);
    return text;
}

std::string default_cell(const KeySpec& key) {
    if (const std::string text = formats::default_text(key); !text.empty()) return code(text);
    if (!key.alternative.empty() && key.required) return "*required: this or* " + code(key.alternative);
    return key.required ? "*required*" : "";
}

std::string help_cell(const KeySpec& key, const TableSpec& table) {
    std::string text;
    if (!key.types.empty())
        text = "(" + std::string(table.selector) + " " + scene::listed({key.types.begin(), key.types.end()}) +
               (key.help.empty() ? ")" : ") ");
    return text + std::string(key.help);
}

bool common_to_objects(const KeySpec& key, const TableSpec& table) {
    if (!table.object) return false;
    for (const std::string_view common : {"name", "visible", "priority", "transform"})
        if (key.key == common) return true;
    return key.key == "material" && key.required;
}

std::string row(const KeySpec& key, const TableSpec& table) {
    const std::string name = key.required ? "**" + code(key.key) + "**" : code(key.key);
    return "| " + name + " | " + value_cell(key) + " | " + default_cell(key) + " | " + help_cell(key, table) +
           " |\n";
}

constexpr std::string_view table_head = "\n| key | value | default | meaning |\n|---|---|---|---|\n";

std::string title(const TableSpec& table) {
    if (table.form == TableForm::root) return "The top of the file";
    if (table.form == TableForm::entry) return "Entries of `" + std::string(table.name) + "`";
    return code(table.header());
}

/// A paragraph in lines of at most 110 bytes.
std::string wrapped(std::string_view paragraph) {
    constexpr std::size_t width = 110;
    std::string text;
    std::size_t line = 0; // where the last line begins
    while (!paragraph.empty()) {
        const std::string_view word = paragraph.substr(0, paragraph.find(' '));
        paragraph.remove_prefix(std::min(word.size() + 1, paragraph.size()));
        const bool fits = text.size() - line + 1 + word.size() <= width;
        if (!text.empty()) text += fits ? ' ' : '\n';
        if (!fits) line = text.size();
        text += word;
    }
    return text;
}

std::string section(const TableSpec& table) {
    std::string text = "\n## " + title(table) + "\n\n" + wrapped(table.help) + "\n" + std::string(table_head);
    for (const KeySpec& key : table.keys)
        if (!common_to_objects(key, table)) text += row(key, table);
    return text;
}

std::string object_section() {
    std::string text = "\n## Every object\n\nObjects of all shapes have these keys besides their own.\n" +
                       std::string(table_head);
    const TableSpec& table = *formats::find_table("sphere");
    for (const KeySpec& key : table.keys)
        if (common_to_objects(key, table)) text += row(key, table);
    return text;
}

} // namespace

std::string scene_key_reference() {
    std::string text(formats::embedded_text("formats/scene/reference_page.md"));
    bool objects_opened = false;
    for (const TableSpec& table : formats::table_specs()) {
        // Common keys of objects precede the first object.
        if (table.object && !objects_opened) text += object_section();
        objects_opened = objects_opened || table.object;
        text += section(table);
    }
    return text;
}

} // namespace glint
