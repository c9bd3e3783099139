#pragma once
// Ordered traversal of a binary tree with a callback for leaves.
//
// A box must not be culled if the test of its contents can hit. With u = 2^-24 and S = max|o| + max|corner|,
// both maximum norms, the triangle test (geometry/triangle.h) hits a triangle whose vertices are displaced by
// at most 7 u S, and rounds t (u S along the ray). The box test rounds the difference of plane and origin
// (u S), the pad (u S), the reciprocal and the product (2 u S along the ray). The sum is below 12 u S, so
// boxes grown by 16 u S on every side are conservative. Errors of quadrics are far smaller.

#include "bvh/tree.h"
#include "math/ray.h"

#include <algorithm>
#include <cmath>
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
        float largest = 0;
        float corner = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float size = 1.0f / std::max(d[axis], min_size);
            origin[axis] = ray.origin[axis];
            inverse[axis] = std::copysign(size, ray.direction[axis]);
            largest = std::max(largest, std::abs(ray.origin[axis]));
            corner = std::max({corner, std::abs(bounds.lo[axis]), std::abs(bounds.hi[axis])});
        }
        pad = 0x1p-20f * (largest + corner);
    }
};

/// Ray parameters where the ray enters and leaves one child's box; entry > exit if it misses.
inline void clip(const TreeNode& node, int child, const BoxRay& ray, float& entry, float& exit) {
    entry = -std::numeric_limits<float>::infinity();
    exit = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        // The smaller of the two is the near plane: rounding is monotone and the inverse never 0.
        const float one = (node.lo[axis][child] - ray.origin[axis] - ray.pad) * ray.inverse[axis];
        const float other = (node.hi[axis][child] - ray.origin[axis] + ray.pad) * ray.inverse[axis];
        entry = std::max(entry, std::min(one, other));
        exit = std::min(exit, std::max(one, other));
    }
}

/// Default node callback: does nothing.
struct IgnoredNode {
    void operator()() const {}
};

/// Calls leaf(first, count) for every leaf (a range of tree.order) whose box meets the ray in [tmin, limit],
/// both inclusive, nearest child first. `leaf` may lower `limit`; it ends the traversal by returning true.
/// `node` is called for every node whose boxes are tested.
template <class Leaf, class Node = IgnoredNode>
void traverse(const Tree& tree, const BoxRay& ray, float tmin, const float& limit, Leaf&& leaf,
              Node node = {}) {
    struct Entry {
        TreeRef ref;
        float t;
    };
    if (tree.empty()) return;
    Entry stack[max_tree_depth + 1];
    int size = 0;
    TreeRef at = tree.root;
    for (;;) {
        if (at.count > 0) {
            if (leaf(at.first, at.count)) return;
        } else {
            const TreeNode& boxes = tree.nodes[at.first];
            node();
            float entry[2];
            float exit[2];
            clip(boxes, 0, ray, entry[0], exit[0]);
            clip(boxes, 1, ray, entry[1], exit[1]);
            const bool left = entry[0] <= exit[0] && entry[0] <= limit && exit[0] >= tmin;
            const bool right = entry[1] <= exit[1] && entry[1] <= limit && exit[1] >= tmin;
            if (left && right) {
                const int nearer = entry[1] < entry[0] ? 1 : 0;
                stack[size++] = {boxes.child[1 - nearer], entry[1 - nearer]};
                at = boxes.child[nearer];
                continue;
            }
            if (left || right) {
                at = boxes.child[left ? 0 : 1];
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

} // namespace glint::bvh
