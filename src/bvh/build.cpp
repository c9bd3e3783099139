#include "bvh/tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace glint {

namespace {

constexpr int most_bins = 32;
/// From this depth on ranges are halved, which ends after at most 32 more levels.
constexpr int deepest_search = 60;
static_assert(deepest_search + 32 < max_tree_depth);
/// Ranges above this are split one after another, ranges below are one task each.
constexpr std::size_t grain = 8192;
/// Ranges up to this size are halved, not searched, for the fast quality.
constexpr std::size_t fast_halves = 4;
/// Price of a step into a node, in tests of an element.
constexpr double node_cost = 1.0;

/// A run of boxes to be split.
struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
    Bounds box;     ///< of the elements
    Bounds middles; ///< of their centres
    int depth = 0;

    std::size_t size() const { return end - begin; }
};

/// Half of each summand: the sum of two large coordinates would overflow.
vec3 middle(const BoxRef& ref) { return ref.lo * 0.5f + ref.hi * 0.5f; }

void add(Range& range, const BoxRef& ref) {
    range.box.grow(ref.lo);
    range.box.grow(ref.hi);
    range.middles.grow(middle(ref));
}

/// Half the surface in double: no overflow at any float coordinate.
double half_area(const Bounds& box) {
    const dvec3 d = dvec3(box.hi) - dvec3(box.lo);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

struct Bin {
    Bounds box;
    std::uint32_t count = 0;
};

/// Where a range would be cut, and what that would cost in tests of an element.
struct Cut {
    int axis = -1; ///< -1: all centres are one
    int bin = 0;   ///< first bin of the right side
    double cost = std::numeric_limits<double>::infinity();
};

/// Numbers of bins along each axis, by one rule for the search and the partition.
struct Binning {
    vec3 lo;
    vec3 scale; ///< 0 along an axis without extent
    int bins;

    Binning(const Range& range, BuildQuality quality) : lo(range.middles.lo), scale(0.0f) {
        bins = range.size() > 256 ? most_bins : range.size() > 16 ? 16 : 8;
        if (quality == BuildQuality::fast) bins = 8;
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = range.middles.hi[axis] - range.middles.lo[axis];
            const float factor = static_cast<float>(bins) / extent;
            if (extent > 0.0f && std::isfinite(factor) && std::isfinite(extent)) scale[axis] = factor;
        }
    }
    int bin(const vec3& p, int axis) const {
        return std::min(static_cast<int>((p[axis] - lo[axis]) * scale[axis]), bins - 1);
    }
};

using Bins = std::array<std::array<Bin, most_bins>, 3>;

void fill(Bins& bins, const Binning& binning, const BoxRef* begin, const BoxRef* end) {
    for (auto& axis : bins) std::fill_n(axis.begin(), binning.bins, Bin{});
    for (const BoxRef* ref = begin; ref != end; ++ref) {
        const vec3 p = middle(*ref);
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[static_cast<std::size_t>(axis)][static_cast<std::size_t>(binning.bin(p, axis))];
            bin.box.lo = glm::min(bin.box.lo, ref->lo);
            bin.box.hi = glm::max(bin.box.hi, ref->hi);
            ++bin.count;
        }
    }
}

/// Sweeps the bins of one axis from both ends; keeps the cheapest cut in `best`.
void sweep(const std::array<Bin, most_bins>& bins, int count, int axis, Cut& best) {
    std::array<double, most_bins> right_cost;
    Bounds box;
    std::uint32_t elements = 0;
    for (int i = count - 1; i > 0; --i) {
        const Bin& bin = bins[static_cast<std::size_t>(i)];
        box.grow(bin.box);
        elements += bin.count;
        right_cost[static_cast<std::size_t>(i)] = elements > 0 ? half_area(box) * elements : -1.0;
    }
    box = {};
    elements = 0;
    for (int i = 1; i < count; ++i) {
        const Bin& bin = bins[static_cast<std::size_t>(i - 1)];
        box.grow(bin.box);
        elements += bin.count;
        const double right = right_cost[static_cast<std::size_t>(i)];
        if (elements == 0 || right < 0.0) continue;
        const double cost = half_area(box) * elements + right;
        if (cost < best.cost) best = {axis, i, cost};
    }
}

Cut cheapest_cut(const Range& range, const Binning& binning, const BoxRef* refs) {
    Bins bins;
    fill(bins, binning, refs + range.begin, refs + range.end);
    Cut best;
    for (int axis = 0; axis < 3; ++axis)
        if (binning.scale[axis] > 0.0f) sweep(bins[static_cast<std::size_t>(axis)], binning.bins, axis, best);
    return best;
}

std::pair<Range, Range> split_by(const Range& range, const Binning& binning, const Cut& cut, BoxRef* refs) {
    Range left;
    Range right;
    std::size_t i = range.begin;
    std::size_t j = range.end;
    while (i < j) {
        if (binning.bin(middle(refs[i]), cut.axis) < cut.bin) {
            add(left, refs[i++]);
        } else {
            add(right, refs[i]);
            std::swap(refs[i], refs[--j]);
        }
    }
    left.begin = range.begin;
    left.end = right.begin = i;
    right.end = range.end;
    left.depth = right.depth = range.depth + 1;
    return {left, right};
}

/// Halves a range along the longest side of its centres; equal centres go by id.
std::pair<Range, Range> split_in_half(const Range& range, BoxRef* refs) {
    const vec3 d = range.middles.extent();
    const int axis = d.x >= d.y ? (d.x >= d.z ? 0 : 2) : (d.y >= d.z ? 1 : 2);
    const std::size_t half = range.begin + range.size() / 2;
    std::nth_element(refs + range.begin, refs + half, refs + range.end,
                     [axis](const BoxRef& a, const BoxRef& b) {
                         const float x = middle(a)[axis];
                         const float y = middle(b)[axis];
                         return x != y ? x < y : a.id < b.id;
                     });
    Range left{range.begin, half, {}, {}, range.depth + 1};
    Range right{half, range.end, {}, {}, range.depth + 1};
    for (std::size_t i = left.begin; i < left.end; ++i) add(left, refs[i]);
    for (std::size_t i = right.begin; i < right.end; ++i) add(right, refs[i]);
    return {left, right};
}

/// What is asked of all splits.
struct Wish {
    std::uint32_t max_leaf;
    BuildQuality quality;
};

/// Splits the range in two, or decides that it is a leaf (false).
bool split(const Range& range, const Wish& wish, BoxRef* refs, std::pair<Range, Range>& halves) {
    const bool must = range.size() > wish.max_leaf;
    if (range.size() < 2) return false;
    const bool halve = must && wish.quality == BuildQuality::fast && range.size() <= fast_halves;
    if (!halve && range.depth < deepest_search) {
        const Binning binning(range, wish.quality);
        const Cut cut = cheapest_cut(range, binning, refs);
        const double area = half_area(range.box);
        const bool pays = cut.cost + node_cost * area < static_cast<double>(range.size()) * area;
        if (!must && !pays) return false;
        if (cut.axis >= 0) {
            halves = split_by(range, binning, cut, refs);
            return true;
        }
    }
    if (!must) return false;
    halves = split_in_half(range, refs);
    return true;
}

void store_box(TreeNode& node, std::size_t child, const Bounds& box) {
    for (int axis = 0; axis < 3; ++axis) {
        node.lo[axis][child] = box.lo[axis];
        node.hi[axis][child] = box.hi[axis];
    }
}

/// Builds one subtree depth first into a list of its own.
struct Subtree {
    std::vector<TreeNode> nodes;
    TreeRef root;
    int depth = 0;

    TreeRef build(const Range& range, const Wish& wish, BoxRef* refs) {
        depth = std::max(depth, range.depth);
        std::pair<Range, Range> halves;
        if (!split(range, wish, refs, halves))
            return {static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.size())};
        const std::size_t at = nodes.size();
        nodes.emplace_back();
        store_box(nodes[at], 0, halves.first.box);
        store_box(nodes[at], 1, halves.second.box);
        const TreeRef first = build(halves.first, wish, refs);
        const TreeRef second = build(halves.second, wish, refs);
        nodes[at].child[0] = first;
        nodes[at].child[1] = second;
        return {static_cast<std::uint32_t>(at), 0};
    }
};

/// A range of the upper tree and the place that will refer to it.
struct Pending {
    Range range;
    std::size_t parent = 0;
    std::size_t child = 0; ///< 0 or 1; 2: the root
};

/// Splits the large ranges level by level, the ranges of one level side by side; leaves the small ones in
/// order.
std::vector<Pending> build_top(Tree& tree, const Range& root, const Wish& wish, BoxRef* refs,
                               TaskPool& pool) {
    std::vector<Pending> small;
    std::vector<Pending> large;
    (root.size() > grain ? large : small).push_back({root, 0, 2});
    while (!large.empty()) {
        std::vector<std::pair<Range, Range>> halves(large.size());
        pool.run(large.size(), [&](std::size_t i, int) { split(large[i].range, wish, refs, halves[i]); });
        std::vector<Pending> level;
        for (std::size_t i = 0; i < large.size(); ++i) {
            const std::size_t at = tree.nodes.size();
            tree.nodes.emplace_back();
            store_box(tree.nodes[at], 0, halves[i].first.box);
            store_box(tree.nodes[at], 1, halves[i].second.box);
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

/// Moves a finished subtree behind the nodes that are there already.
void append(Tree& tree, const Pending& place, const Subtree& subtree) {
    const std::uint32_t base = static_cast<std::uint32_t>(tree.nodes.size());
    const auto moved = [base](TreeRef ref) { return ref.count > 0 ? ref : TreeRef{ref.first + base, 0}; };
    for (TreeNode node : subtree.nodes) {
        node.child[0] = moved(node.child[0]);
        node.child[1] = moved(node.child[1]);
        tree.nodes.push_back(node);
    }
    (place.child == 2 ? tree.root : tree.nodes[place.parent].child[place.child]) = moved(subtree.root);
    tree.depth = std::max(tree.depth, subtree.depth);
}

} // namespace

Tree build_tree(std::vector<BoxRef> boxes, std::uint32_t max_leaf, TaskPool& pool, BuildQuality quality) {
    Tree tree;
    const Wish wish{max_leaf, quality};
    if (boxes.empty()) return tree;
    Range root{0, boxes.size(), {}, {}, 0};
    for (const BoxRef& ref : boxes) add(root, ref);
    tree.bounds = root.box;

    const std::vector<Pending> small = build_top(tree, root, wish, boxes.data(), pool);
    std::vector<Subtree> subtrees(small.size());
    pool.run(small.size(), [&](std::size_t i, int) {
        subtrees[i].root = subtrees[i].build(small[i].range, wish, boxes.data());
    });

    std::size_t nodes = tree.nodes.size();
    for (const Subtree& subtree : subtrees) nodes += subtree.nodes.size();
    tree.nodes.reserve(nodes);
    for (std::size_t i = 0; i < small.size(); ++i) {
        append(tree, small[i], subtrees[i]);
        subtrees[i] = {};
    }

    tree.order.reserve(boxes.size());
    for (const BoxRef& ref : boxes) tree.order.push_back(ref.id);
    return tree;
}

} // namespace glint
