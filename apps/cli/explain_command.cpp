#include "commands.h"
#include "frames.h"
#include "outputs.h"
#include "render_request.h"
#include "scene_input.h"

#include "glint/explain.h"
#include "glint/formats.h"

#include <fmt/format.h>

#include <filesystem>

namespace glint::cli {
namespace {

std::string written(const Explanation& explanation, const Arguments& arguments, bool to_stdout) {
    const std::string format = arguments.text("format").value_or("text");
    if (format == "json") return explanation_json(explanation);
    if (format == "svg") return explanation_svg(explanation);
    return explanation_text(explanation,
                            to_stdout && wants_color_on_stdout(arguments.text("color").value_or("auto")));
}

} // namespace

int explain_command(const Arguments& arguments, Console& console) {
    const std::string& file = arguments.operands().front();
    const std::string output = arguments.text("output").value_or("-");
    const auto pixel = arguments.integers("pixel", 2, ',', 0, most_pixels_a_side, "X,Y such as 320,240");
    if (!pixel) throw Error(ErrorKind::usage, "no pixel given", "--pixel X,Y; 0,0 is top left");
    require_mesh_for_up(arguments, file);
    require_writable(output);

    const LoadedScene loaded = load_scene(file, load_options(arguments));
    SceneDescription description = at_frame(arguments, loaded);
    apply_flags(arguments, description);
    report(loaded, console);
    FreezeOptions how;
    how.threads = threads(arguments);
    const Scene scene = freeze(description, how);
    console.warnings(warnings(scene));
    Explanation explanation = explain(scene, static_cast<int>((*pixel)[0]), static_cast<int>((*pixel)[1]));
    explanation.scene = file == "-" ? "stdin" : std::filesystem::path(file).filename().string();
    write_text(output, written(explanation, arguments, output == "-"));
    return exit_code::done;
}

} // namespace glint::cli
