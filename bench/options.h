#pragma once

#include "jobs.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::bench {

struct Options {
    std::vector<std::string> files; ///< PLY; none: generated meshes
    std::vector<std::string> sets;  ///< of job_names
    JobOptions jobs;
    int rounds = 9;
    int threads = 1;
    std::string simd; ///< what glint may use, as "avx2"; empty: all that the machine has
    std::string isa;  ///< what Embree may use, likewise
    bool robust = true;
    bool builds = true;
    std::string json; ///< file; empty: none
};

/// What the command line asks for. Prints help or errors and gives the exit status where there is nothing to
/// measure.
struct Request {
    Options options;
    std::optional<int> exit_status;
};
Request parse_command_line(int count, const char* const* words);

} // namespace glint::bench
