#pragma once
// Where results go, checked before any work is done for them.

#include "glint/picture_files.h"

#include <functional>
#include <string>
#include <vector>

namespace glint::cli {

/// A file that a command writes; "-" is stdout.
struct Output {
    std::string option; ///< the one that names it
    std::string path;
};

/// The format of picture_format(). Throws Error(usage) where there is none, Error(output) for one that was
/// not built.
PictureFormat output_format(const std::string& path);

/// Throws Error(usage) if an output would overwrite an input or another output, however their names are
/// spelled, and Error(output) if one cannot be written. Of inputs, "-" is stdin.
void require_outputs(const std::vector<std::string>& inputs, const std::vector<Output>& outputs);

/// Calls `write`. The hint of an Error(output) then says which option names another file.
void write_output(const Output& output, const std::function<void()>& write);

/// Writes a file whole or not at all. Throws Error(output).
void write_text(const Output& output, const std::string& text);

/// May writing wait for a program that reads, since the output is a pipe or a device?
bool waits_for_reader(const std::string& path);

/// The scene's stem + ".png", in the working directory; "stdin.png" for "-". Of several frames with "-%04d".
std::string default_output(const std::string& scene, bool frames = false);

/// How messages name an output: "stdout" for "-".
std::string shown_name(const std::string& path);

} // namespace glint::cli
