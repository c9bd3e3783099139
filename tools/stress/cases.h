#pragma once
// Stress cases of the tracing core. A case is a family and a seed; it makes a small world, shoots rays at it
// and counts what must not happen. Used by the tests (some) and by glint-stress (many).

#include "ways.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace glint::stress {

/// What came of one case, or of many.
struct Tally {
    std::uint64_t rays = 0; ///< traced, each way counted
    std::uint64_t hits = 0;
    std::uint64_t on_edge = 0;                     ///< rays whose hits lie exactly on an edge or a vertex
    std::uint64_t failures = 0;                    ///< differences, leaks, odd counts
    std::array<std::uint64_t, most_ways> by_way{}; ///< of `rays`, those that took ways()[i]
    std::string first_failure;                     ///< which ray of which world failed first

    void add(const Tally& other);
    void fail(const std::string& what);
};

/// The claim that a family puts to the test.
enum class Claim {
    agrees,  ///< closest() and occluded() are those of brute force, to the bit, ray by ray and in batches;
             ///< next() gives what crossings() gives
    closed,  ///< a ray from inside a closed mesh hits it
    crosses, ///< a ray from outside crosses a closed mesh an even number of times, unless it meets an edge
             ///< exactly
};

struct Family {
    const char* name;
    Claim claim;
    Tally (*run)(std::uint64_t seed, std::uint32_t rays);
};

/// All families, by claim.
std::span<const Family> families();

/// The seed of case number `index` of a run.
std::uint64_t case_seed(std::uint64_t seed, std::uint64_t index);

} // namespace glint::stress
