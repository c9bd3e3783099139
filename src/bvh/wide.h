#pragma once
// Nodes of eight children, cut out of a binary tree where that is cheapest.

#include "bvh/quad.h"

#include <array>
#include <cstdint>
#include <span>

namespace glint {

inline constexpr int wide_children = 8;
/// A leaf holds at most this many elements.
inline constexpr std::uint32_t wide_leaf = 8;

/// Eight boxes side by side, by axis: seven half cache lines. The boxes of missing children are inverted (lo
/// = +∞, hi = −∞), so that no ray enters them whose planes are met in order.
struct alignas(32) WideNode {
    float lo[3][wide_children]; ///< [axis][child]
    float hi[3][wide_children];
    std::uint32_t child[wide_children];
};
static_assert(sizeof(WideNode) == 224);

/// Child codes: a node's index, or leaf_bit and what says where the leaf is; `no_child` where there is none.
inline constexpr std::uint32_t leaf_bit = 0x80000000u;
inline constexpr std::uint32_t no_child = 0xffffffffu;

/// A node without children.
WideNode empty_node();
void set_child(WideNode& node, std::size_t child, const QuadBox& box, std::uint32_t code);

/// The least costs of standing for a subtree with at most 1, 2 … 7 roots.
using RootCosts = std::array<float, wide_children - 1>;

/// A node of the binary tree that wide nodes are cut out of. Children lie side by side.
struct BinaryNode {
    QuadBox box;
    RootCosts costs;
    std::uint32_t first = 0; ///< its run of elements
    std::uint32_t count : 30 = 0;
    std::uint32_t is_leaf : 1 = 0; ///< standing for itself: as a leaf, else as a wide node
    std::uint32_t is_split : 1 = 0;
    std::uint32_t left = 0; ///< its children, where it is split: left and left + 1
};

/// A step into a node, against which leaves are priced.
inline constexpr float wide_node_cost = 1.0f;

/// A node that can only stand for itself, as a leaf.
void price_leaf(BinaryNode& node, float cost);

/// A node over two priced children, or a leaf at a price (infinite: it cannot be one), whichever is cheaper:
/// dynamic programming after Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through
/// Compressed Wide BVHs", 2017, section 3. `area` of the node's box in the measure of the children's costs.
void price_split(BinaryNode& node, const BinaryNode& left, const BinaryNode& right, float area,
                 float leaf_cost);

/// The nodes that a wide node over `at` has for children, by their indices; at most eight. `at` is split.
struct WideRoots {
    std::array<std::uint32_t, wide_children> nodes;
    std::uint32_t count = 0;
};
WideRoots children_of(std::span<const BinaryNode> tree, std::uint32_t at);

} // namespace glint
