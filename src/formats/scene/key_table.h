#pragma once
// All tables of scene files: those of a description, and those of files alone.

#include "glint/keys.h"

#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// All tables, in the order of the reference page.
const std::vector<TableSpec>& table_specs();

/// The table with that name; null if there is none. The name of the file itself is "".
const TableSpec* find_table(std::string_view name);

/// The keys of a table of that type, in the order of the reference page.
std::vector<std::string> key_names(const TableSpec& table, std::string_view type);

/// The choices of a key.
std::vector<std::string> choice_names(const KeySpec& key);

} // namespace glint
