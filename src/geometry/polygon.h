#pragma once
// Triangulation of polygons.

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glint::geometry {

/// Maximum number of corners for ear clipping, whose time is quadratic.
inline constexpr std::size_t max_concave_corners = 10'000;

/// Splits a polygon into corners − 2 triangles of the same orientation, appended to `out`. `corners` are
/// indices into `positions` in order around the polygon; fewer than three append nothing.
///
/// Uses a fan from the first corner if that covers the polygon, as in convex ones, otherwise ear clipping
/// (Meisters 1975; Eberly, "Triangulation by Ear Clipping"). A polygon that is not flat is projected along
/// the dominant axis of its normal; one that crosses itself or has no area also gives corners − 2 triangles,
/// in an unspecified way. Triangles without area occur only if unavoidable. Returns false and appends nothing
/// for a concave polygon of more than `max_concave_corners`.
bool triangulate(std::span<const vec3> positions, std::span<const std::uint32_t> corners,
                 std::vector<uvec3>& out);

} // namespace glint::geometry
