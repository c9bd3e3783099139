#pragma once
// Ordered traversal of a binary tree with a callback for leaves.
//
// A box must not be culled if the test of its contents can hit. With u = 2^-24 and S = max|o| + max|corner|,
// both maximum norms, the triangle test (geometry/triangle.h) hits a triangle whose vertices are displaced by
// at most 7 u S, and rounds t (u S along the ray). The box test rounds the difference of plane and origin
// (u S), the pad (u S), the reciprocal and the product (2 u S along the ray). The sum is below 12 u S, so
// boxes grown by 16 u S on every side are conservative. Errors of quadrics are far smaller.

#include "bvh/float4.h"
#include "bvh/tree.h"
#include "math/ray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace glint::bvh {

/// Constants of the slab test for one ray and tree. Origin and direction must be finite, direction not zero.
struct BoxRay {
    float origin[3];
    float inverse[3]; ///< 1/direction, limited to 10^18 times the smallest of the three: never infinite
    float pad;        ///< boxes are grown by this on every side

    BoxRay(const Ray& ray, const Bounds& bounds) {
        const vec3 d = glm::abs(ray.direction);
        // 1/x overflows below the absolute bound.
        const float min_size = std::max(1e-18f * std::max({d.x, d.y, d.z}), 2.95e-39f);
        float max_origin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float size = 1.0f / std::max(d[axis], min_size);
            origin[axis] = ray.origin[axis];
            inverse[axis] = std::copysign(size, ray.direction[axis]);
            max_origin = std::max(max_origin, std::abs(ray.origin[axis]));
        }
        pad = 0x1p-20f * (max_origin + bounds.max_coordinate());
    }
};

/// The slab test of one axis: narrows [entry, exit] to where the ray is between two planes, moved apart by
/// `pad`. T is float, or a vector for as many boxes at once. Inline: a call costs pictures of glass a tenth.
template <class T>
[[gnu::always_inline]] inline void clip(const T& low, const T& high, float origin, float inverse, float pad,
                                        T& entry, T& exit) {
    // The smaller of the two is the near plane: rounding is monotone and the inverse never 0.
    const T one = (low - origin - pad) * inverse;
    const T other = (high - origin + pad) * inverse;
    const T near = one < other ? one : other;
    const T far = one < other ? other : one;
    entry = near > entry ? near : entry;
    exit = far < exit ? far : exit;
}

/// Where the ray enters the box of a child grown by `pad` within [tmin, limit]; infinite if it misses. For
/// nodes with lo and hi as [axis][child].
template <class Node>
[[gnu::always_inline]] inline float entry_distance(const Node& node, std::size_t child, const BoxRay& ray,
                                                   float pad, float tmin, float limit) {
    for (int axis = 0; axis < 3; ++axis)
        clip(node.lo[axis][child], node.hi[axis][child], ray.origin[axis], ray.inverse[axis], pad, tmin,
             limit);
    return tmin <= limit ? tmin : std::numeric_limits<float>::infinity();
}

/// Narrows [entry, exit] to where the ray is in the boxes of children, the first and those behind it.
template <class Vector, class Node>
[[gnu::always_inline]] inline void clip_boxes(const Node& node, std::size_t first, const BoxRay& ray,
                                              Vector& entry, Vector& exit) {
    for (int axis = 0; axis < 3; ++axis) {
        Vector low;
        Vector high;
        std::memcpy(&low, &node.lo[axis][first], sizeof low);
        std::memcpy(&high, &node.hi[axis][first], sizeof high);
        clip(low, high, ray.origin[axis], ray.inverse[axis], ray.pad, entry, exit);
    }
}

/// Default node callback: does nothing.
struct IgnoredNode {
    void operator()() const {}
};

/// Calls leaf(first, count) for the leaves below `from`, nearest child first. enter(node, entry) computes
/// where the ray enters the two children of a node, with a number above `limit` for a child not to be
/// visited. `leaf` may lower `limit`; it ends the traversal by returning true.
template <class Enter, class Leaf>
void traverse_below(const Tree& tree, TreeRef from, const float& limit, Enter&& enter, Leaf&& leaf) {
    struct Entry {
        TreeRef ref;
        float t;
    };
    Entry stack[max_tree_depth + 1];
    std::size_t size = 0;
    for (TreeRef at = from;;) {
        if (at.count > 0) {
            if (leaf(at.first, at.count)) return;
        } else {
            const TreeRef(&children)[2] = tree.nodes[at.first].child;
            float entry[2];
            enter(at.first, entry);
            const std::size_t near = entry[1] < entry[0] ? 1 : 0;
            if (entry[1 - near] <= limit) stack[size++] = {children[1 - near], entry[1 - near]};
            if (entry[near] <= limit) {
                at = children[near];
                continue;
            }
        }
        // Skip entries behind the closest hit found since they were pushed.
        do {
            if (size == 0) return;
            --size;
        } while (stack[size].t > limit);
        at = stack[size].ref;
    }
}

/// Calls leaf(first, count) for every leaf (a range of tree.order) whose box meets the ray in [tmin, limit],
/// both inclusive and `limit` finite, nearest child first. `leaf` may lower `limit`; it ends the traversal by
/// returning true. `node` is called for every node whose boxes are tested.
template <class Leaf, class Node = IgnoredNode>
void traverse(const Tree& tree, const BoxRay& ray, float tmin, const float& limit, Leaf&& leaf,
              Node node = {}) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (tree.empty()) return;
    const auto enter = [&](std::uint32_t at, float(&entries)[2]) {
        node();
        float2 entry = {-infinity, -infinity};
        float2 exit = {infinity, infinity};
        clip_boxes(tree.nodes[at], 0, ray, entry, exit);
        for (int child = 0; child < 2; ++child)
            entries[child] = entry[child] <= exit[child] && exit[child] >= tmin ? entry[child] : infinity;
    };
    traverse_below(tree, tree.root, limit, enter, leaf);
}

} // namespace glint::bvh
