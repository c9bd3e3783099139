#pragma once
// Builds timed one by one, each in a process of its own: nothing that went before helps or hinders.

#include "model.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glint::bench {

/// What a build leaves.
struct Built {
    std::shared_ptr<const void> kept; ///< alive until memory has been measured
    double cpu = 0;                   ///< seconds
    std::int64_t own_bytes = 0; ///< held by tree and leaves, by the library's own count; without the vertices
};

struct Builder {
    std::string name;
    std::function<Built(const Model&)> build; ///< on one thread
};

std::vector<Builder> our_builders();
std::vector<Builder> embree_builders(); ///< none without Embree

/// What one process found.
struct BuildFigures {
    double cpu = 0;              ///< seconds
    std::int64_t own_bytes = 0;  ///< as above
    std::int64_t held_bytes = 0; ///< more resident memory after the build than before it
    std::int64_t peak_bytes =
        0; ///< the most at any time of the build, less what there was before; −1: unknown
};

/// Loads the file, builds, and writes the figures to stdout: what the processes below do. Returns false for
/// an unknown builder.
bool build_and_report(const std::string& builder, const std::string& file);

/// Starts this program anew and reads what it reports. Throws std::runtime_error if it fails.
BuildFigures build_in_new_process(const std::string& builder, const std::string& file);

} // namespace glint::bench
