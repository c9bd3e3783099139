#pragma once
// Writing files.

#include <cstddef>
#include <span>
#include <string>

namespace glint {

/// Writes a file atomically: under a temporary name in the same folder, then fsync and rename. Throws
/// Error(output) with location, cause and cure.
void write_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace glint
