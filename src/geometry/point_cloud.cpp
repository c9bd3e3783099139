#include "geometry/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace glint::geometry {

Bounds cloud_without_outliers(std::span<const vec3> points) {
    constexpr std::size_t enough = 4096, few = 32;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::size_t step = 1 + points.size() / (enough + 1);
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> values;
        for (std::size_t i = 0; i < points.size(); i += step)
            if (std::isfinite(points[i][axis])) values.push_back(points[i][axis]);
        if (values.size() < few) return {vec3(-infinity), vec3(infinity)};
        std::sort(values.begin(), values.end());
        const std::size_t cut = std::max<std::size_t>(1, values.size() / 50);
        box.lo[axis] = values[cut];
        box.hi[axis] = values[values.size() - 1 - cut];
    }
    const vec3 sides = box.extent();
    const float side = std::max({sides.x, sides.y, sides.z});
    if (!(side > 0)) return {vec3(-infinity), vec3(infinity)};
    return {box.lo - side, box.hi + side};
}

double default_point_radius(std::span<const vec3> points) {
    const Bounds kept = cloud_without_outliers(points);
    Bounds bounds;
    for (const vec3& p : points)
        if (kept.contains(p)) bounds.grow(p);
    if (bounds.empty()) return 1;
    const dvec3 d(bounds.extent());
    const double area = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
    const double spacing = std::sqrt(area / static_cast<double>(points.size()));
    if (spacing > 0) return spacing / 2;
    const double length = std::max({d.x, d.y, d.z});
    return length > 0 ? length / (2.0 * static_cast<double>(points.size())) : 1;
}

} // namespace glint::geometry
