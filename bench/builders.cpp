#include "builders.h"

#include "peer.h"
#include "rounds.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace glint::bench {
namespace {

/// A line of /proc/self/status in bytes: "VmRSS", "VmHWM".
std::int64_t status_bytes(const std::string& name) {
    std::ifstream in("/proc/self/status");
    std::string word;
    while (in >> word) {
        if (word != name + ":") continue;
        std::int64_t kilobytes = 0;
        in >> kilobytes;
        return kilobytes * 1024;
    }
    return 0;
}

/// Forgets the highest memory use so far; false where the system does not let us.
bool reset_peak() {
    std::ofstream out("/proc/self/clear_refs");
    out << "5" << std::flush;
    return out.good();
}

/// All that a child writes to its end of a pipe.
std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 256> part;
    for (ssize_t n = read(descriptor, part.data(), part.size()); n > 0;
         n = read(descriptor, part.data(), part.size()))
        text.append(part.data(), static_cast<std::size_t>(n));
    return text;
}

} // namespace

std::vector<Builder> our_builders() {
    const auto builder = [](const std::string& name, tracing::BuildQuality quality) {
        return Builder{name, [quality](const Model& model) {
                           const double start = process_seconds();
                           auto mesh = std::make_shared<const tracing::Mesh>(build_ours(model, quality, 1));
                           const double seconds = process_seconds() - start;
                           return Built{mesh, seconds, static_cast<std::int64_t>(mesh->stats().bytes)};
                       }};
    };
    return {builder("glint fast", tracing::BuildQuality::fast),
            builder("glint high", tracing::BuildQuality::high)};
}

bool build_and_report(const std::string& wanted, const std::string& file) {
    std::vector<Builder> all = our_builders();
    for (Builder& builder : embree_builders()) all.push_back(std::move(builder));
    for (const Builder& builder : all) {
        if (builder.name != wanted) continue;
        const Model model = load_model(file);
        malloc_trim(0);
        const std::int64_t before = status_bytes("VmRSS");
        const bool has_peak = reset_peak();
        const Built built = builder.build(model);
        const std::int64_t peak = has_peak ? status_bytes("VmHWM") - before : -1;
        malloc_trim(0);
        const std::int64_t held = status_bytes("VmRSS") - before;
        std::cout << built.cpu << ' ' << built.own_bytes << ' ' << held << ' ' << peak << '\n' << std::flush;
        return true;
    }
    return false;
}

BuildFigures build_in_new_process(const std::string& builder, const std::string& file) {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a build");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process for a build");
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        execl("/proc/self/exe", "glint-bench", "--build-only", builder.c_str(), file.c_str(), nullptr);
        _exit(127);
    }
    close(ends[1]);
    std::istringstream text(read_all(ends[0]));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    BuildFigures figures;
    if (status != 0 ||
        !(text >> figures.cpu >> figures.own_bytes >> figures.held_bytes >> figures.peak_bytes))
        throw std::runtime_error("the build of " + file + " by " + builder + " failed");
    return figures;
}

} // namespace glint::bench
