// glint check: validates scenes.
#include "commands.h"
#include "frames.h"
#include "scene_input.h"
#include "text.h"

#include <fmt/format.h>

namespace glint::cli {
namespace {

/// "cat.toml: ok (5 objects, 7,000 triangles, 2 lights, 3 materials; 1 warning)"
std::string verdict(const std::string& file, const SceneDescription& description, const SceneStats& stats,
                    std::size_t warning_count) {
    std::string counts = counted(stats.objects, "object");
    if (stats.triangles > 0) counts += ", " + counted(stats.triangles, "triangle");
    counts +=
        ", " + counted(stats.lights, "light") + ", " + counted(description.materials.size(), "material");
    if (warning_count > 0) counts += "; " + counted(warning_count, "warning");
    return fmt::format("{}: ok ({})\n", printable(file), counts);
}

/// Prints all errors of a file; true if there are none.
bool check_file(const std::string& file, const LoadOptions& options, const FrameRange& frames,
                Console& console) {
    try {
        const LoadedScene loaded = read_scene(file, options);
        report(loaded, console);
        if (!loaded.animation.keys.empty())
            for (const int frame : frames.of(loaded.animation)) scene_at(loaded, frame);
        const Scene scene = build_scene(loaded.description);
        const std::vector<Diagnostic> scene_warnings = warnings(scene);
        console.warnings(scene_warnings);
        const std::size_t warning_count = loaded.warnings.size() + scene_warnings.size();
        if (!console.quiet()) print_data(verdict(file, loaded.description, scene.stats(), warning_count));
        return true;
    } catch (const Error& error) {
        // Errors of a file do not stop the check of others.
        if (error.kind() != ErrorKind::input) throw;
        for (const Diagnostic& diagnostic : error.diagnostics()) console.error(diagnostic);
        return false;
    }
}

} // namespace

int check_command(const Arguments& arguments, Console& console) {
    const LoadOptions options = load_options(arguments);
    const FrameRange frames = frame_range(arguments).value_or(FrameRange{.all = true});
    std::size_t bad = 0;
    for (const std::string& file : arguments.operands())
        if (!check_file(file, options, frames, console)) ++bad;

    const std::size_t count = arguments.operands().size();
    if (bad > 0 && count > 1) console.line(fmt::format("{} of {} files have errors", bad, count));
    return bad > 0 ? exit_code::input : exit_code::done;
}

} // namespace glint::cli
