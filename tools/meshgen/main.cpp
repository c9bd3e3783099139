// glint-meshgen: procedural meshes and scenes for examples, tests and benchmarks.

#include "embedded.h"
#include "request.h"
#include "scenes.h"

#include "glint/write_file.h"

#include <cstdio>
#include <exception>

namespace {

using namespace glint;
using namespace glint::meshgen;

void write_scene(const Request& request) {
    const std::string text = request.kind == Kind::flake  ? sphere_flake_scene(request.levels)
                             : request.kind == Kind::city ? city_scene(request.rings)
                                                          : spiral_scene(request.count);
    if (request.output.empty()) {
        std::fwrite(text.data(), 1, text.size(), stdout);
    } else {
        write_file(request.output, std::as_bytes(std::span(text)));
    }
}

void write_mesh(const Request& request) {
    const Mesh mesh = make_mesh(request);
    write_ply(request.output, mesh, request.format);
    std::fprintf(stderr, "%s: %zu vertices, %zu triangles\n", request.output.c_str(), mesh.positions.size(),
                 mesh.triangles.size());
}

int run(const std::vector<std::string>& arguments) {
    const std::optional<Request> request = parse_request(arguments);
    if (!request) {
        std::fputs(embedded_texts[help_text].text, stdout);
    } else if (is_scene(request->kind)) {
        write_scene(*request);
    } else {
        write_mesh(*request);
    }
    return 0;
}

int exit_code(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::usage:
        return 2;
    case ErrorKind::output:
        return 4;
    case ErrorKind::resource:
        return 5;
    default:
        return 70;
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(std::vector<std::string>(argv + 1, argv + argc));
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return exit_code(error.kind());
    } catch (const std::bad_alloc&) {
        std::fputs("glint-meshgen: out of memory: ask for fewer triangles\n", stderr);
        return 5;
    }
}
