#include "bvh/wide.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace glint {
namespace {

constexpr int most_roots = wide_children - 1;

float cost_of(const BinaryNode& node, int roots) { return node.costs[static_cast<std::size_t>(roots - 1)]; }

/// The least cost of two subtrees that share a number of roots.
float shared(const BinaryNode& a, const BinaryNode& b, int roots) {
    float best = std::numeric_limits<float>::infinity();
    for (int k = std::max(1, roots - most_roots); k <= std::min(roots - 1, most_roots); ++k)
        best = std::min(best, cost_of(a, k) + cost_of(b, roots - k));
    return best;
}

void stand_for(std::span<const BinaryNode> tree, std::uint32_t at, int roots, WideRoots& out);

/// The roots that stand for both sides of a node, at most `roots` of them.
void distribute(std::span<const BinaryNode> tree, const BinaryNode& node, int roots, WideRoots& out) {
    const BinaryNode& a = tree[node.left];
    const BinaryNode& b = tree[node.left + 1];
    // The same arithmetic as when it was priced finds the same minimum.
    const float best = shared(a, b, roots);
    int k = std::max(1, roots - most_roots);
    while (cost_of(a, k) + cost_of(b, roots - k) != best) ++k;
    stand_for(tree, node.left, k, out);
    stand_for(tree, node.left + 1, roots - k, out);
}

void stand_for(std::span<const BinaryNode> tree, std::uint32_t at, int roots, WideRoots& out) {
    const BinaryNode& node = tree[at];
    // Fewer roots at the same price leave places to others.
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
    for (std::size_t child = 0; child < wide_children; ++child) set_child(node, child, QuadBox{}, no_child);
    return node;
}

void set_child(WideNode& node, std::size_t child, const QuadBox& box, std::uint32_t code) {
    for (int axis = 0; axis < 3; ++axis) {
        node.lo[axis][child] = box.lo[axis];
        node.hi[axis][child] = box.hi[axis];
    }
    node.child[child] = code;
}

void price_leaf(BinaryNode& node, float cost) {
    node.costs.fill(cost);
    node.is_leaf = 1;
}

void price_split(BinaryNode& node, const BinaryNode& left, const BinaryNode& right, float area,
                 float leaf_cost) {
    const float as_node = area * wide_node_cost + shared(left, right, wide_children);
    node.is_leaf = leaf_cost <= as_node ? 1 : 0;
    node.is_split = 1;
    node.costs[0] = std::min(as_node, leaf_cost);
    for (int roots = 2; roots <= most_roots; ++roots)
        node.costs[static_cast<std::size_t>(roots - 1)] =
            std::min(node.costs[static_cast<std::size_t>(roots - 2)], shared(left, right, roots));
}

WideRoots children_of(std::span<const BinaryNode> tree, std::uint32_t at) {
    WideRoots roots;
    distribute(tree, tree[at], wide_children, roots);
    return roots;
}

} // namespace glint
