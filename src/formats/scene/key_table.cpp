// Lookup of tables and keys.

#include "formats/scene/key_table.h"

#include "formats/scene/file_keys.h"

namespace glint {

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

std::vector<std::string> key_names(const TableSpec& table, std::string_view type) {
    std::vector<std::string> names;
    for (const KeySpec& spec : table.keys) {
        const bool new_one = names.empty() || names.back() != spec.key;
        if (new_one && find_key(table, spec.key, type)) names.emplace_back(spec.key);
    }
    return names;
}

std::vector<std::string> choice_names(const KeySpec& key) { return {key.choices.begin(), key.choices.end()}; }

} // namespace glint
