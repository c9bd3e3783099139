#include "bvh/wide.h"

#include <algorithm>
#include <array>
#include <limits>

namespace glint {
namespace {

constexpr int most_roots = wide_children - 1;
constexpr float infinite = std::numeric_limits<float>::infinity();
/// A step into a node, against which leaves are priced.
constexpr float node_cost = 1.0f;

/// The least costs of standing for a subtree with at most 1, 2 … 7 roots.
using Costs = std::array<float, most_roots>;

/// A subtree of the binary tree: what its parent knows of it.
struct Subtree {
    TreeRef ref;
    Bounds box;
    std::uint32_t first = 0; ///< its run of Tree::order
    std::uint32_t count = 0;
};

Bounds child_box(const TreeNode& node, std::size_t child) {
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = node.lo[axis][child];
        box.hi[axis] = node.hi[axis][child];
    }
    return box;
}

float area(const Bounds& box) {
    const dvec3 d = dvec3(box.hi) - dvec3(box.lo);
    return static_cast<float>(d.x * d.y + d.y * d.z + d.z * d.x);
}

class Collapser {
  public:
    Collapser(const Tree& tree, const LeafCost& leaf_cost)
        : tree_(tree), leaf_cost_(leaf_cost), costs_(tree.nodes.size()), runs_(tree.nodes.size()) {}

    WideTree run() {
        if (tree_.order.empty()) return {};
        Subtree root{tree_.root, tree_.bounds, 0, static_cast<std::uint32_t>(tree_.order.size())};
        measure(root.ref, area(root.box));
        wide_.nodes.emplace_back();
        std::vector<Subtree> roots;
        if (is_leaf(root)) {
            roots.push_back(root);
        } else {
            distribute(root, wide_children, roots);
        }
        fill(0, roots, 1);
        return std::move(wide_);
    }

  private:
    /// Fills in the costs of a subtree, children first; returns its run.
    LeafRun measure(TreeRef ref, float surface) {
        if (ref.count > 0) return {ref.first, ref.count};
        const TreeNode& node = tree_.nodes[ref.first];
        const LeafRun left = measure(node.child[0], area(child_box(node, 0)));
        const LeafRun right = measure(node.child[1], area(child_box(node, 1)));
        const LeafRun run{left.first, left.count + right.count};
        runs_[ref.first] = run;
        Costs& costs = costs_[ref.first];
        const Costs a = costs_of(node, 0);
        const Costs b = costs_of(node, 1);
        const float as_node = surface * node_cost + shared(a, b, wide_children);
        const float as_leaf = run.count <= wide_leaf ? surface * leaf_cost_(run.first, run.count) : infinite;
        costs[0] = std::min(as_node, as_leaf);
        for (int roots = 2; roots <= most_roots; ++roots)
            costs[index(roots)] = std::min(costs[index(roots - 1)], shared(a, b, roots));
        return run;
    }

    static std::size_t index(int roots) { return static_cast<std::size_t>(roots - 1); }

    /// The least cost of two subtrees that share a number of roots.
    static float shared(const Costs& a, const Costs& b, int roots) {
        float best = infinite;
        for (int k = std::max(1, roots - most_roots); k <= std::min(roots - 1, most_roots); ++k)
            best = std::min(best, a[index(k)] + b[index(roots - k)]);
        return best;
    }

    Costs costs_of(const TreeNode& node, std::size_t child) const {
        const TreeRef ref = node.child[child];
        if (ref.count == 0) return costs_[ref.first];
        Costs costs;
        costs.fill(area(child_box(node, child)) * leaf_cost_(ref.first, ref.count));
        return costs;
    }

    Subtree side(const Subtree& of, std::size_t child) const {
        const TreeNode& node = tree_.nodes[of.ref.first];
        const TreeRef ref = node.child[child];
        const LeafRun run = ref.count > 0 ? LeafRun{ref.first, ref.count} : runs_[ref.first];
        return {ref, child_box(node, child), run.first, run.count};
    }

    /// Standing for itself, is it cheaper as a leaf? The same arithmetic as in measure() finds the same
    /// minimum.
    bool is_leaf(const Subtree& s) const {
        if (s.ref.count > 0) return true;
        if (s.count > wide_leaf) return false;
        return area(s.box) * leaf_cost_(s.first, s.count) <= costs_[s.ref.first][0];
    }

    /// The roots that stand for both sides of a subtree, at most `roots` of them.
    void distribute(const Subtree& s, int roots, std::vector<Subtree>& out) const {
        const TreeNode& node = tree_.nodes[s.ref.first];
        const Costs a = costs_of(node, 0);
        const Costs b = costs_of(node, 1);
        const float best = shared(a, b, roots);
        for (int k = std::max(1, roots - most_roots); k <= std::min(roots - 1, most_roots); ++k) {
            if (a[index(k)] + b[index(roots - k)] != best) continue;
            stand_for(side(s, 0), k, out);
            stand_for(side(s, 1), roots - k, out);
            return;
        }
    }

    void stand_for(const Subtree& s, int roots, std::vector<Subtree>& out) const {
        if (s.ref.count > 0) {
            out.push_back(s);
            return;
        }
        // Fewer roots at the same price leave places to others.
        const Costs& costs = costs_[s.ref.first];
        while (roots > 1 && costs[index(roots - 1)] == costs[index(roots)]) --roots;
        if (roots == 1) {
            out.push_back(s);
        } else {
            distribute(s, roots, out);
        }
    }

    void fill(std::uint32_t at, const std::vector<Subtree>& roots, int depth) {
        wide_.depth = std::max(wide_.depth, depth);
        WideNode node;
        for (std::size_t i = 0; i < wide_children; ++i) {
            const bool there = i < roots.size();
            const Bounds box = there ? roots[i].box : Bounds{};
            for (int axis = 0; axis < 3; ++axis) {
                node.lo[axis][i] = box.lo[axis];
                node.hi[axis][i] = box.hi[axis];
            }
            node.child[i] = there ? place(roots[i]) : no_child;
        }
        wide_.nodes[at] = node;
        for (std::size_t i = 0; i < roots.size(); ++i) {
            if ((node.child[i] & leaf_bit) != 0) continue;
            std::vector<Subtree> below;
            distribute(roots[i], wide_children, below);
            fill(node.child[i], below, depth + 1);
        }
    }

    /// Makes room for a child, beside its siblings.
    std::uint32_t place(const Subtree& s) {
        if (is_leaf(s)) {
            wide_.leaves.push_back({s.first, s.count});
            return leaf_bit | static_cast<std::uint32_t>(wide_.leaves.size() - 1);
        }
        wide_.nodes.emplace_back();
        return static_cast<std::uint32_t>(wide_.nodes.size() - 1);
    }

    const Tree& tree_;
    const LeafCost& leaf_cost_;
    std::vector<Costs> costs_;
    std::vector<LeafRun> runs_;
    WideTree wide_;
};

} // namespace

WideTree collapse(const Tree& tree, const LeafCost& leaf_cost) { return Collapser(tree, leaf_cost).run(); }

} // namespace glint
