#pragma once
// Writing files in pieces, and to standard output.

#include "glint/write_file.h"

namespace glint::formats {

/// Consecutive pieces of a file.
using Pieces = std::span<const std::span<const std::byte>>;

/// write_file() of all pieces as one file.
void write_pieces(const std::string& path, Pieces pieces);

/// Writes all bytes to standard output, unchanged. Throws Error(output).
void write_stdout(std::span<const std::byte> bytes);

} // namespace glint::formats
