// Measuring time and memory of builds through child processes.

#include "builders.h"

#include "peer.h"
#include "process.h"
#include "rounds.h"

#include <malloc.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace glint::bench {
namespace {

/// Reads a line of /proc/self/status, such as "VmRSS" or "VmHWM", in bytes.
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

/// Resets the peak memory counter; returns false if the system forbids it.
bool reset_peak() {
    std::ofstream out("/proc/self/clear_refs");
    out << "5" << std::flush;
    return out.good();
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
    std::istringstream text(run_self({"--build-only", builder, file}));
    BuildFigures figures;
    if (!(text >> figures.cpu >> figures.own_bytes >> figures.held_bytes >> figures.peak_bytes))
        throw std::runtime_error("the build of " + file + " by " + builder + " failed");
    return figures;
}

} // namespace glint::bench
