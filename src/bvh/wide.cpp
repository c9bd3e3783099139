// Collapsing a binary tree into nodes of eight children by dynamic programming.

#include "bvh/wide.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>

namespace glint::bvh {
namespace {

constexpr int max_roots = wide_children - 1;

/// Minimal cost with at most `roots` roots.
float cost_of(const BinaryNode& node, int roots) { return node.costs[static_cast<std::size_t>(roots - 1)]; }

/// Minimal cost of two subtrees with `roots` roots together.
float split_cost(const BinaryNode& a, const BinaryNode& b, int roots) {
    float best = std::numeric_limits<float>::infinity();
    for (int k = std::max(1, roots - max_roots); k <= std::min(roots - 1, max_roots); ++k)
        best = std::min(best, cost_of(a, k) + cost_of(b, roots - k));
    return best;
}

void collect_roots(std::span<const BinaryNode> tree, std::uint32_t at, int roots, WideRoots& out);

/// Appends the roots of both subtrees of a node, at most `roots` together.
void distribute(std::span<const BinaryNode> tree, const BinaryNode& node, int roots, WideRoots& out) {
    const BinaryNode& a = tree[node.left];
    const BinaryNode& b = tree[node.left + 1];
    // The arithmetic of set_split_cost() finds the same minimum.
    const float best = split_cost(a, b, roots);
    int k = std::max(1, roots - max_roots);
    while (cost_of(a, k) + cost_of(b, roots - k) != best) {
        ++k;
        assert(k <= std::min(roots - 1, max_roots));
    }
    collect_roots(tree, node.left, k, out);
    collect_roots(tree, node.left + 1, roots - k, out);
}

/// Appends the cheapest roots of the subtree at `at`, at most `roots` of them.
void collect_roots(std::span<const BinaryNode> tree, std::uint32_t at, int roots, WideRoots& out) {
    const BinaryNode& node = tree[at];
    // Use fewer roots if that costs the same: they are left to other subtrees.
    while (roots > 1 && cost_of(node, roots - 1) == cost_of(node, roots)) --roots;
    if (roots == 1 || !node.is_split) {
        out.nodes[out.count++] = at;
    } else {
        distribute(tree, node, roots, out);
    }
}

} // namespace

WideNode empty_node() {
    WideNode node;
    for (std::size_t child = 0; child < wide_children; ++child)
        set_child(node, child, SimdBounds{}, invalid_index);
    return node;
}

void set_child(WideNode& node, std::size_t child, const SimdBounds& box, std::uint32_t code) {
    assert(child < wide_children);
    set_box(node, child, box);
    node.child[child] = code;
}

void set_leaf_cost(BinaryNode& node, float cost) {
    node.costs.fill(cost);
    node.is_leaf = 1;
}

void set_split_cost(BinaryNode& node, const BinaryNode& left, const BinaryNode& right, float area,
                    float leaf_cost) {
    const float as_node = area * wide_node_cost + split_cost(left, right, wide_children);
    node.is_leaf = leaf_cost <= as_node ? 1 : 0;
    node.is_split = 1;
    node.costs[0] = std::min(as_node, leaf_cost);
    for (int roots = 2; roots <= max_roots; ++roots)
        node.costs[static_cast<std::size_t>(roots - 1)] =
            std::min(node.costs[static_cast<std::size_t>(roots - 2)], split_cost(left, right, roots));
}

WideRoots children_of(std::span<const BinaryNode> tree, std::uint32_t at) {
    assert(tree[at].is_split);
    WideRoots roots;
    distribute(tree, tree[at], wide_children, roots);
    assert(roots.count >= 2 && roots.count <= wide_children);
    return roots;
}

} // namespace glint::bvh
