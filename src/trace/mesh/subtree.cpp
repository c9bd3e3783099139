// Building a part of a tree: splits down to blocks of eight references, which are cut into leaves by full
// sweeps.

#include "trace/mesh/subtree.h"

#include "trace/mesh/pack.h"

#include <algorithm>

namespace glint::trace {
namespace {

/// Leaf costs relative to visiting a node, measured: a fixed part for one round of eight vertices and
/// triangles, and one for each triangle.
constexpr float leaf_cost_base = 0.7f;
constexpr float leaf_cost_per_triangle = 0.12f;
/// Triangles of ranges of at most this size are prefetched, as they soon become leaves.
constexpr std::size_t prefetch_size = 24;

/// A split candidate of a block.
struct BlockCut {
    std::array<std::uint8_t, max_leaf_size> order; ///< along the axis
    std::uint32_t left = 0;                        ///< number of references on the left
    float cost = infinite;
    SimdBounds left_box, right_box;
};

/// The order of up to eight references along an axis: the rank of each is the number of those before it.
std::array<std::uint8_t, max_leaf_size> order_along(int axis, const PrimRef* refs, std::uint32_t count) {
    std::array<float4, 2> at{splat(infinite), splat(infinite)};
    for (std::uint32_t i = 0; i < count; ++i)
        at[i / 4][i % 4] = refs[i].lo[axis] * 0.5f + refs[i].hi[axis] * 0.5f;
    std::array<int4, 2> rank{};
    const std::array<int4, 2> lane{int4{0, 1, 2, 3}, int4{4, 5, 6, 7}};
    for (std::uint32_t i = 0; i < count; ++i) {
        const float4 x = splat(at[i / 4][i % 4]);
        const auto n = static_cast<std::int32_t>(i);
        const int4 self{n, n, n, n};
        for (std::size_t half = 0; half < 2; ++half)
            rank[half] -= (x < at[half]) | ((x == at[half]) & (self < lane[half]));
    }
    std::array<std::uint8_t, max_leaf_size> order{};
    for (std::uint32_t i = 0; i < count; ++i)
        order[static_cast<std::size_t>(rank[i / 4][i % 4])] = static_cast<std::uint8_t>(i);
    return order;
}

/// Evaluates all cuts along an axis.
void sweep(int axis, const PrimRef* refs, std::uint32_t count, const MeshBuild& build, BlockCut& best) {
    const float scale = build.scale;
    // With pairs, at most one triangle is left over.
    const std::uint32_t step = build.leaf_memory_cost >= 1.0f && count > 2 ? 2 : 1;
    const auto order = order_along(axis, refs, count);
    std::array<SimdBounds, max_leaf_size> right;
    SimdBounds box;
    for (std::uint32_t i = count; --i > 0;) {
        box.grow(refs[order[i]].box());
        right[i] = box;
    }
    box = {};
    for (std::uint32_t i = 1; i < count; ++i) {
        box.grow(refs[order[i - 1]].box());
        if (i % step != 0) continue;
        const float cost = half_area(box, scale) * static_cast<float>(i) +
                           half_area(right[i], scale) * static_cast<float>(count - i);
        if (cost < best.cost) best = {order, i, cost, box, right[i]};
    }
}

/// Population count without a library call: the baseline target has no instruction for it.
std::uint32_t count_bits(std::uint32_t x) {
    x -= x >> 1 & 0x55555555u;
    x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
    return ((x + (x >> 4)) & 0x0f0f0f0fu) * 0x01010101u >> 24;
}

LeafDraft draft_of(const MeshBuild& build, const PrimRef* refs, std::uint32_t count) {
    std::array<std::uint32_t, max_leaf_size> numbers;
    for (std::uint32_t i = 0; i < count; ++i) numbers[i] = refs[i].id();
    return draft_leaf(build.positions, build.triangles, std::span(numbers).first(count),
                      VertexIdentity::position);
}

} // namespace

void SubtreeBuilder::run(const MeshBuild& build, const MeshTop& top, std::uint32_t root, Subtree& subtree) {
    build_ = &build;
    words_ = &subtree.words;
    nodes_.clear();
    subtree.nodes.clear();
    subtree.words.clear();
    nodes_.emplace_back();
    nodes_[0].box = top.nodes[root].box;
    inherit(top, root, 0);

    const auto write_leaf = [&](const BinaryNode& node) {
        if (build.quality == BuildQuality::fast) return node.first;
        return append_leaf(draft_of(build, build.refs + node.first, node.count), subtree.words);
    };
    WideWriter writer(nodes_, subtree.nodes, write_leaf);
    subtree.root = writer.run();
    subtree.depth = writer.depth();
}

std::uint32_t SubtreeBuilder::add_children(const SimdBounds& left, const SimdBounds& right) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back().box = left;
    nodes_.emplace_back().box = right;
    return at;
}

/// Copies the top's nodes and continues below its leaves.
void SubtreeBuilder::inherit(const MeshTop& top, std::uint32_t from, std::uint32_t at) {
    const BinaryNode& node = top.nodes[from];
    if (node.is_leaf) {
        // No spatial splits from here. Without spare capacity no reference moves either, so that a part can
        // be built again.
        PrimRange range = top.ranges[node.first];
        range.limit = range.end;
        return grow(range, at);
    }
    const std::uint32_t children = add_children(top.nodes[node.left].box, top.nodes[node.left + 1].box);
    inherit(top, node.left, children);
    inherit(top, node.left + 1, children + 1);
    set_costs(at, children);
}

void SubtreeBuilder::set_costs(std::uint32_t at, std::uint32_t children) {
    nodes_[at].left = children;
    // With a memory cost, nodes should be full.
    set_split_cost(nodes_[at], nodes_[children], nodes_[children + 1],
                   half_area(nodes_[at].box, build_->scale) + 8.0f * leaf_memory_cost_, infinite);
}

void SubtreeBuilder::grow(const PrimRange& range, std::uint32_t at) {
    if (range.size() <= max_leaf_size) return grow_block(range, at);
    if (range.size() <= prefetch_size)
        for (std::size_t i = range.begin; i < range.end; ++i)
            __builtin_prefetch(&build_->triangles[build_->refs[i].id()]);
    const Binning binning(range.centers, bins_for(range.size(), build_->quality));
    const auto [left, right] = split(*build_, range, binning, bins_, false);
    const std::uint32_t children = add_children(left.box, right.box);
    grow(left, children);
    grow(right, children + 1);
    set_costs(at, children);
}

void SubtreeBuilder::grow_block(const PrimRange& range, std::uint32_t at) {
    block_ = range.begin;
    const auto count = static_cast<std::uint32_t>(range.size());
    draft_ = draft_of(*build_, build_->refs + range.begin, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        order_[i] = static_cast<std::uint8_t>(i);
        vertices_[i] = draft_.vertices_of(i);
    }
    leaf_memory_cost_ = 0;
    if (build_->leaf_memory_cost > 0.0f)
        for (std::uint32_t i = 0; i < count; ++i)
            leaf_memory_cost_ += build_->leaf_memory_cost / static_cast<float>(count) *
                                 half_area(build_->refs[range.begin + i].box(), build_->scale);
    nodes_[at].first = static_cast<std::uint32_t>(range.begin);
    nodes_[at].count = count & 0x3fffffffu;
    cut_block(at);
}

float SubtreeBuilder::leaf_cost(const BinaryNode& node, float area) const {
    std::uint32_t vertices = 0;
    for (std::uint32_t i = 0; i < node.count; ++i) vertices |= vertices_[node.first - block_ + i];
    if (count_bits(vertices) > leaf_vertices) return infinite;
    return area * (leaf_cost_base + leaf_cost_per_triangle * static_cast<float>(node.count)) +
           leaf_memory_cost_;
}

/// Splits down to single triangles or, for the fast quality, to what fits into leaves.
void SubtreeBuilder::cut_block(std::uint32_t at) {
    const std::uint32_t first = nodes_[at].first;
    const std::uint32_t count = nodes_[at].count;
    const float area = half_area(nodes_[at].box, build_->scale);
    const float as_leaf = leaf_cost(nodes_[at], area);
    if (build_->quality == BuildQuality::fast && as_leaf < infinite) {
        // It is final, so write the leaf now.
        nodes_[at].first = append_leaf(
            count == draft_.triangles ? draft_
                                      : part_of(draft_, std::span(order_).subspan(first - block_, count)),
            *words_);
        return set_leaf_cost(nodes_[at], as_leaf);
    }
    if (count == 1) return set_leaf_cost(nodes_[at], as_leaf);

    PrimRef* refs = build_->refs + first;
    BlockCut cut;
    for (int axis = 0; axis < 3; ++axis) sweep(axis, refs, count, *build_, cut);
    std::array<PrimRef, max_leaf_size> old_refs;
    std::array<std::uint32_t, max_leaf_size> old_vertices;
    std::array<std::uint8_t, max_leaf_size> old_order;
    std::copy_n(refs, count, old_refs.begin());
    std::copy_n(vertices_.begin() + static_cast<std::ptrdiff_t>(first - block_), count, old_vertices.begin());
    std::copy_n(order_.begin() + static_cast<std::ptrdiff_t>(first - block_), count, old_order.begin());
    for (std::uint32_t i = 0; i < count; ++i) {
        refs[i] = old_refs[cut.order[i]];
        vertices_[first - block_ + i] = old_vertices[cut.order[i]];
        order_[first - block_ + i] = old_order[cut.order[i]];
    }
    const std::uint32_t children = add_children(cut.left_box, cut.right_box);
    nodes_[children].first = first;
    nodes_[children].count = cut.left & 0x3fffffffu;
    nodes_[children + 1].first = first + cut.left;
    nodes_[children + 1].count = (count - cut.left) & 0x3fffffffu;
    cut_block(children);
    cut_block(children + 1);
    nodes_[at].left = children;
    set_split_cost(nodes_[at], nodes_[children], nodes_[children + 1], area + 8.0f * leaf_memory_cost_,
                   as_leaf);
}

} // namespace glint::trace
