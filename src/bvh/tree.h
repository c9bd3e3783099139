#pragma once
// Boxes in, tree out. Knows neither shapes nor rays.

#include "math/bounds.h"
#include "math/vec.h"
#include "parallel/task_pool.h"

#include <cstdint>
#include <vector>

namespace glint {

/// No leaf is deeper: bounds the stack of a traversal whatever the input.
inline constexpr int max_tree_depth = 96;

/// What a tree hands to a traversal: an inner node, or a run of Tree::order.
struct TreeRef {
    std::uint32_t first = 0; ///< index of a node, or of the first element of the run
    std::uint32_t count = 0; ///< length of the run; 0: a node
};

/// Two children with their boxes, side by side by axis: one cache line.
struct alignas(64) TreeNode {
    float lo[3][2]; ///< [axis][child]
    float hi[3][2];
    TreeRef child[2];
};
static_assert(sizeof(TreeNode) == 64);

/// A binary tree of boxes.
struct Tree {
    std::vector<TreeNode> nodes;
    std::vector<std::uint32_t> order; ///< ids in the order of the leaves; of no use to a traversal
    TreeRef root;
    Bounds bounds; ///< of everything
    int depth = 0; ///< nodes on the longest way to a leaf

    bool empty() const { return nodes.empty() && root.count == 0; }
};

/// A box and the id of what it bounds. Finite, lo <= hi.
struct BoxRef {
    vec3 lo;
    std::uint32_t id;
    vec3 hi;
};

/// A tree by the surface area heuristic over bins (Wald, "On fast Construction of SAH-based Bounding Volume
/// Hierarchies", 2007), at most max_leaf elements a leaf. The tree depends on the boxes alone, not on the
/// pool.
Tree build_tree(const std::vector<BoxRef>& boxes, std::uint32_t max_leaf, TaskPool& pool);

} // namespace glint
