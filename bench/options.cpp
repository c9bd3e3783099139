// Parsing the command line.

#include "options.h"

#include <CLI/CLI.hpp>

#include <iterator>

namespace glint::bench {
namespace {

constexpr const char* description =
    R"(Measures rays and builds per CPU second of glint and, if it was found, of Embree 3, on one thread.

Without files three meshes are generated: a knot (70,000 triangles), a gyroid (300,000) and a terrain (1,000,000).
A file FILE.cam beside FILE.ply gives the camera, otherwise the mesh is framed:
    eye X Y Z
    target X Y Z
    up X Y Z
    fov DEGREES
Tables go to standard output as Markdown. Exits 1 if two kernels of glint differ in a bit, or Embree in more
than one result in a hundred.)";

} // namespace

Request parse_command_line(int argc, const char* const* argv) {
    Request request;
    Options& options = request.options;
    options.sets.assign(std::begin(job_names), std::end(job_names));
    CLI::App app(description, "glint-bench");
    app.add_option("MESH", options.files, "PLY files")->check(CLI::ExistingFile);
    app.add_option("--sets", options.sets, "of primary, shadow, ao, bounce, frame")
        ->delimiter(',')
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(job_names), std::end(job_names))));
    app.add_option("--rounds", options.rounds, "measurements of each tracer")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--size", options.jobs.size, "pixels a side, a multiple of 8")
        ->check(CLI::Range(8, 8192))
        ->capture_default_str();
    app.add_option("--batch", options.jobs.batch, "rays per call")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "2: also compare glint on two threads with one")
        ->check(CLI::Range(1, 2))
        ->capture_default_str();
    app.add_option("--simd", options.simd, "let glint use no more than plain, sse4, avx2 or avx512")
        ->check(CLI::IsMember({"plain", "sse4", "avx2", "avx512"}));
    app.add_option("--embree-isa", options.isa, "let Embree use no more than sse4.2, avx, avx2 or avx512")
        ->check(CLI::IsMember({"sse4.2", "avx", "avx2", "avx512"}));
    app.add_flag("!--no-robust", options.robust, "without Embree's robust scenes");
    app.add_flag("!--no-builds", options.builds, "without builds");
    app.add_option("--json", options.json, "write all results to this file, with the seconds of each round");
    try {
        app.parse(argc, argv);
        if (options.jobs.size % 8 != 0) throw CLI::ValidationError("--size", "is no multiple of 8");
    } catch (const CLI::ParseError& error) {
        request.exit_status = app.exit(error);
    }
    return request;
}

} // namespace glint::bench
