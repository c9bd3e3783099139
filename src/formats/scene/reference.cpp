// The reference page of scene files, generated from the key table.

#include "formats/embedded.h"
#include "formats/scene/key_table.h"
#include "formats/scene/write.h"
#include "glint/limits.h"
#include "glint/scene_files.h"

#include <algorithm>
#include <limits>

namespace glint {
namespace {

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string choices_text(const KeySpec& key) {
    std::string text;
    for (const std::string& word : choice_names(key))
        text += (text.empty() ? "" : ", ") + code('"' + word + '"');
    return text;
}

std::string type_text(const KeySpec& key) {
    switch (key.type) {
    case KeyType::boolean:
        return "`true` or `false`";
    case KeyType::whole_number:
        return "integer";
    case KeyType::number:
        return "number";
    case KeyType::number_or_auto:
        return "number or `\"auto\"`";
    case KeyType::choice:
        return choices_text(key);
    case KeyType::text:
        return "text";
    case KeyType::file:
        return "file name";
    case KeyType::size:
        return "`[width, height]`, integers";
    case KeyType::point:
        return "`[x, y, z]`";
    case KeyType::direction:
        return "`[x, y, z]`, not zero, of any length";
    case KeyType::rgb:
        return "`[r, g, b]`";
    case KeyType::color:
        return "colour";
    case KeyType::lengths:
        return "`[x, y, z]`";
    case KeyType::scale:
        return "number or `[x, y, z]`, not 0";
    case KeyType::vertices:
        return "`[[x, y, z], [x, y, z], [x, y, z]]`";
    case KeyType::matrix:
        return "16 numbers by rows";
    case KeyType::key_path:
        return "key path";
    case KeyType::frame_range:
        return "`[first, last]`, integers";
    case KeyType::frames:
        return "list of numbers, ascending";
    case KeyType::values:
        return "list of values";
    case KeyType::transform:
        break;
    }
    return "list of tables";
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
    if (const std::string text = default_text(key); !text.empty()) return code(text);
    if (!key.alternative.empty() && key.required) return "*required: this or* " + code(key.alternative);
    return key.required ? "*required*" : "";
}

std::string help_cell(const KeySpec& key, const TableSpec& table) {
    std::string text;
    if (!key.types.empty()) text = "(" + std::string(table.selector) + " ";
    for (std::size_t i = 0; i < key.types.size(); ++i)
        text += (i > 0 ? ", " : "") + std::string(key.types[i]);
    if (!key.types.empty()) text += key.help.empty() ? ")" : ") ";
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
    const TableSpec& table = *find_table("sphere");
    for (const KeySpec& key : table.keys)
        if (common_to_objects(key, table)) text += row(key, table);
    return text;
}

} // namespace

std::string scene_key_reference() {
    std::string text(embedded_text("formats/scene/introduction.md"));
    bool objects_opened = false;
    for (const TableSpec& table : table_specs()) {
        // Common keys of objects precede the first object.
        if (table.object && !objects_opened) text += object_section();
        objects_opened = objects_opened || table.object;
        text += section(table);
    }
    return text;
}

} // namespace glint
