#pragma once
// The cases behind families(): soups of triangles and quadrics against brute force, and closed meshes.

#include "cases.h"

namespace glint::stress {

enum class Soup {
    random,
    needles,
    slivers,
    axis_aligned,
    coplanar,
    duplicates,
    zero_area,
    quadrics,
    mixed,
    instanced
};

/// Property::agrees: trees give the results of brute force.
Tally run_soup(Soup kind, std::uint64_t seed, std::uint32_t rays);

enum class Closed { icosphere, torus, polyhedron, knot };

/// Property::closed. Not for the knot, for which no interior points are known.
Tally run_inside(Closed kind, std::uint64_t seed, std::uint32_t rays);
/// Property::crosses.
Tally run_through(Closed kind, std::uint64_t seed, std::uint32_t rays);

enum class Enclosed {
    polyhedron,
    flat,  ///< pyramids, prisms and lenses with edges down to 1°
    faces, ///< polyhedra of which each triangle is an object
    wide,  ///< polyhedra a thousand to a million times as large as what is seen of them
    icosphere,
    torus,
    knot,
    instance, ///< sheared, and mirrored half the time
    quadric
};

/// Property::encloses.
Tally run_enclosed(Enclosed kind, std::uint64_t seed, std::uint32_t rays);

} // namespace glint::stress
