#include "render_request.h"

#include "outputs.h"
#include "scene_input.h"
#include "text.h"

#include "glint/limits.h"
#include "glint/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace glint::cli {
namespace {

/// Options that the kind of picture has no room for are refused rather than dropped.
void require_format(const Arguments& arguments, const std::string& output) {
    const PictureFormat format = output_format(output);
    const auto refuse = [&](const char* option, const char* formats) {
        if (arguments.has(option))
            throw Error(ErrorKind::usage,
                        fmt::format("--{} is for {}, and {} is not", option, formats, output));
    };
    if (format != PictureFormat::png) {
        refuse("view", ".png");
        refuse("bits", ".png");
    }
    if (format == PictureFormat::pfm) refuse("alpha", ".png and .exr");
    if (format != PictureFormat::exr) refuse("layers", ".exr");
}

/// A picture on a terminal would destroy its settings.
void require_no_terminal(const RenderRequest& request) {
    if (request.output == "-" && isatty(STDOUT_FILENO) == 1)
        throw Error(ErrorKind::usage, "a picture is not written to a terminal",
                    "name a file with -o, or redirect stdout");
}

/// Frames in one file would overwrite each other.
void require_frame_names(const RenderRequest& request) {
    if (request.output == "-" ? request.frames->single()
                              : has_frame_number(request.output) || request.frames->single())
        return;
    throw Error(ErrorKind::usage, fmt::format("all frames would go to {}", shown_name(request.output)),
                "put %04d into the name, where the frame's number goes: -o frame-%04d.png");
}

SimdTarget simd_target(const Arguments& arguments) {
    const auto target = static_cast<SimdTarget>(arguments.choice("simd"));
    if (!is_available(target))
        throw Error(ErrorKind::usage,
                    "--simd " + *arguments.text("simd") + ": this machine or this build has no such vectors",
                    "leave --simd away for the widest there are");
    return target;
}

Aov aov(const Arguments& arguments) {
    const std::string name = arguments.text("show").value_or(aov_name(Aov::final));
    std::vector<std::string> names;
    for (int i = 0; i < aov_count; ++i) {
        names.emplace_back(aov_name(static_cast<Aov>(i)));
        if (name == names.back()) return static_cast<Aov>(i);
    }
    throw Error(ErrorKind::usage, fmt::format("--show knows no \"{}\"", name),
                did_you_mean(name, names, fmt::format("expected one of {}", fmt::join(names, ", "))));
}

/// Layers and alpha belong to the light.
void require_light(const Arguments& arguments, Aov show) {
    for (const char* option : {"layers", "alpha"})
        if (show != Aov::final && arguments.has(option))
            throw Error(ErrorKind::usage,
                        fmt::format("--{} goes with the light, not with --show {}", option, aov_name(show)));
}

RenderOptions render_options(const Arguments& arguments) {
    RenderOptions options;
    options.threads = threads(arguments);
    options.tile_size =
        static_cast<int>(arguments.integer("tile-size", 1, picture_side_limit).value_or(options.tile_size));
    if (const auto crop =
            arguments.integers("crop", 4, ',', 0, picture_side_limit, "X,Y,W,H such as 100,50,64,64")) {
        const auto at = [&](std::size_t i) { return static_cast<int>((*crop)[i]); };
        options.crop = Rect{at(0), at(1), at(2), at(3)};
    }
    options.kernel = {static_cast<Kernel>(arguments.choice("kernel")), simd_target(arguments)};
    options.show = aov(arguments);
    options.terms = arguments.has("layers");
    options.coverage = arguments.has("alpha");
    return options;
}

/// "4", or "1..16": more where neighbours differ.
void apply_samples(const std::string& text, RenderSettings& render) {
    const std::size_t dots = text.find("..");
    const auto least = whole_number(text.substr(0, dots));
    const auto most = dots == std::string::npos ? least : whole_number(text.substr(dots + 2));
    if (!least || !most || *least < 1 || *least > *most || *most > sample_limit)
        throw Error(
            ErrorKind::usage, fmt::format("--spp \"{}\" is not valid", text),
            fmt::format("expected a whole number from 1 to {}, or two of them such as 1..16: that many "
                        "where neighbouring pixels differ",
                        sample_limit));
    render.spp = static_cast<int>(*least);
    render.max_spp = *most > *least ? static_cast<int>(*most) : 0;
}

} // namespace

RenderRequest read_render_request(const Arguments& arguments) {
    RenderRequest request;
    request.scene = arguments.operands().front();
    request.frames = frame_range(arguments);
    request.output =
        arguments.text("output").value_or(default_output(request.scene, request.frames.has_value()));
    request.stats = arguments.text("stats");
    require_format(arguments, request.output);
    if (request.frames) require_frame_names(request);
    require_no_terminal(request);
    request.load = load_options(arguments);
    request.render = render_options(arguments);
    require_light(arguments, request.render.show);
    request.view = static_cast<View>(arguments.choice("view"));
    request.bits = arguments.text("bits") == "16" ? 16 : 8;
    request.keep_partial = arguments.has("keep-partial");
    request.render.coarse_first = request.keep_partial;
    request.dry_run = arguments.has("dry-run");
    // Wrong flags are told before a large scene is read.
    SceneDescription unused;
    apply_flags(arguments, unused);
    // A scene that is not there is told when it is read, not by the name that it would give to a picture.
    std::error_code none;
    if (!arguments.has("output") && request.scene != "-" && !std::filesystem::exists(request.scene, none))
        return request;
    // Which frames are "all" is known once the scene is read.
    const bool known = request.frames && !request.frames->all;
    require_outputs({request.scene},
                    outputs(request, known ? std::vector{request.frames->first} : std::vector<int>()));
    return request;
}

std::vector<Output> outputs(const RenderRequest& request, const std::vector<int>& frames) {
    std::vector<Output> all;
    if (!request.frames) all.push_back({"-o", request.output});
    for (const int frame : frames) all.push_back({"-o", frame_name(request.output, frame)});
    if (request.stats) all.push_back({"--stats", *request.stats});
    return all;
}

/// Flags override what the scene says.
void apply_flags(const Arguments& arguments, SceneDescription& scene) {
    if (const auto size = arguments.integers("size", 2, 'x', 1, picture_side_limit, "WxH such as 1280x720")) {
        if ((*size)[0] * (*size)[1] > picture_pixel_limit)
            throw Error(ErrorKind::usage, fmt::format("--size {} is too large", *arguments.text("size")),
                        fmt::format("at most {} pixels", with_commas(picture_pixel_limit)));
        scene.render.width = static_cast<int>((*size)[0]);
        scene.render.height = static_cast<int>((*size)[1]);
    }
    if (arguments.has("spp")) apply_samples(*arguments.text("spp"), scene.render);
    if (const auto seed = arguments.integer("seed", 0, INT64_MAX))
        scene.render.seed = static_cast<std::uint64_t>(*seed);
    if (const auto depth = arguments.integer("max-depth", 0, 1000))
        scene.whitted.max_depth = static_cast<int>(*depth);
    if (arguments.has("integrator"))
        scene.render.integrator = static_cast<Integrator>(arguments.choice("integrator"));
}

void require_crop_inside(const RenderSettings& settings, const std::optional<Rect>& crop) {
    if (!crop) return;
    const std::string given = fmt::format("--crop {},{},{},{}", crop->x, crop->y, crop->width, crop->height);
    if (crop->width == 0 || crop->height == 0)
        throw Error(ErrorKind::usage, given + " holds no pixel", "expected X,Y,W,H with W and H at least 1");
    if (crop->x + crop->width > settings.width || crop->y + crop->height > settings.height)
        throw Error(ErrorKind::usage, given + " reaches beyond the picture",
                    fmt::format("the picture has {}×{} pixels", settings.width, settings.height));
}

MemoryNeeds memory_needs(const RenderRequest& request, const SceneDescription& scene) {
    const RenderOptions& options = request.render;
    const double pixels = options.crop ? double(options.crop->width) * options.crop->height
                                       : double(scene.render.width) * scene.render.height;
    const double floats = 3 + (options.terms ? 3 * term_count : 0) + (options.coverage ? 1 : 0);
    const double channels = options.coverage ? 4 : 3;
    const bool shows_numbers = options.show != Aov::final;
    MemoryNeeds needs;
    needs.scene = build_memory(scene);
    needs.picture = pixels * floats * sizeof(float);
    switch (output_format(request.output)) {
    case PictureFormat::png: // is encoded in memory, numbers from a picture of their own
        needs.writing = pixels * (channels * request.bits / 8 + (shows_numbers ? 3 * sizeof(float) : 0));
        break;
    case PictureFormat::exr:
        needs.writing = needs.picture;
        break;
    case PictureFormat::pfm: // is written from the picture
        break;
    }
    return needs;
}

} // namespace glint::cli
