#pragma once
// Command line options of the benchmarks.

#include "jobs.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::bench {

struct Options {
    std::vector<std::string> files; ///< PLY files; empty: generated meshes
    std::vector<std::string> sets;  ///< subset of job_names
    JobOptions jobs;
    int rounds = 9;
    int threads = 1;
    std::string simd; ///< maximum instruction set for glint, such as "avx2"; empty: no limit
    std::string isa;  ///< likewise for Embree
    bool robust = true;
    bool builds = true;
    std::string json; ///< output file; empty: none
};

/// The parsed command line. Prints help or errors, and has an exit status if there is nothing to measure.
struct Request {
    Options options;
    std::optional<int> exit_status;
};
Request parse_command_line(int argc, const char* const* argv);

} // namespace glint::bench
