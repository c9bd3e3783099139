// glint-bench-gpu: tracing and rendering rates of a graphics card.

#include "../tests/kit/temporary_folder.h"
#include "gpu_frames.h"
#include "gpu_rays.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <iostream>

namespace glint::bench {
namespace {

constexpr const char* description =
    R"(Rays and pictures on a graphics card, as Markdown on standard output.

Rays: through a generated knot of 70,000 triangles and the given meshes; a file FILE.cam beside FILE.ply gives
the camera. Pictures: the scenes of a folder, the meshes, and a field of knots with ten million triangles, one
ray a pixel. Times are medians of the device's clock.)";

struct Options {
    std::vector<std::string> files;
    std::string scenes = "scenes/report";
    int device = -1;
    int rounds = 9;
    int rays_size = 1024;
    std::string size = "1920x1080";
    double triangles = 10e6;
};

// Memory traffic and operations of a traversal step, counted in gpu/shaders/trace.glsl: 96 bytes a node and
// eight box tests; for a triangle, three corners with their indices, the shear and three edge functions.
constexpr double bytes_of_node = 96;
constexpr double bytes_of_triangle = 44;
constexpr double operations_of_node = 410;
constexpr double operations_of_triangle = 45;

std::string per_second(double amount, double seconds, double unit) {
    return seconds > 0 ? fmt::format("{:.2f}", amount / seconds / unit) : "–";
}

std::string ray_rows(const std::string& mesh, const std::vector<GpuSetResult>& sets) {
    std::string text;
    for (const GpuSetResult& set : sets) {
        const auto rays = static_cast<double>(set.rays);
        const bool counted = set.nodes > 0;
        const double bytes = bytes_of_node * set.nodes + bytes_of_triangle * set.triangles;
        const double work = operations_of_node * set.nodes + operations_of_triangle * set.triangles;
        const auto number = [&](const char* format, double value) {
            return counted ? fmt::format(fmt::runtime(format), value) : std::string("–");
        };
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", mesh, set.set,
                            set.rays, per_second(rays, set.seconds, 1e6), number("{:.2f}", set.nodes),
                            number("{:.2f}", set.triangles), number("{:.0f}", bytes), number("{:.0f}", work),
                            counted ? per_second(rays * bytes, set.seconds, 1e9) : "–",
                            counted ? per_second(rays * work, set.seconds, 1e9) : "–", set.differences);
    }
    return text;
}

std::string frame_row(const FrameResult& frame) {
    if (!frame.fault.empty())
        return fmt::format("| {} | {} | – | – | – | – | {} |\n", frame.scene, frame.triangles, frame.fault);
    return fmt::format("| {} | {} | {:.2f} | {:.2f} | {} | {} | {:.4f} |\n", frame.scene, frame.triangles,
                       1e3 * frame.device_seconds, 1e3 * frame.whole_seconds, frame.rays,
                       per_second(static_cast<double>(frame.rays), frame.device_seconds, 1e6),
                       100 * (1 - frame.far));
}

std::vector<Model> models_of(const Options& options, const std::string& folder) {
    std::vector<Model> models{generate_model("knot", folder)};
    for (const std::string& file : options.files) models.push_back(load_model(file));
    return models;
}

void print_rays(const Options& options, const gpu::GpuContext& context, GpuRenderer& renderer,
                const std::vector<Model>& models) {
    std::cout << fmt::format(
        "\nRays, {0} × {0} pixels (docs/performance.md has the sets; frame: a picture of the renderer with a "
        "shadow "
        "ray and a mirror ray for each hit); nodes, triangles, bytes and operations are those of one ray:\n\n"
        "| mesh | set | rays | Mrays/s | nodes | triangles | bytes | operations | GB/s | Gop/s | unlike the "
        "CPU |\n"
        "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
        options.rays_size);
    JobOptions jobs;
    jobs.size = options.rays_size;
    for (const Model& model : models) {
        std::cerr << model.name << ": " << model.mesh->triangles.size() << " triangles\n";
        std::cout << ray_rows(model.name, measure_gpu_rays(context, renderer, model, jobs, options.rounds))
                  << std::flush;
    }
}

FrameSize frame_size(const Options& options) {
    FrameSize size;
    char more = 0;
    if (std::sscanf(options.size.c_str(), "%dx%d%c", &size.width, &size.height, &more) != 2 ||
        size.width < 1 || size.height < 1 || size.width > 16384 || size.height > 16384)
        throw Error(ErrorKind::usage, "--size " + options.size + " is no size",
                    "expected WxH such as 1920x1080");
    return size;
}

void print_frames(const Options& options, GpuRenderer& renderer, const std::vector<Model>& models) {
    const FrameSize size = frame_size(options);
    std::cout << fmt::format(
        "\nPictures, {} × {} pixels, one ray a pixel; whole: with sending the work and reading the "
        "picture back:\n\n"
        "| scene | triangles | ms | whole ms | rays | Mrays/s | % within 1/255 of the CPU |\n"
        "|---|---:|---:|---:|---:|---:|---:|\n",
        size.width, size.height);
    for (const FrameResult& frame : measure_folder(renderer, options.scenes, size, options.rounds))
        std::cout << frame_row(frame) << std::flush;
    for (const Model& model : models)
        std::cout << frame_row(
                         measure_frame_of(renderer, model.name, scene_of(model, 64), size, options.rounds))
                  << std::flush;
    std::cout << frame_row(measure_frame_of(
        renderer, "field of knots", field_of(models.front(), options.triangles), size, options.rounds));
}

int run(const Options& options) {
    frame_size(options); // report an invalid size before minutes of work
    const gpu::GpuContext context(options.device);
    GpuRenderer renderer(options.device);
    std::cout << context.device().name << "; " << context.device().driver << "\n" << std::flush;
    const test::TemporaryFolder folder;
    const std::vector<Model> models = models_of(options, folder.path());
    print_rays(options, context, renderer, models);
    print_frames(options, renderer, models);
    return 0;
}

} // namespace
} // namespace glint::bench

int main(int argc, char** argv) {
    using namespace glint;
    bench::Options options;
    CLI::App app(bench::description, "glint-bench-gpu");
    app.add_option("MESH", options.files, "PLY files")->check(CLI::ExistingFile);
    app.add_option("--scenes", options.scenes, "the folder of scenes")
        ->check(CLI::ExistingDirectory)
        ->capture_default_str();
    app.add_option("--device", options.device,
                   "its number in glint info --devices; default: the first usable");
    app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 1000))->capture_default_str();
    app.add_option("--rays-size", options.rays_size, "pixels a side of the sets of rays, a multiple of 8")
        ->check(CLI::Range(8, 8192))
        ->capture_default_str();
    app.add_option("--size", options.size, "of the pictures")->capture_default_str();
    app.add_option("--triangles", options.triangles, "of the field")->capture_default_str();
    try {
        app.parse(argc, argv);
        if (options.rays_size % 8 != 0) throw CLI::ValidationError("--rays-size", "is no multiple of 8");
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    }
    try {
        return bench::run(options);
    } catch (const Error& error) {
        std::cerr << "glint-bench-gpu: " << error.what() << '\n';
        return error.kind() == ErrorKind::device ? 7 : 3;
    } catch (const std::exception& error) {
        std::cerr << "glint-bench-gpu: " << error.what() << '\n';
        return 3;
    }
}
