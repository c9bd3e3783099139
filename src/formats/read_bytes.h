#pragma once

#include "formats/load_watch.h"

#include <cstddef>
#include <string>
#include <vector>

namespace glint {

/// A whole file in memory. Throws Error(input), naming the file, the system's reason and a cure.
std::vector<std::byte> read_bytes(const std::string& path, const LoadWatch& watch = {});

} // namespace glint
