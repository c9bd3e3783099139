// The reference page of scene files, generated from the key table.

#include "formats/scene/key_table.h"
#include "formats/scene/write.h"
#include "glint/formats.h"
#include "glint/limits.h"

#include <limits>

#include <algorithm>

namespace glint {
namespace {

constexpr std::string_view introduction =
    R"(<!-- Generated from the table of keys (src/scene/keys, src/formats/scene/file_keys.cpp). Do not edit. -->
# Scene files

A scene is a [TOML](https://toml.io/en/v1.0.0) file, named `*.toml`. The smallest one that shows something:

```toml
[material.red]
color = "crimson"

[[sphere]]
center = [0, 0, 0]
radius = 1
material = "red"

[[light]]
type = "point"
position = [3, -4, 5]
intensity = 40
```

`glint new` writes longer ones with comments.

## What holds everywhere

- Space is right-handed. Points and vectors are `[x, y, z]`, lengths are in scene units, angles in degrees.
  Rotations turn counter-clockwise, looking against the axis.
- Coordinates lie within ±10^12, also after transforms. Nothing is infinite or NaN.
- An integer is good where a number is asked; `4.0` is not an integer.
- Keys that a table does not have are errors, also keys of another type of that table (a `radius` on a box).
  All errors of a file are reported at once, each with line and column; only an error of TOML itself stops the
  search.
- **Objects are numbered in the order in which they stand in the file, across all tables; so are lights.** The
  order decides ties between surfaces at one place, and the order of sums.
- The file is UTF-8. A byte order mark and CRLF line ends are accepted.

**Colours** are `[r, g, b]` of linear numbers, `"#rrggbb"`, `"#rgb"`, or a name in any case: those of CSS
(`"crimson"`), and besides them the numbered ones of X11 (`"DarkOrange2"`, `"gray50"`). Names and `#` are sRGB
and decoded, unless `color_values = "linear"` at the top says that they are plain numbers / 255.

**Files** named in a scene are relative to the scene file, and must lie in its folder (symbolic links and `..`
resolved) unless `--allow-outside` is given.

**Overrides**: `-D path=value` sets one value before the file is checked. The path names a key by its table
(`-D whitted.max_depth=3`), by the name of its table (`-D material.glass.index=1.33`,
`-D mesh.cat.file=other.ply`) or by the number of its table among those of its type, from 0
(`-D light.0.intensity=500`). A key in an entry of a transform is named by the entry's number
(`-D mesh.cat.transform.1.angle=30`). The value is TOML; what is not TOML is taken as text, so quotes may be
left out. Files named here are relative to the working directory, and may lie anywhere. A bare mesh takes
overrides of `render`, `whitted`, `camera`, `material.clay` and `material.floor`.

Keys in **bold** are required.
)";

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
    std::string text(introduction);
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
