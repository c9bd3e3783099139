#pragma once
// Options for reading scenes, shared by several commands.

#include "arguments.h"
#include "console.h"

#include "glint/scene.h"
#include "glint/scene_files.h"

#include <string>

namespace glint::cli {

/// -D, --up and --allow-outside. Throws Error(usage).
LoadOptions load_options(const Arguments& arguments);

/// load_scene(). Throws Error(usage) if --up is given for a scene file.
LoadedScene read_scene(const std::string& path, const LoadOptions& options);

/// Prints the notes and warnings of reading.
void report(const LoadedScene& loaded, Console& console);

/// --threads; 0: one for each processor.
int threads(const Arguments& arguments);

} // namespace glint::cli
