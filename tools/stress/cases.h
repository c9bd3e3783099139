#pragma once
// Stress tests of the tracing core. A case is given by a family and a seed; it makes a small world, traces
// rays and counts violations. Used by the tests (few cases) and by glint-stress (many).

#include "glint/kernels.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace glint::stress {

/// A combination of kernel and SIMD target.
struct KernelVariant {
    const char* name; ///< as in `glint --kernel … --simd …`
    KernelChoice choice;
};

/// Maximum number of variants.
inline constexpr std::size_t max_variants = 24;

/// Each kernel with each available target; constant during the life of the program.
std::span<const KernelVariant> kernel_variants();

/// Counts of one or more cases.
struct Tally {
    std::uint64_t rays = 0; ///< rays traced, counted once for each variant
    std::uint64_t hits = 0;
    std::uint64_t on_edge = 0;                            ///< rays that hit an edge or a vertex exactly
    std::uint64_t failures = 0;                           ///< differences, leaks and odd counts
    std::array<std::uint64_t, max_variants> by_variant{}; ///< rays traced by kernel_variants()[i]
    std::string first_failure;                            ///< description of the first failure

    void add(const Tally& other);
    void fail(const std::string& what);
};

/// The property that a family tests.
enum class Property {
    agrees,   ///< closest() and occluded() equal brute force bit by bit, with single rays and batches, and
              ///< next() enumerates the hits of all_hits()
    closed,   ///< rays from inside a closed mesh hit it
    crosses,  ///< rays from outside cross a closed mesh an even number of times unless they meet an edge
              ///< exactly
    encloses, ///< rays that start on the surface of a closed solid are on the side that they were sent to
};

struct Family {
    const char* name;
    Property property;
    Tally (*run)(std::uint64_t seed, std::uint32_t rays);
};

/// All families, sorted by property.
std::span<const Family> families();

/// Seed of case `index` of a run.
std::uint64_t case_seed(std::uint64_t seed, std::uint64_t index);

} // namespace glint::stress
