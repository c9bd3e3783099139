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
#include <filesystem>
#include <optional>
#include <span>

namespace glint::cli {
namespace {

constexpr const char* pixel_example = "X,Y such as 320,240";

/// --format html: the whole picture, and explanations of a grid of pixels.
std::string page_text(const Scene& scene, const Arguments& arguments, const std::string& title,
                      Backend& backend, Console& console) {
    ExplanationPage page;
    page.scene = title;
    if (const auto grid = arguments.integers("grid", 2, 'x', 1, 4096, "WxH such as 160x90")) {
        page.columns = static_cast<int>((*grid)[0]);
        page.rows = static_cast<int>((*grid)[1]);
    }
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
std::optional<OtherPixel> pixel_on_card(const Scene& scene, int x, int y, Backend& backend) {
    RenderOptions options;
    options.crop = Rect{x, y, 1, 1};
    const std::optional<RenderedPicture> card = backend.render_on_card(scene, options);
    if (!card) return std::nullopt;
    const float* color = card->picture.image.at(0, 0);
    return OtherPixel{card->device, {color[0], color[1], color[2]}};
}

std::string pixel_text(const Scene& scene, const Arguments& arguments, const std::string& title, bool color,
                       Backend& backend) {
    const auto pixel = *arguments.integers("pixel", 2, ',', 0, picture_side_limit, pixel_example);
    const auto x = static_cast<int>(pixel[0]);
    const auto y = static_cast<int>(pixel[1]);
    Explanation explanation = explain(scene, x, y);
    explanation.scene = title;
    explanation.gpu = pixel_on_card(scene, x, y, backend);
    const std::string format = arguments.text("format").value_or("text");
    if (format == "json") return explanation_json(explanation);
    if (format == "svg") return explanation_svg(explanation);
    return explanation_text(explanation, color);
}

/// --format html shows the whole picture, all other formats need a pixel.
void check_pixel_options(const Arguments& arguments) {
    const bool page = arguments.text("format") == "html";
    const auto pixel = arguments.integers("pixel", 2, ',', 0, picture_side_limit, pixel_example);
    if (!page && !pixel)
        throw Error(ErrorKind::usage, "no pixel given",
                    "--pixel X,Y; 0,0 is top left; --format html shows the whole picture");
    if (page && pixel)
        throw Error(ErrorKind::usage, "--pixel is for one pixel, and --format html shows the whole picture");
    if (!page && arguments.has("grid")) throw Error(ErrorKind::usage, "--grid is for --format html");
}

} // namespace

int explain_command(const Arguments& arguments, Console& console) {
    const std::string& file = arguments.operands().front();
    const Output output{"-o", arguments.text("output").value_or("-")};
    check_pixel_options(arguments);
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
    const bool page = arguments.text("format") == "html";
    Backend backend(arguments, console);
    write_text(output, page ? page_text(scene, arguments, title, backend, console)
                            : pixel_text(scene, arguments, title, color, backend));
    return exit_code::done;
}

} // namespace glint::cli
