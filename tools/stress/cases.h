#pragma once
// Stress tests of the tracing core. A case is given by a family and a seed; it makes a small world, traces
// rays and counts violations. Used by the tests (few cases) and by glint-stress (many).

#include "ways.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace glint::stress {

/// Counts of one or more cases.
struct Tally {
    std::uint64_t rays = 0; ///< rays traced, counted once for each way
    std::uint64_t hits = 0;
    std::uint64_t on_edge = 0;                    ///< rays that hit an edge or a vertex exactly
    std::uint64_t failures = 0;                   ///< differences, leaks and odd counts
    std::array<std::uint64_t, max_ways> by_way{}; ///< rays traced by ways()[i]
    std::string first_failure;                    ///< description of the first failure

    void add(const Tally& other);
    void fail(const std::string& what);
};

/// The property that a family tests.
enum class Claim {
    agrees,  ///< closest() and occluded() equal brute force bit by bit, with single rays and batches, and
             ///< next() enumerates the hits of crossings()
    closed,  ///< rays from inside a closed mesh hit it
    crosses, ///< rays from outside cross a closed mesh an even number of times unless they meet an edge
             ///< exactly
};

struct Family {
    const char* name;
    Claim claim;
    Tally (*run)(std::uint64_t seed, std::uint32_t rays);
};

/// All families, sorted by claim.
std::span<const Family> families();

/// Seed of case `index` of a run.
std::uint64_t case_seed(std::uint64_t seed, std::uint64_t index);

} // namespace glint::stress
