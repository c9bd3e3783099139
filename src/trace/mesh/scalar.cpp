// The scalar kernel: reference for tests, and fallback for machines without SIMD.

#include "math/offset.shared.h"
#include "trace/mesh/walk.h"

namespace glint::trace {
namespace {

bool search(const MeshTree& tree, const Ray& ray, bool any, TriangleRecord& record) {
    if (!is_traceable(ray)) return false;
    const geometry::ShearedRay sheared(ray);
    float limit = limit_below(ray.tmax);
    walk(tree, ray, ray.tmin, limit, [&](LeafCode leaf) {
        for (std::uint32_t i = 0; i < leaf.triangles(); ++i) {
            std::uint32_t number;
            TriangleHit hit;
            if (!geometry::intersect_triangle(sheared, leaf_triangle(tree, leaf, i, number), ray.tmin, limit,
                                              hit))
                continue;
            if (hit.t == limit && number > record.triangle) continue;
            limit = hit.t;
            record = {hit.t, hit.u, hit.v, number};
            if (any) return true;
        }
        return false;
    });
    return record.triangle != invalid_index;
}

} // namespace

TriangleRecord closest_scalar(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    search(tree, ray, false, record);
    return record;
}

bool occluded_scalar(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    return search(tree, ray, true, record);
}

} // namespace glint::trace
