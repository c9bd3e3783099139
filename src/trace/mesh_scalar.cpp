// One ray at a time through a MeshTree, in plain C++: the oracle of the kernels, and what runs where they
// cannot.

#include "bvh/traverse.h"
#include "geometry/triangle.h"
#include "trace/mesh_tree.h"

#include <array>
#include <bit>
#include <cmath>

namespace glint {
namespace {

struct Entry {
    std::uint32_t code;
    float t;
};

/// Where the ray enters a child's box, or a value above `limit` if it does not.
float entry_of(const WideNode& node, int child, const BoxRay& ray, float tmin, float limit) {
    float entry = tmin;
    float exit = limit;
    for (int axis = 0; axis < 3; ++axis) {
        const float one = (node.lo[axis][child] - ray.origin[axis] - ray.pad) * ray.inverse[axis];
        const float other = (node.hi[axis][child] - ray.origin[axis] + ray.pad) * ray.inverse[axis];
        entry = std::max(entry, std::min(one, other));
        exit = std::min(exit, std::max(one, other));
    }
    return entry <= exit ? entry : std::numeric_limits<float>::infinity();
}

/// Tests the triangles of a leaf; true if the search may end.
bool test_leaf(const MeshTree& tree, LeafCode code, const ShearedRay& ray, float tmin, bool any, float& limit,
               TriangleRecord& record) {
    const std::uint32_t* corners = tree.leaf_words.data() + code.word();
    const std::uint32_t n = code.vertices();
    const std::uint32_t* numbers = corners + 4 + 3 * n;
    for (std::uint32_t i = 0; i < code.triangles(); ++i) {
        const std::uint32_t word = corners[i / 2] >> (16 * (i % 2));
        TriangleVertices vertices;
        for (std::uint32_t k = 0; k < 3; ++k)
            for (std::uint32_t axis = 0; axis < 3; ++axis)
                vertices[k][axis] = std::bit_cast<float>(corners[4 + axis * n + (word >> (3 * k) & 7u)]);
        TriangleHit hit;
        if (!intersect_triangle(ray, vertices, tmin, limit, hit)) continue;
        if (any) return true;
        if (hit.t == limit && numbers[i] > record.triangle) continue;
        limit = hit.t;
        record = {hit.t, hit.u, hit.v, numbers[i]};
    }
    return false;
}

bool search(const MeshTree& tree, const Ray& ray, bool any, TriangleRecord& record) {
    const vec3 zero = ray.origin * 0.0f + ray.direction * 0.0f;
    if (tree.nodes.empty() || zero != vec3(0.0f) || ray.direction == vec3(0.0f)) return false;
    const BoxRay box_ray(ray, tree.bounds);
    const ShearedRay sheared(ray);
    float limit = std::nextafter(ray.tmax, -std::numeric_limits<float>::infinity());
    Entry stack[wide_children * (max_tree_depth + 1)];
    std::size_t size = 0;
    stack[size++] = {0, ray.tmin};
    while (size > 0) {
        const Entry at = stack[--size];
        if (at.t > limit) continue;
        if ((at.code & leaf_bit) != 0) {
            if (test_leaf(tree, LeafCode{at.code}, sheared, ray.tmin, any, limit, record)) return true;
            continue;
        }
        const WideNode& node = tree.nodes[at.code];
        const std::size_t base = size;
        for (int child = 0; child < wide_children; ++child) {
            const float t = entry_of(node, child, box_ray, ray.tmin, limit);
            if (node.child[child] == no_child || !(t <= limit)) continue;
            std::size_t place = size++;
            for (; place > base && stack[place - 1].t < t; --place) stack[place] = stack[place - 1];
            stack[place] = {node.child[child], t};
        }
    }
    return false;
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

} // namespace glint
