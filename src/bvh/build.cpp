// The builder of binary trees: large ranges level by level, then one task for each small range.

#include "bvh/split.h"
#include "bvh/tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace glint::bvh {

namespace {

static_assert(max_sah_depth + 32 < max_tree_depth);
/// Larger ranges are split level by level; each smaller range becomes one task.
constexpr std::size_t grain = 8192;
/// Cost of visiting a node relative to testing one element.
constexpr float node_cost = 1.0f;

/// Parameters shared by all splits.
struct Build {
    PrimRef* refs;
    std::uint32_t max_leaf;
    float scale; ///< of areas
};

/// Splits a range in two; returns false if it should be a leaf.
bool split(const Build& build, const PrimRange& range, std::pair<PrimRange, PrimRange>& halves) {
    const bool must = range.size() > build.max_leaf;
    if (range.size() < 2) return false;
    if (range.depth < max_sah_depth) {
        const Binning binning(range.centers, range.size() > 256 ? max_bins : range.size() > 16 ? 16 : 8);
        Bins bins;
        bins.clear(binning.bins);
        bins.fill(binning, build.refs + range.begin, build.refs + range.end);
        const Cut cut = cheapest_cut(bins, binning, build.scale);
        const float area = half_area(range.box, build.scale);
        const bool pays = cut.cost + node_cost * area < static_cast<float>(range.size()) * area;
        if (!must && !pays) return false;
        if (cut.axis >= 0) {
            halves = split_by(range, bins, binning, cut, build.refs);
            return true;
        }
    }
    if (!must) return false;
    halves = split_in_half(range, build.refs);
    return true;
}

/// Appends a node over two ranges.
std::size_t add_node(std::vector<TreeNode>& nodes, const std::pair<PrimRange, PrimRange>& halves) {
    nodes.emplace_back();
    set_box(nodes.back(), 0, halves.first.box);
    set_box(nodes.back(), 1, halves.second.box);
    return nodes.size() - 1;
}

/// A subtree built depth first with its own node numbering.
struct Subtree {
    std::vector<TreeNode> nodes;
    TreeRef root;
    int depth = 0;

    TreeRef grow(const Build& build, const PrimRange& range) {
        depth = std::max(depth, range.depth);
        std::pair<PrimRange, PrimRange> halves;
        if (!split(build, range, halves))
            return {static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.size())};
        const std::size_t at = add_node(nodes, halves);
        const TreeRef first = grow(build, halves.first);
        const TreeRef second = grow(build, halves.second);
        nodes[at].child[0] = first;
        nodes[at].child[1] = second;
        return {static_cast<std::uint32_t>(at), 0};
    }
};

/// A range of the upper tree and the child slot that will refer to it.
struct Pending {
    PrimRange range;
    std::size_t parent = 0;
    std::size_t child = 0; ///< 0 or 1; 2: the root
};

/// Splits large ranges level by level, those of one level in parallel. Returns the small ranges in order.
std::vector<Pending> build_top(Tree& tree, const Build& build, const PrimRange& root,
                               parallel::TaskPool& pool) {
    std::vector<Pending> small;
    std::vector<Pending> large;
    (root.size() > grain ? large : small).push_back({root, 0, 2});
    while (!large.empty()) {
        std::vector<std::pair<PrimRange, PrimRange>> halves(large.size());
        pool.run(large.size(), [&](std::size_t i, int) { split(build, large[i].range, halves[i]); });
        std::vector<Pending> level;
        for (std::size_t i = 0; i < large.size(); ++i) {
            const std::size_t at = add_node(tree.nodes, halves[i]);
            const TreeRef self{static_cast<std::uint32_t>(at), 0};
            (large[i].child == 2 ? tree.root : tree.nodes[large[i].parent].child[large[i].child]) = self;
            level.push_back({halves[i].first, at, 0});
            level.push_back({halves[i].second, at, 1});
        }
        large.clear();
        for (const Pending& next : level) (next.range.size() > grain ? large : small).push_back(next);
    }
    return small;
}

/// Appends a subtree to the tree and links it to its slot.
void append(Tree& tree, const Pending& slot, const Subtree& subtree) {
    const std::uint32_t base = static_cast<std::uint32_t>(tree.nodes.size());
    const auto moved = [base](TreeRef ref) { return ref.count > 0 ? ref : TreeRef{ref.first + base, 0}; };
    for (TreeNode node : subtree.nodes) {
        node.child[0] = moved(node.child[0]);
        node.child[1] = moved(node.child[1]);
        tree.nodes.push_back(node);
    }
    (slot.child == 2 ? tree.root : tree.nodes[slot.parent].child[slot.child]) = moved(subtree.root);
    tree.depth = std::max(tree.depth, subtree.depth);
}

/// Finite, lo <= hi.
[[maybe_unused]] bool is_valid(const BoxRef& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(box.lo[axis]) || !std::isfinite(box.hi[axis]) || box.lo[axis] > box.hi[axis])
            return false;
    return true;
}

} // namespace

Tree build_tree(const std::vector<BoxRef>& boxes, std::uint32_t max_leaf, parallel::TaskPool& pool) {
    Tree tree;
    if (boxes.empty()) return tree;
    std::vector<PrimRef> refs;
    refs.reserve(boxes.size());
    PrimRange root;
    for (const BoxRef& box : boxes) {
        assert(is_valid(box));
        refs.push_back(PrimRef::of(to_float4(box.lo), to_float4(box.hi), box.id));
        root.add(refs.back());
    }
    root.end = root.limit = refs.size();
    tree.bounds = root.box.bounds();

    const Build build{refs.data(), max_leaf, area_scale(root.box)};
    const std::vector<Pending> small = build_top(tree, build, root, pool);
    std::vector<Subtree> subtrees(small.size());
    pool.run(small.size(),
             [&](std::size_t i, int) { subtrees[i].root = subtrees[i].grow(build, small[i].range); });

    std::size_t nodes = tree.nodes.size();
    for (const Subtree& subtree : subtrees) nodes += subtree.nodes.size();
    tree.nodes.reserve(nodes);
    for (std::size_t i = 0; i < small.size(); ++i) {
        append(tree, small[i], subtrees[i]);
        subtrees[i] = {};
    }

    assert(tree.depth <= max_tree_depth);
    tree.order.reserve(refs.size());
    for (const PrimRef& ref : refs) tree.order.push_back(ref.id());
    return tree;
}

} // namespace glint::bvh
