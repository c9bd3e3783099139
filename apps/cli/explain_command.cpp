// glint explain: why a pixel has its colour.
#include "backend.h"
#include "commands.h"
#include "frames.h"
#include "outputs.h"
#include "progress.h"
#include "render_request.h"
#include "scene_input.h"

#include "glint/explain.h"
#include "glint/explanation_files.h"
#include "glint/limits.h"
#include "glint/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <filesystem>
#include <optional>
#include <span>

namespace glint::cli {
namespace {

/// --format, or what the extension of -o says; text otherwise.
std::string format(const Arguments& arguments) {
    if (const auto given = arguments.text("format")) return *given;
    const std::string extension =
        std::filesystem::path(arguments.text("output").value_or("")).extension().string();
    for (const char* name : {"json", "svg", "html"})
        if (extension == std::string(".") + name) return name;
    return "text";
}

/// --pixel.
std::optional<PixelCoord> pixel(const Arguments& arguments) {
    const auto xy = arguments.integers("pixel", 2, ',', 0, picture_side_limit, "X,Y such as 320,240");
    if (!xy) return std::nullopt;
    return PixelCoord{static_cast<int>((*xy)[0]), static_cast<int>((*xy)[1])};
}

/// --format html: the whole picture, and explanations of a grid of pixels.
std::string page_text(const Scene& scene, const Arguments& arguments, const std::string& title,
                      Backend& backend, Console& console) {
    ExplanationPage page;
    page.scene = title;
    if (const auto grid = arguments.integers("grid", 2, 'x', 1, 4096, "WxH such as 160x90")) {
        page.columns = static_cast<int>((*grid)[0]);
        page.rows = static_cast<int>((*grid)[1]);
    }
    page.pixel = pixel(arguments);
    // Throws for a pixel outside the picture, before the whole picture is rendered.
    if (page.pixel) Explainer(scene).pixel(page.pixel->x, page.pixel->y, {0});
    RenderOptions options;
    options.threads = threads(arguments);
    options.terms = true;
    Picture picture = render(scene, options);
    page.image = std::move(picture.image);
    page.terms = std::move(picture.terms);
    if (std::optional<RenderedPicture> card = backend.render_on_card(scene, {})) {
        page.gpu = card->device;
        page.gpu_image = std::move(card->picture.image);
    }
    // The page has no room for rays of less weight.
    constexpr float min_weight = 1.0f / 4096;
    ProgressMeter meter(console, progress_style("auto"), "explanations");
    const auto begin = std::chrono::steady_clock::now();
    Progress progress;
    page.explain = [&](std::span<const PixelCoord> row) {
        auto explained = explain_pixels(scene, row, {1, min_weight}, options.threads);
        ++progress.tiles_done;
        progress.tiles = static_cast<std::uint64_t>(std::min(page.rows, page.image.height));
        progress.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        meter.update(progress);
        return explained;
    };
    std::string text = explanation_html(page);
    meter.finish();
    return text;
}

/// The pixel as the graphics card renders it, if --backend selects one.
std::optional<OtherPixel> pixel_on_card(const Scene& scene, const PixelCoord& at, Backend& backend) {
    RenderOptions options;
    options.crop = Rect{at.x, at.y, 1, 1};
    const std::optional<RenderedPicture> card = backend.render_on_card(scene, options);
    if (!card) return std::nullopt;
    const float* color = card->picture.image.at(0, 0);
    return OtherPixel{card->device, {color[0], color[1], color[2]}};
}

/// What of the explanation the text shows.
ExplanationTextOptions text_options(const Arguments& arguments, bool color) {
    ExplanationTextOptions options;
    options.color = color;
    options.sample = static_cast<int>(arguments.integer("sample", 0, sample_limit).value_or(0));
    if (const auto ray = arguments.integer("ray", 0, INT_MAX)) options.ray = static_cast<int>(*ray);
    options.steps = arguments.has("steps");
    return options;
}

std::string pixel_text(const Scene& scene, const Arguments& arguments, const std::string& title, bool color,
                       Backend& backend, Console& console) {
    const PixelCoord at = *pixel(arguments);
    Explanation explanation = explain(scene, at.x, at.y);
    explanation.scene = title;
    explanation.gpu = pixel_on_card(scene, at, backend);
    const std::string kind = format(arguments);
    if (kind == "json") return explanation_json(explanation);
    if (kind == "svg") return explanation_svg(explanation);
    const ExplanationTextOptions options = text_options(arguments, color);
    std::string text = explanation_text(explanation, options);
    if (!options.ray && !options.steps)
        console.note("--ray N shows every step of ray N, --steps of all rays" +
                     std::string(explanation.samples.size() > 1 ? "; --sample N the rays of sample N" : ""));
    return text;
}

/// All formats but html need a pixel; some options are for one format alone.
void check_formats(const Arguments& arguments) {
    const std::string kind = format(arguments);
    if (kind != "html" && !pixel(arguments))
        throw Error(ErrorKind::usage, "no pixel given",
                    "--pixel X,Y; 0,0 is top left; --format html shows the whole picture");
    if (kind != "html" && arguments.has("grid")) throw Error(ErrorKind::usage, "--grid is for --format html");
    for (const char* option : {"sample", "ray", "steps"})
        if (kind != "text" && arguments.has(option))
            throw Error(ErrorKind::usage, fmt::format("--{} is for --format text", option),
                        "JSON and pages have every step");
}

} // namespace

int explain_command(const Arguments& arguments, Console& console) {
    const std::string& file = arguments.operands().front();
    const Output output{"-o", arguments.text("output").value_or("-")};
    check_formats(arguments);
    require_outputs({file}, {output});

    const LoadedScene loaded = read_scene(file, load_options(arguments));
    require_outputs(loaded.files, {output});
    SceneDescription description = at_frame(arguments, loaded);
    apply_flags(arguments, description);
    report(loaded, console);
    BuildSceneOptions how;
    how.threads = threads(arguments);
    const Scene scene = build_scene(description, how);
    console.warnings(warnings(scene));
    const std::string title = file == "-" ? "stdin" : std::filesystem::path(file).filename().string();
    const bool color = output.path == "-" && wants_color_on_stdout(arguments.text("color").value_or("auto"));
    Backend backend(arguments, console);
    write_text(output, format(arguments) == "html"
                           ? page_text(scene, arguments, title, backend, console)
                           : pixel_text(scene, arguments, title, color, backend, console));
    return exit_code::done;
}

} // namespace glint::cli
