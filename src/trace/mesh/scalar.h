#pragma once
// One ray through a MeshTree, in plain C++: traversal with a callback for leaves, and the closest triangle.

#include "bvh/traverse.h"
#include "geometry/triangle.h"
#include "math/offset.shared.h"
#include "trace/mesh/tree.h"

#include <bit>

namespace glint::trace {

/// The largest float below tmax: the condition t < tmax is tested as t <= limit.
inline float limit_below(float tmax) { return next_float(tmax, -1.0f); }

/// The vertices and the index of triangle i of a leaf.
inline geometry::TriangleVertices leaf_triangle(const MeshTree& tree, LeafCode leaf, std::uint32_t i,
                                                std::uint32_t& number) {
    const std::uint32_t* words = tree.leaf_words.data() + leaf.word();
    const std::uint32_t n = leaf.vertices();
    const std::uint32_t corners = words[i / 2] >> (16 * (i % 2));
    geometry::TriangleVertices vertices;
    for (std::uint32_t k = 0; k < 3; ++k)
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            vertices[k][axis] = std::bit_cast<float>(words[4 + axis * n + (corners >> (3 * k) & 7u)]);
    number = words[4 + 3 * n + i];
    return vertices;
}

/// Calls leaf(LeafCode) for every leaf whose box meets the ray in [tmin, limit], both inclusive, nearest
/// child first. `leaf` may lower `limit`; it ends the traversal by returning true. The ray must be finite
/// with a non-zero direction. `node` is called for every node whose boxes are tested.
template <class Leaf, class Node = IgnoredNode>
void walk(const MeshTree& tree, const Ray& ray, float tmin, const float& limit, Leaf&& leaf, Node node = {}) {
    struct Entry {
        std::uint32_t code;
        float t;
    };
    if (tree.nodes.empty()) return;
    const BoxRay box_ray(ray, tree.bounds);
    Entry stack[wide_children * (max_tree_depth + 1)];
    std::size_t size = 0;
    stack[size++] = {0, tmin};
    while (size > 0) {
        const Entry at = stack[--size];
        if (at.t > limit) continue;
        if ((at.code & leaf_bit) != 0) {
            if (leaf(LeafCode{at.code})) return;
            continue;
        }
        const WideNode& boxes = tree.nodes[at.code];
        node();
        const std::size_t base = size;
        for (std::size_t first = 0; first < wide_children; first += 4) {
            float4 entry = splat(tmin);
            float4 exit = splat(limit);
            clip_boxes(boxes, first, box_ray, entry, exit);
            for (std::size_t k = 0; k < 4; ++k) {
                const float t = entry[k];
                if (boxes.child[first + k] == invalid_index || !(t <= exit[k])) continue;
                std::size_t slot = size++;
                for (; slot > base && stack[slot - 1].t < t; --slot) stack[slot] = stack[slot - 1];
                stack[slot] = {boxes.child[first + k], t};
            }
        }
    }
}

// ── The scalar kernel: reference for tests, and for machines without SIMD

inline bool search(const MeshTree& tree, const Ray& ray, bool any, TriangleRecord& record) {
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

/// Single-ray queries: the reference for all kernels.
inline TriangleRecord closest_scalar(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    search(tree, ray, false, record);
    return record;
}

inline bool occluded_scalar(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    return search(tree, ray, true, record);
}

} // namespace glint::trace
