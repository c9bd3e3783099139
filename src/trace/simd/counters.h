#pragma once
// Counters of kernel operations, compiled in only if GLINT_TRACE_COUNTERS is defined.

#include <cstdint>

namespace glint::trace {

/// Counts of this thread since its start.
struct TraceCounters {
    std::uint64_t nodes = 0;      ///< nodes visited, once for a group
    std::uint64_t ray_nodes = 0;  ///< tests of a ray against the eight boxes of a node
    std::uint64_t boxes = 0;      ///< tests of a vector of rays against one box
    std::uint64_t leaves = 0;     ///< leaves visited, once for a group
    std::uint64_t ray_leaves = 0; ///< tests of a ray against the triangles of a leaf
    std::uint64_t vectors = 0;    ///< tests of a vector of rays against one triangle
    std::uint64_t exact = 0;      ///< rays or half vectors that reached the exact part of the test
};

#ifdef GLINT_TRACE_COUNTERS
inline thread_local TraceCounters trace_counters;
inline void tally(std::uint64_t TraceCounters::*counter, std::uint64_t steps) {
    trace_counters.*counter += steps;
}
#else
inline void tally(std::uint64_t TraceCounters::*, std::uint64_t) {}
#endif

} // namespace glint::trace
