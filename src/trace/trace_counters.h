#pragma once
// What the kernels do, counted where the build defines GLINT_TRACE_COUNTERS; else nothing is left of it.

#include <cstdint>

namespace glint {

/// Steps of the kernels on this thread since it began.
struct TraceCounters {
    std::uint64_t nodes = 0;      ///< nodes visited, once for all rays of a group
    std::uint64_t ray_nodes = 0;  ///< single rays against the eight boxes of a node
    std::uint64_t boxes = 0;      ///< vectors of rays against one box
    std::uint64_t leaves = 0;     ///< leaves visited, once for all rays of a group
    std::uint64_t ray_leaves = 0; ///< single rays against the triangles of a leaf
    std::uint64_t vectors = 0;    ///< vectors of rays against one triangle
    std::uint64_t exact = 0;      ///< single rays or half vectors that took the exact part of the test
};

#ifdef GLINT_TRACE_COUNTERS
inline thread_local TraceCounters trace_counters;
inline void tally(std::uint64_t TraceCounters::*counter, std::uint64_t steps) {
    trace_counters.*counter += steps;
}
#else
inline void tally(std::uint64_t TraceCounters::*, std::uint64_t) {}
#endif

} // namespace glint
