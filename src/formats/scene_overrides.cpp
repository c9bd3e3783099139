#include "formats/scene_overrides.h"

#include "formats/key_table.h"
#include "formats/scene_words.h"

#include <algorithm>
#include <charconv>

namespace glint {
namespace {

using Kind = TreeValue::Kind;

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
    while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
    return text;
}

// A name may stand between quotes, as in TOML.
std::string_view unquoted(std::string_view name) {
    const bool quotes =
        name.size() >= 2 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front();
    return quotes ? name.substr(1, name.size() - 2) : name;
}

/// "material.glass.index" in its parts; the name may hold dots.
struct Path {
    std::string_view table; ///< empty: a key of the top
    std::string_view name;  ///< empty: none
    std::string_view key;
    bool has_name = false;
};

Path split_path(std::string_view text) {
    const std::size_t first = text.find('.');
    if (first == std::string_view::npos) return {{}, {}, trimmed(text), false};
    const std::size_t last = text.rfind('.');
    Path path{trimmed(text.substr(0, first)), {}, trimmed(text.substr(last + 1)), first != last};
    if (path.has_name) path.name = unquoted(trimmed(text.substr(first + 1, last - first - 1)));
    return path;
}

TreeValue value_of(std::string_view text, const Place& where) {
    if (auto value = parse_tree_value(text, where)) return *std::move(value);
    TreeValue bare;
    bare.kind = Kind::text;
    bare.text = text;
    bare.where = where;
    return bare;
}

class Overrider {
  public:
    Overrider(TreeValue& root, Problems& problems, const Place& where)
        : root_(root), problems_(problems), where_(where) {}

    void apply(const Path& path, TreeValue value) {
        TreeValue* table = find(path);
        if (!table) return;
        if (TreeEntry* entry = table->find(path.key)) {
            entry->where = where_;
            entry->value = std::move(value);
        } else
            table->entries.push_back({std::string(path.key), where_, std::move(value)});
    }

  private:
    void fail(std::string message, std::string hint) {
        problems_.error(where_, std::move(message), std::move(hint));
    }

    TreeValue* find(const Path& path) {
        if (path.table.empty()) return find_top(path);
        const TableSpec* spec = find_table(path.table);
        if (!spec || spec->form == TableForm::entry) {
            fail("unknown table " + in_quotes(path.table), suggest(path.table, table_names()));
            return nullptr;
        }
        return spec->form == TableForm::one ? find_one(path, *spec) : find_of_many(path, *spec);
    }

    TreeValue* find_top(const Path& path) {
        const TableSpec& top = *find_table("");
        if (find_key(top, path.key, {})) return &root_;
        if (!path.key.empty() && find_table(path.key))
            fail(in_quotes(path.key) + " is a table, not a value",
                 "name one of its keys: " + example(path.key));
        else {
            auto names = key_names(top, {});
            for (const std::string& name : table_names()) names.push_back(name);
            fail("unknown key " + in_quotes(path.key), suggest(path.key, names));
        }
        return nullptr;
    }

    TreeValue* find_one(const Path& path, const TableSpec& spec) {
        if (path.has_name) {
            fail(spec.header() + " has no parts named " + in_quotes(path.name),
                 "expected " + example(spec.name));
            return nullptr;
        }
        TreeEntry* entry = root_.find(spec.name);
        if (!entry) {
            // What the file left out is as if it stood there empty.
            TreeValue empty;
            empty.where = where_;
            root_.entries.push_back({std::string(spec.name), where_, empty});
            entry = &root_.entries.back();
        }
        return entry->value.kind == Kind::table ? &entry->value : nullptr;
    }

    TreeValue* find_of_many(const Path& path, const TableSpec& spec) {
        if (!path.has_name) {
            fail("which " + in_quotes(spec.name) + "? the path names none", "expected " + example(spec.name));
            return nullptr;
        }
        TreeEntry* entry = root_.find(spec.name);
        TreeValue* found = nullptr;
        if (entry)
            found = spec.form == TableForm::named ? named(entry->value, path.name)
                                                  : listed_one(entry->value, path.name);
        if (!found) report_missing(path, spec, entry);
        return found && found->kind == Kind::table ? found : nullptr;
    }

    static TreeValue* named(TreeValue& tables, std::string_view name) {
        TreeEntry* entry = tables.find(name);
        return entry ? &entry->value : nullptr;
    }

    /// By its `name`, else by its number.
    static TreeValue* listed_one(TreeValue& list, std::string_view name) {
        for (TreeValue& item : list.items) {
            const TreeEntry* entry = item.find("name");
            if (entry && entry->value.kind == Kind::text && entry->value.text == name) return &item;
        }
        std::size_t number = 0;
        const auto end = std::from_chars(name.data(), name.data() + name.size(), number);
        const bool is_number = end.ec == std::errc{} && end.ptr == name.data() + name.size() && !name.empty();
        return is_number && number < list.items.size() ? &list.items[number] : nullptr;
    }

    void report_missing(const Path& path, const TableSpec& spec, const TreeEntry* entry) {
        std::vector<std::string> names;
        std::size_t count = 0;
        if (entry) {
            for (const TreeEntry& named : entry->value.entries) names.push_back(named.key);
            for (const TreeValue& item : entry->value.items) {
                const TreeEntry* name = item.find("name");
                if (name && name->value.kind == Kind::text) names.push_back(name->value.text);
            }
            count = entry->value.items.size() + entry->value.entries.size();
        }
        std::string hint = problems_.suggestion(path.name, names);
        if (hint.empty() && count == 0)
            hint = "the scene has no " + std::string(spec.name);
        else if (hint.empty() && spec.form == TableForm::list)
            hint = "the scene has " + std::to_string(count) + ", numbered from 0";
        else if (hint.empty())
            hint = "the scene has " + listed(names);
        fail("no " + std::string(spec.name) + " " + in_quotes(path.name), std::move(hint));
    }

    static std::string example(std::string_view table) {
        const TableSpec& spec = *find_table(table);
        const std::string key(spec.keys.front().key);
        return std::string(table) + (spec.form == TableForm::one ? "." : ".NAME.") + key + "=…";
    }

    static std::vector<std::string> table_names() {
        std::vector<std::string> names;
        for (const TableSpec& spec : table_specs())
            if (spec.form != TableForm::root && spec.form != TableForm::entry) names.emplace_back(spec.name);
        return names;
    }

    std::string suggest(std::string_view word, const std::vector<std::string>& names) const {
        const std::string hint = problems_.suggestion(word, names);
        return hint.empty() ? "expected one of " + listed(names) : hint;
    }

    TreeValue& root_;
    Problems& problems_;
    Place where_;
};

} // namespace

void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems) {
    int origin = 0;
    for (const std::string& text : source.overrides()) {
        const Place where{++origin, 0, 0};
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw Error(ErrorKind::usage, "-D " + text + " has no value",
                        "expected path=value, for example whitted.max_depth=3");
        const std::string_view value = trimmed(std::string_view(text).substr(equals + 1));
        Overrider(root, problems, where)
            .apply(split_path(std::string_view(text).substr(0, equals)), value_of(value, where));
    }
}

} // namespace glint
