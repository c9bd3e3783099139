#pragma once
// Writing files.

#include <cstddef>
#include <span>
#include <string>

namespace glint {

/// Throws the Error(output) that write_file() would throw for this path: missing folder, path is a folder, no
/// permission. Finds out by creating a temporary file, which it removes.
void check_writable(const std::string& path);

/// The same text for all names of a file: device and inode, or those of its folder and its name if the file
/// does not exist. Throws Error(output) if the folder does not exist either.
std::string file_identity(const std::string& path);

/// Removes the temporary files of writes under way, for a signal handler that ends the process: uses neither
/// memory nor locks.
void remove_temporary_files() noexcept;

/// Writes a file atomically: under a temporary name in the same folder, then fsync and rename. Throws
/// Error(output) with location, cause and cure.
void write_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace glint
