#pragma once
// The library's way to the disk; glint::write_file() is declared in glint/formats.h.

#include <cstddef>
#include <span>
#include <string>

namespace glint {

/// Throws the Error(output) that write_file() would throw for the path alone: a missing folder, a folder in
/// place of a file, no permission. Writes nothing.
void check_writable(const std::string& path);

/// Pieces of a file, one behind the other.
using Pieces = std::span<const std::span<const std::byte>>;

/// write_file() of all pieces as one file.
void write_pieces(const std::string& path, Pieces pieces);

/// Writes all bytes to standard output, unchanged. Throws Error(output).
void write_stdout(std::span<const std::byte> bytes);

} // namespace glint
