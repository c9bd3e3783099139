#pragma once
// Polygons into triangles.

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glint {

/// The most corners of a polygon that needs ear clipping: its time grows with their square.
inline constexpr std::size_t max_concave_corners = 10'000;

/// Splits a polygon into corners − 2 triangles that wind as it does, appended to `out`. `corners` are indices
/// into `positions`, three or more, in order around the polygon; fewer append nothing.
///
/// A fan from the first corner where that covers the polygon (always, when it is convex); ear clipping
/// otherwise (Meisters 1975; Eberly, "Triangulation by Ear Clipping"). A polygon that is not flat is split as
/// its shadow on the axis plane it faces most; one that crosses itself or has no area still gives corners − 2
/// triangles, in an unspecified way. Triangles without area appear only where the shape leaves no other
/// choice. False, and nothing appended: the polygon is concave and has more than `max_concave_corners`.
bool triangulate(std::span<const vec3> positions, std::span<const std::uint32_t> corners,
                 std::vector<uvec3>& out);

} // namespace glint
