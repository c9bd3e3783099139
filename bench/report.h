#pragma once
// The measurements as tables and JSON.

#include "builders.h"
#include "options.h"
#include "rounds.h"

#include <string>
#include <vector>

namespace glint::bench {

struct SetResult {
    std::string set;
    std::uint64_t rays = 0;
    std::vector<Peer> peers;                     ///< glint first
    Timings timings;                             ///< by peer and round
    Timings threads;                             ///< glint on one thread and on two; may be empty
    std::uint64_t our_differences = 0;           ///< results of glint's other kernels that differ in any bit
    std::vector<std::uint64_t> peer_differences; ///< differing results by peer
};

struct BuildResult {
    std::string builder;
    std::vector<BuildFigures> rounds;
};

struct ModelResult {
    std::string name;
    std::size_t triangles = 0;
    std::vector<SetResult> sets;
    std::vector<BuildResult> builds;
};

struct Report {
    Options options;
    std::vector<ModelResult> models;
};

/// Tables in Markdown.
std::string tables(const Report& report);
std::string json(const Report& report);

/// One line with the processor, its cores, the load average and the compiler.
std::string machine();

/// Whether the results of all peers agree well enough.
bool agrees(const Report& report);

} // namespace glint::bench
