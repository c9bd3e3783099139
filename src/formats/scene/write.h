#pragma once
// Values of keys as scene files write them.

#include "glint/keys.h"

#include <string>

namespace glint::formats {

std::string toml_text(const KeySpec& key, const KeyValue& value);

/// The default of a key; empty if it has none.
std::string default_text(const KeySpec& key);

} // namespace glint::formats
