#pragma once
// Nodes with eight children, made by collapsing a binary tree at minimal SAH cost.

#include "bvh/float4.h"
#include "bvh/tree.h"
#include "math/index.h"

#include <array>
#include <cstdint>
#include <span>

namespace glint::bvh {

inline constexpr int wide_children = 8;
/// Maximum number of elements in a leaf.
inline constexpr std::uint32_t max_leaf_size = 8;

/// Eight boxes as structure of arrays: seven half cache lines. Boxes of missing children are inverted (lo =
/// +∞, hi = −∞), so a slab test that orders the planes by the ray's direction misses them.
struct alignas(32) WideNode {
    float lo[3][wide_children]; ///< [axis][child]
    float hi[3][wide_children];
    std::uint32_t child[wide_children];
};
static_assert(sizeof(WideNode) == 224);

/// A child code is a node index, or leaf_bit | the user's leaf code, or invalid_index for a missing child.
inline constexpr std::uint32_t leaf_bit = 0x80000000u;

/// A node without children.
WideNode empty_node();
void set_child(WideNode& node, std::size_t child, const SimdBounds& box, std::uint32_t code);

/// Minimal costs of representing a subtree by at most 1, 2 … 7 roots.
using RootCosts = std::array<float, wide_children - 1>;

/// A node of the binary tree to collapse. Its children are adjacent.
struct BinaryNode {
    SimdBounds box;
    RootCosts costs;
    std::uint32_t first = 0; ///< first of `count` elements
    std::uint32_t count : 30 = 0;
    std::uint32_t is_leaf : 1 = 0; ///< as a single root it becomes a leaf, otherwise a wide node
    std::uint32_t is_split : 1 = 0;
    std::uint32_t left = 0; ///< if split, its children are left and left + 1
};

/// Cost of visiting a wide node; leaf costs are relative to it.
inline constexpr float wide_node_cost = 1.0f;

/// Sets the costs of a node that can only be a leaf.
void set_leaf_cost(BinaryNode& node, float cost);

/// Sets the costs of a node over two children with known costs, or of a leaf with `leaf_cost` (infinite: not
/// allowed) if that is cheaper: dynamic programming after Ylitie, Karras, Laine, "Efficient Incoherent Ray
/// Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3. `area` of the node's box in the units of
/// the children's costs.
void set_split_cost(BinaryNode& node, const BinaryNode& left, const BinaryNode& right, float area,
                    float leaf_cost);

/// Binary nodes, at most eight, that become the children of a wide node.
struct WideRoots {
    std::array<std::uint32_t, wide_children> nodes;
    std::uint32_t count = 0;
};
/// The children of a wide node at binary node `at`, which must be split.
WideRoots children_of(std::span<const BinaryNode> tree, std::uint32_t at);

} // namespace glint::bvh
