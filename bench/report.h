#pragma once
// What was measured, as tables and as JSON.

#include "builders.h"
#include "options.h"
#include "rounds.h"

#include <string>
#include <vector>

namespace glint::bench {

struct SetResult {
    std::string set;
    std::uint64_t rays = 0;
    std::vector<Peer> peers;                     ///< ours first
    Timings timings;                             ///< by peer and round
    Timings threads;                             ///< ours on one thread and on two; or empty
    std::uint64_t our_differences = 0;           ///< bits of any other way of ours
    std::vector<std::uint64_t> peer_differences; ///< answers, by peer
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

/// Markdown.
std::string tables(const Report& report);
std::string json(const Report& report);

/// One line: the processor, its cores, and how busy the machine is.
std::string machine();

/// Do all agree well enough?
bool agrees(const Report& report);

} // namespace glint::bench
