#pragma once
// Writing files.

#include <cstddef>
#include <span>
#include <string>

namespace glint {

/// Throws the Error(output) that write_file() would throw for this path: missing folder, path is a folder, no
/// permission. Finds out by creating a temporary file, which it removes.
void check_writable(const std::string& path);

/// Writes a file atomically: under a temporary name in the same folder, then fsync and rename. Throws
/// Error(output) with location, cause and cure.
void write_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace glint
