// Resolving key paths.

#include "formats/scene/key_path.h"

#include "scene/text.h"

#include <optional>

namespace glint::formats {

using scene::in_quotes;

namespace {

using Kind = TreeValue::Kind;

constexpr std::string_view transform_part = ".transform.";

// Names may be quoted as in TOML.
std::string_view unquoted(std::string_view name) {
    const bool quotes =
        name.size() >= 2 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front();
    return quotes ? name.substr(1, name.size() - 2) : name;
}

/// The parts of a path such as "material.glass.index"; the name may contain dots.
struct Path {
    std::string_view table; ///< empty: a top-level key
    std::string_view name;  ///< empty: none
    std::string_view key;
    bool has_name = false;
};

Path split_path(std::string_view text) {
    const std::size_t first = text.find('.');
    if (first == std::string_view::npos) return {{}, {}, trimmed(text), false};
    const std::size_t last = text.rfind('.');
    Path path{trimmed(text.substr(0, first)), {}, trimmed(text.substr(last + 1)), first != last};
    if (path.has_name) path.name = trimmed(text.substr(first + 1, last - first - 1));
    return path;
}

std::string example(std::string_view table) {
    const TableSpec& spec = *find_table(table);
    const std::string key(spec.keys.front().key);
    return std::string(table) + (spec.form == TableForm::one ? "." : ".NAME.") + key + "=…";
}

class Finder {
  public:
    Finder(TreeValue& root, const SourcePos& where, Problems& problems,
           std::map<std::string_view, PartNames>& names)
        : root_(root), problems_(problems), where_(where), names_(names) {}

    KeyTarget find(const Path& path) {
        if (path.table.empty()) return find_top(path);
        const TableSpec* spec = find_table(path.table);
        if (!spec || spec->form == TableForm::entry)
            return fail("unknown table " + in_quotes(path.table), suggest(path.table, table_names()));
        return spec->form == TableForm::one ? find_one(path, *spec) : find_of_many(path, *spec);
    }

  private:
    KeyTarget fail(std::string message, std::string hint) {
        problems_.error(where_, std::move(message), std::move(hint));
        return {};
    }

    static KeyTarget target(TreeValue& table, const TableSpec& spec, std::string_view key, std::string path) {
        // The reader reports values that should be tables.
        if (table.kind != Kind::table) return {};
        if (!path.empty()) path += '.';
        return {&table, &spec, std::string(key), path + std::string(key)};
    }

    KeyTarget find_top(const Path& path) {
        const TableSpec& top = *find_table("");
        if (find_key(top, path.key, {})) return target(root_, top, path.key, "");
        if (!path.key.empty() && find_table(path.key))
            return fail(in_quotes(path.key) + " is a table, not a value",
                        "name one of its keys: " + example(path.key));
        auto names = key_names(top, {});
        for (const std::string& name : table_names()) names.push_back(name);
        return fail("unknown key " + in_quotes(path.key), suggest(path.key, names));
    }

    KeyTarget find_one(const Path& path, const TableSpec& spec) {
        if (path.has_name)
            return fail(spec.header() + " has no parts named " + in_quotes(unquoted(path.name)),
                        "expected " + example(spec.name));
        TreeEntry* entry = root_.find(spec.name);
        if (!entry) {
            // Add an empty table for one that is missing.
            TreeValue empty;
            empty.where = where_;
            root_.entries.push_back({std::string(spec.name), where_, empty});
            entry = &root_.entries.back();
        }
        return target(entry->value, spec, path.key, std::string(spec.name));
    }

    KeyTarget find_of_many(const Path& path, const TableSpec& spec) {
        if (!path.has_name) return report_unnamed(path, spec);
        std::string found_as;
        if (TreeValue* found = part(spec, path.name, found_as))
            return target(*found, spec, path.key, found_as);
        const std::size_t split = spec.object ? path.name.rfind(transform_part) : std::string_view::npos;
        if (split != std::string_view::npos)
            if (TreeValue* object = part(spec, path.name.substr(0, split), found_as))
                return find_transform(*object, path, split, found_as);
        return report_missing(path, spec);
    }

    /// "mesh.cat.transform.0.angle"
    KeyTarget find_transform(TreeValue& object, const Path& path, std::size_t split,
                             const std::string& found_as) {
        const std::string_view number = path.name.substr(split + transform_part.size());
        TreeEntry* entry = object.find("transform");
        const std::size_t count = entry ? entry->value.items.size() : 0;
        const auto index = scene::parse_number<std::size_t>(number);
        if (!index || *index >= count)
            return fail("no entry " + in_quotes(number) + " of the transform",
                        count == 0 ? "the object has no transform"
                                   : "it has " + std::to_string(count) + ", numbered from 0");
        return target(entry->value.items[*index], *find_table("transform"), path.key,
                      found_as + std::string(transform_part) + std::to_string(*index));
    }

    /// The table with that name or number; null if there is none. `found_as` is set to its path.
    TreeValue* part(const TableSpec& spec, std::string_view written, std::string& found_as) {
        TreeEntry* entry = root_.find(spec.name);
        if (!entry) return nullptr;
        const std::string_view name = unquoted(written);
        found_as = std::string(spec.name) + ".";
        const PartNames& names = names_of(spec, entry->value);
        const auto known = names.find(std::string(name));
        if (spec.form == TableForm::named) {
            found_as += name;
            return known == names.end() ? nullptr : &entry->value.entries[known->second].value;
        }
        std::vector<TreeValue>& items = entry->value.items;
        const auto index =
            known == names.end() ? scene::parse_number<std::size_t>(name) : std::optional(known->second);
        if (!index || *index >= items.size()) return nullptr;
        found_as += std::to_string(*index);
        return &items[*index];
    }

    const PartNames& names_of(const TableSpec& spec, const TreeValue& parts) {
        const auto [place, is_new] = names_.try_emplace(spec.name);
        PartNames& names = place->second;
        for (std::size_t i = 0; is_new && i < parts.entries.size(); ++i)
            names.emplace(parts.entries[i].key, i);
        for (std::size_t i = 0; is_new && i < parts.items.size(); ++i) {
            const TreeEntry* name = parts.items[i].find("name");
            if (name && name->value.kind == Kind::text) names.emplace(name->value.text, i);
        }
        return names;
    }

    /// What can stand between table and key.
    std::vector<std::string> part_names(const TableSpec& spec) const {
        std::vector<std::string> names;
        const TreeEntry* entry = root_.find(spec.name);
        if (!entry) return names;
        for (const TreeEntry& named : entry->value.entries) names.push_back(named.key);
        for (const TreeValue& item : entry->value.items) {
            const TreeEntry* name = item.find("name");
            const bool has_name = name && name->value.kind == Kind::text;
            names.push_back(has_name ? name->value.text : std::to_string(names.size()));
        }
        return names;
    }

    static std::string inventory(const TableSpec& spec, const std::vector<std::string>& names) {
        const std::string what = names.empty() ? "no " + std::string(spec.name)
                                 : spec.form == TableForm::list
                                     ? std::to_string(names.size()) + ", numbered from 0"
                                     : scene::listed(names);
        return "the scene has " + what;
    }

    /// For a path without a name: "light.intensity".
    KeyTarget report_unnamed(const Path& path, const TableSpec& spec) {
        std::string found_as;
        if (part(spec, path.key, found_as))
            return fail(in_quotes(found_as) + " is a table, not a value",
                        "name one of its keys: " + found_as + "." + std::string(spec.keys.front().key) +
                            "=…");
        const std::vector<std::string> names = part_names(spec);
        std::string hint = inventory(spec, names);
        if (!names.empty())
            hint += ": " + std::string(spec.name) + "." + names.front() + "." + std::string(path.key) + "=…";
        return fail("which " + in_quotes(spec.name) + "? the path names none", std::move(hint));
    }

    KeyTarget report_missing(const Path& path, const TableSpec& spec) {
        const std::vector<std::string> names = part_names(spec);
        const std::string_view wanted = unquoted(path.name);
        const std::string all = inventory(spec, names);
        const bool is_number = scene::parse_number<int>(wanted).has_value();
        return fail("no " + std::string(spec.name) + " " + in_quotes(wanted),
                    is_number ? all : problems_.suggestion(wanted, names, all));
    }

    std::string suggest(std::string_view word, const std::vector<std::string>& names) const {
        return problems_.suggestion(word, names, "expected one of " + scene::listed(names));
    }

    TreeValue& root_;
    Problems& problems_;
    SourcePos where_;
    std::map<std::string_view, PartNames>& names_;
};

} // namespace

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
    while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
    return text;
}

KeyTarget KeyPaths::find(std::string_view path, const SourcePos& where) {
    return Finder(root_, where, problems_, names_).find(split_path(path));
}

void KeyPaths::put(const KeyTarget& target, TreeValue value, const SourcePos& where) {
    if (target.key == "name") names_.clear();
    if (TreeEntry* entry = target.table->find(target.key)) {
        entry->where = where;
        entry->value = std::move(value);
    } else
        target.table->entries.push_back({target.key, where, std::move(value)});
}

TreeValue read_value(std::string_view text, const SourcePos& where) {
    if (auto value = parse_tree_value(text, where)) return *std::move(value);
    TreeValue bare;
    bare.kind = Kind::text;
    bare.text = text;
    bare.where = where;
    return bare;
}

void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems) {
    KeyPaths paths(root, problems);
    int origin = 0;
    for (const std::string& text : source.overrides()) {
        const SourcePos where{++origin, 0, 0};
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw Error(ErrorKind::usage, "-D " + text + " has no value",
                        "expected path=value, for example whitted.max_depth=3");
        const std::string_view value = trimmed(std::string_view(text).substr(equals + 1));
        const KeyTarget target = paths.find(std::string_view(text).substr(0, equals), where);
        if (target.table) paths.put(target, read_value(value, where), where);
    }
}

} // namespace glint::formats
