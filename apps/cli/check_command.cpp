// glint check: validates scenes.
#include "commands.h"
#include "frames.h"
#include "json_output.h"
#include "scene_input.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint::cli {
namespace {

/// "cat.toml: ok (5 objects, 7,000 triangles, 2 lights, 3 materials; 1 warning)"
std::string verdict(const CheckedFile& checked) {
    const SceneStats& stats = *checked.stats;
    std::string counts = counted(stats.objects, "object");
    if (stats.triangles > 0) counts += ", " + counted(stats.triangles, "triangle");
    counts += ", " + counted(stats.lights, "light") + ", " + counted(checked.materials, "material");
    if (!checked.warnings.empty()) counts += "; " + counted(checked.warnings.size(), "warning");
    return fmt::format("{}: ok ({})\n", printable(checked.file), counts);
}

/// All errors and warnings of a file. Its errors do not stop the check of others.
CheckedFile check_file(const std::string& file, const LoadOptions& options, const FrameRange& frames) {
    CheckedFile checked;
    checked.file = file;
    try {
        const LoadedScene loaded = read_scene(file, options);
        checked.warnings = loaded.warnings;
        checked.notes = loaded.notes;
        checked.materials = loaded.description.materials.size();
        if (!loaded.animation.keys.empty())
            for (const int frame : frames.of(loaded.animation)) scene_at(loaded, frame);
        const Scene scene = build_scene(loaded.description);
        const std::vector<Diagnostic> found = warnings(scene);
        checked.warnings.insert(checked.warnings.end(), found.begin(), found.end());
        checked.stats = scene.stats();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        checked.errors = error.diagnostics();
    }
    return checked;
}

void print(const CheckedFile& checked, Console& console) {
    for (const std::string& note : checked.notes) console.note(note);
    console.warnings(checked.warnings);
    for (const Diagnostic& error : checked.errors) console.error(error);
    if (checked.stats && !console.quiet()) print_data(verdict(checked));
}

} // namespace

int check_command(const Arguments& arguments, Console& console) {
    const LoadOptions options = load_options(arguments);
    const FrameRange frames = frame_range(arguments).value_or(FrameRange{.all = true});
    const bool json = arguments.has("json");
    std::vector<CheckedFile> files;
    for (const std::string& file : arguments.operands()) {
        files.push_back(check_file(file, options, frames));
        if (!json) print(files.back(), console);
    }
    const auto bad = static_cast<std::size_t>(
        std::ranges::count_if(files, [](const CheckedFile& f) { return !f.errors.empty(); }));
    if (json)
        print_data(check_json(files));
    else if (bad > 0 && files.size() > 1)
        console.line(fmt::format("{} of {} files have errors", bad, files.size()));
    return bad > 0 ? exit_code::input : exit_code::done;
}

} // namespace glint::cli
