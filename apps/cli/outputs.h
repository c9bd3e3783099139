#pragma once
// Where results go, checked before any work is done for them.

#include "glint/picture_files.h"

#include <string>

namespace glint::cli {

/// The format of picture_format(). Throws Error(usage) where there is none, Error(output) for one that was
/// not built.
PictureFormat output_format(const std::string& path);

/// Throws Error(output) unless a file can be made in the folder of `path`; "-" always can.
void require_writable(const std::string& path);

/// Writes a file whole or not at all; "-" is stdout. Throws Error(output).
void write_text(const std::string& path, const std::string& text);

/// The scene's stem + ".png", in the working directory; "stdin.png" for "-". Of several frames with "-%04d".
std::string default_output(const std::string& scene, bool frames = false);

/// How messages name an output: "stdout" for "-".
std::string shown_name(const std::string& path);

} // namespace glint::cli
