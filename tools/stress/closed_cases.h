#pragma once
// Cases of Claim::closed and Claim::crosses: closed meshes have no leaks.

#include "cases.h"

namespace glint::stress {

enum class Closed { icosphere, torus, polyhedron, knot };

/// Not for the knot, for which no interior points are known.
Tally run_inside(Closed kind, std::uint64_t seed, std::uint32_t rays);
Tally run_through(Closed kind, std::uint64_t seed, std::uint32_t rays);

template <Closed kind>
Tally inside_hits(std::uint64_t seed, std::uint32_t rays) {
    return run_inside(kind, seed, rays);
}
template <Closed kind>
Tally crosses_evenly(std::uint64_t seed, std::uint32_t rays) {
    return run_through(kind, seed, rays);
}

} // namespace glint::stress
