#pragma once
// A binary tree over boxes. Independent of shapes and rays.

#include "math/bounds.h"
#include "math/vec.h"
#include "parallel/task_pool.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::bvh {

/// Upper bound on the depth of leaves for any input: sizes traversal stacks.
inline constexpr int max_tree_depth = 96;

/// A child: an inner node, or a leaf, which is a range of Tree::order.
struct TreeRef {
    std::uint32_t first = 0; ///< index of a node, or of a leaf's first element
    std::uint32_t count = 0; ///< elements of a leaf; 0: a node
};

/// Two children and their boxes in one cache line.
struct alignas(64) TreeNode {
    float lo[3][2]; ///< [axis][child]
    float hi[3][2];
    TreeRef child[2];
};
static_assert(sizeof(TreeNode) == 64);

/// Sets the box of a child of a TreeNode or WideNode, from Bounds or SimdBounds.
template <class Node, class Box>
void set_box(Node& node, std::size_t child, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        node.lo[axis][child] = box.lo[axis];
        node.hi[axis][child] = box.hi[axis];
    }
}
template <class Node>
Bounds child_box(const Node& node, std::size_t child) {
    return {{node.lo[0][child], node.lo[1][child], node.lo[2][child]},
            {node.hi[0][child], node.hi[1][child], node.hi[2][child]}};
}

/// A binary tree of boxes.
struct Tree {
    std::vector<TreeNode> nodes;
    std::vector<std::uint32_t> order; ///< ids in leaf order
    TreeRef root;
    Bounds bounds; ///< of all elements
    int depth = 0; ///< number of nodes on the longest path to a leaf

    bool empty() const { return nodes.empty() && root.count == 0; }
};

/// An element's box and id. Finite, lo <= hi.
struct BoxRef {
    vec3 lo;
    std::uint32_t id;
    vec3 hi;
};

/// Builds a tree by the binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding
/// Volume Hierarchies", 2007) with at most max_leaf elements a leaf. The tree does not depend on the number
/// of threads.
Tree build_tree(const std::vector<BoxRef>& boxes, std::uint32_t max_leaf, parallel::TaskPool& pool);

} // namespace glint::bvh
