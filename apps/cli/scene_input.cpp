// -D, --up, --allow-outside and --threads.
#include "scene_input.h"

namespace glint::cli {

LoadOptions load_options(const Arguments& arguments) {
    LoadOptions options;
    options.overrides = arguments.all("D");
    for (const std::string& override_ : options.overrides)
        if (override_.find('=') == std::string::npos || override_.front() == '=')
            throw Error(ErrorKind::usage, "-D \"" + override_ + "\" sets nothing",
                        "expected path=value, such as -D whitted.max_depth=3");
    options.allow_outside = arguments.has("allow-outside");
    // Alpha is for what stands alone.
    options.floor = !arguments.has("alpha");
    options.up = value_named<Axis>(arguments.text("up").value_or("auto"));
    return options;
}

LoadedScene read_scene(const std::string& path, const LoadOptions& options) {
    LoadedScene loaded = load_scene(path, options);
    if (options.up && !loaded.bare_mesh)
        throw Error(ErrorKind::usage,
                    "--up is for bare meshes, and " + (path == "-" ? "stdin" : path) + " is a scene",
                    "in a scene file, turn the mesh with its transform");
    return loaded;
}

void report(const LoadedScene& loaded, Console& console) {
    for (const std::string& note : loaded.notes) console.note(note);
    console.warnings(loaded.warnings);
}

int threads(const Arguments& arguments) {
    return static_cast<int>(arguments.integer("threads", 0, 1024).value_or(0));
}

} // namespace glint::cli
