#pragma once
// Timing of builds, each in a new process so that nothing is warm from before.

#include "model.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glint::bench {

/// Result of a build.
struct Built {
    std::shared_ptr<const void> kept; ///< keeps the tree alive until its memory is measured
    double cpu = 0;                   ///< seconds
    std::int64_t own_bytes = 0; ///< memory of nodes and leaves as reported by the library, without vertices
};

struct Builder {
    std::string name;
    std::function<Built(const Model&)> build; ///< on one thread
};

std::vector<Builder> our_builders();
std::vector<Builder> embree_builders(); ///< empty without Embree

/// Measurements of one process.
struct BuildFigures {
    double cpu = 0;              ///< seconds
    std::int64_t own_bytes = 0;  ///< as above
    std::int64_t held_bytes = 0; ///< increase of resident memory by the build
    std::int64_t peak_bytes = 0; ///< increase of peak resident memory during the build; −1 if unknown
};

/// Loads the file, builds, and writes the figures to stdout; run by the child process. Returns false for an
/// unknown builder.
bool build_and_report(const std::string& builder, const std::string& file);

/// Runs this program as a child process and reads its report. Throws std::runtime_error on failure.
BuildFigures build_in_new_process(const std::string& builder, const std::string& file);

} // namespace glint::bench
