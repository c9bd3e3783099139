// glint-bench-ply: speed of reading PLY files, each in a new process like a program that opens one mesh.

#include "../tests/kit/temporary_folder.h"
#include "model.h"
#include "process.h"
#include "rounds.h"

#include "glint/mesh_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string_view>

namespace glint::bench {
namespace {

constexpr int rounds = 15;

/// Reads a file twice; prints the CPU seconds of both, its size and its number of triangles.
void read_twice(const std::string& file) {
    double seconds[2];
    std::size_t triangles = 0;
    for (double& taken : seconds) {
        const double start = process_seconds();
        triangles = load_mesh(file).mesh->triangles.size();
        taken = process_seconds() - start;
    }
    std::cout << seconds[0] << ' ' << seconds[1] << ' ' << std::filesystem::file_size(file) << ' '
              << triangles << '\n';
}

std::string row(const std::string& file) {
    std::vector<double> first, again;
    double megabytes = 0;
    std::size_t triangles = 0;
    for (int round = 0; round < rounds; ++round) {
        std::istringstream text(run_self({"--once", file}));
        double seconds[2] = {};
        double bytes = 0;
        text >> seconds[0] >> seconds[1] >> bytes >> triangles;
        megabytes = bytes * 1e-6;
        first.push_back(megabytes / seconds[0]);
        again.push_back(megabytes / seconds[1]);
    }
    return fmt::format("| {} | {} | {:.1f} | {:.0f} | {:.0f} |\n",
                       std::filesystem::path(file).stem().string(), triangles, megabytes, median(first),
                       median(again));
}

int run(std::vector<std::string> files) {
    const test::TemporaryFolder folder;
    if (files.empty()) files.push_back(generate_model("terrain", folder.path()).file);
    std::cout << "MB a CPU second, medians of " << rounds << " new processes:\n\n"
              << "| mesh | triangles | MB | first read | read again |\n|---|---:|---:|---:|---:|\n";
    for (const std::string& file : files) std::cout << row(file) << std::flush;
    return 0;
}

} // namespace
} // namespace glint::bench

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    try {
        if (arguments.size() == 2 && arguments[0] == "--once") {
            glint::bench::read_twice(arguments[1]);
            return 0;
        }
        if (!arguments.empty() && arguments[0].starts_with('-')) {
            std::cerr << "usage: glint-bench-ply [MESH.ply...]   (without files: a terrain of 1,000,000 "
                         "triangles)\n";
            return arguments[0] == "--help" || arguments[0] == "-h" ? 0 : 2;
        }
        return glint::bench::run(arguments);
    } catch (const std::exception& error) {
        std::cerr << "glint-bench-ply: " << error.what() << '\n';
        return 3;
    }
}
