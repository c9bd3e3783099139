#pragma once
// A binary tree collapsed to nodes of eight children, cut into leaves where that is cheapest.

#include "bvh/tree.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace glint {

inline constexpr int wide_children = 8;
/// A leaf holds at most this many elements.
inline constexpr std::uint32_t wide_leaf = 8;

/// Eight boxes side by side, by axis: seven half cache lines. The boxes of missing children are inverted (lo
/// = +∞, hi = −∞), so that no ray enters them. What a child is, its code tells: see WideTree.
struct alignas(32) WideNode {
    float lo[3][wide_children]; ///< [axis][child]
    float hi[3][wide_children];
    std::uint32_t child[wide_children];
};
static_assert(sizeof(WideNode) == 224);

/// A run of Tree::order that became one leaf.
struct LeafRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Child codes: a node's index, or leaf_bit | index of a leaf; `no_child` where there is none.
inline constexpr std::uint32_t leaf_bit = 0x80000000u;
inline constexpr std::uint32_t no_child = 0xffffffffu;

struct WideTree {
    std::vector<WideNode> nodes; ///< the first is the root, unless there are none
    std::vector<LeafRun> leaves;
    int depth = 0; ///< nodes on the longest way to a leaf
};

/// The price of a leaf with these elements of Tree::order, in steps into a node; infinite if they do not fit
/// in one. Asked for runs of at most wide_leaf elements; single elements must fit.
using LeafCost = std::function<float(std::uint32_t first, std::uint32_t count)>;

/// The cheapest way, by the surface area heuristic, to merge the nodes of a binary tree into wide ones and
/// runs into leaves: dynamic programming after Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on
/// GPUs Through Compressed Wide BVHs", 2017, section 3. `tree` must be split down to runs that fit into
/// leaves.
WideTree collapse(const Tree& tree, const LeafCost& leaf_cost);

} // namespace glint
