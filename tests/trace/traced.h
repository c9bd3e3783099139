#pragma once
// Triangles and rays for glint/trace.h, and their hits by brute force.

#include "glint/trace.h"

#include <cstdint>
#include <vector>

namespace glint::tracing {

inline constexpr RayHint hints[] = {RayHint::coherent, RayHint::incoherent};

struct Soup {
    std::vector<float> xyz;
    std::vector<std::uint32_t> corners;

    std::size_t triangles() const { return corners.size() / 3; }
};

/// In [0, 1), a function of both.
float draw(std::uint32_t key, std::uint32_t index);

/// Small triangles scattered in the unit cube, some duplicated, some degenerate.
Soup make_soup(std::uint32_t seed, std::uint32_t count);

/// Parallel, axis-parallel and scattered rays, long and short; every eighth passes exactly through a vertex
/// of the soup, and some can hit nothing: NaN, infinite, or without direction.
std::vector<Ray> make_rays(const Soup& soup, std::uint32_t seed, std::uint32_t count);

/// The least (t, triangle) over all triangles.
Hit brute_force(const Soup& soup, const Ray& ray);

bool same_bits(const Hit& a, const Hit& b);

} // namespace glint::tracing
