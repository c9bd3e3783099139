// The top of the tree: large ranges level by level with parallel binning, then one task for each small range.

#include "trace/mesh/top.h"

#include "parallel/in_order.h"

#include <algorithm>
#include <utility>

namespace glint::trace {
namespace {

/// Larger ranges are split level by level, with references binned in chunks of this size for any number of
/// threads. Smaller ranges are one task each.
constexpr std::size_t chunk = 32768;
/// Maximum number of references of a part.
constexpr std::uint32_t max_part_size = 8192;
/// Lower estimate of the average number of references in the top's leaves.
constexpr std::size_t expected_grain = top_grain / 2;
/// Cost saved, relative to visiting a node, by representing a range of some hundred references by 1, 2 … 7
/// roots instead of one. Measured on scans and architecture, where it varies by few per cent.
constexpr RootCosts saved_by_roots{0.0f, 0.28f, 0.45f, 0.585f, 0.71f, 0.82f, 0.915f};

Binning binning_of(const MeshBuild& build, const PrimRange& range) {
    return {range.centers, bins_for(range.size(), build.quality)};
}

void make_leaf(MeshTop& top, const PrimRange& range, std::uint32_t node) {
    top.nodes[node].box = range.box;
    top.nodes[node].first = static_cast<std::uint32_t>(top.ranges.size());
    top.nodes[node].count = static_cast<std::uint32_t>(range.size()) & 0x3fffffffu;
    top.nodes[node].is_leaf = 1;
    top.ranges.push_back(range);
}

/// Appends the children of a split node.
std::uint32_t add_children(MeshTop& top, const PrimRange& range, std::uint32_t node) {
    const auto children = static_cast<std::uint32_t>(top.nodes.size());
    top.nodes[node].box = range.box;
    top.nodes[node].left = children;
    top.nodes[node].is_split = 1;
    top.nodes.resize(top.nodes.size() + 2);
    return children;
}

/// Splits a range depth first.
void grow(const MeshBuild& build, const PrimRange& range, std::uint32_t node, Bins& bins, MeshTop& top) {
    if (range.capacity() <= top_grain) return make_leaf(top, range, node);
    const auto [left, right] = split(build, range, binning_of(build, range), bins, false);
    const std::uint32_t children = add_children(top, range, node);
    grow(build, left, children, bins, top);
    grow(build, right, children + 1, bins, top);
}

/// Replaces a node by a tree.
void graft(MeshTop& top, std::uint32_t node, const MeshTop& branch) {
    // Node 0 replaces `node`, the others are appended.
    const auto nodes_before = static_cast<std::uint32_t>(top.nodes.size()) - 1;
    const auto ranges_before = static_cast<std::uint32_t>(top.ranges.size());
    for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
        BinaryNode moved = branch.nodes[i];
        if (moved.is_split) moved.left += nodes_before;
        if (moved.is_leaf) moved.first += ranges_before;
        if (i == 0)
            top.nodes[node] = moved;
        else
            top.nodes.push_back(moved);
    }
    top.ranges.insert(top.ranges.end(), branch.ranges.begin(), branch.ranges.end());
}

struct Pending {
    PrimRange range;
    std::uint32_t node;
    std::vector<Bins> bins{}; ///< one for each chunk
};

class TopBuilder {
  public:
    TopBuilder(const MeshBuild& build, parallel::TaskPool& pool) : build_(build), pool_(pool) {}

    MeshTop run(const PrimRange& root) {
        top_.nodes.emplace_back();
        add(root, 0);
        while (!large_.empty()) split_level();
        grow_small();
        return std::move(top_);
    }

  private:
    void add(const PrimRange& range, std::uint32_t node) {
        (range.size() > chunk ? large_ : small_).push_back({range, node});
    }

    void split_level() {
        fill_bins();
        std::vector<std::pair<PrimRange, PrimRange>> halves(large_.size());
        pool_.run(large_.size(), [&](std::size_t i, int) { halves[i] = halve(large_[i]); });
        const std::vector<Pending> level = std::exchange(large_, {});
        for (std::size_t i = 0; i < level.size(); ++i) {
            const std::uint32_t children = add_children(top_, level[i].range, level[i].node);
            add(halves[i].first, children);
            add(halves[i].second, children + 1);
        }
    }

    /// Bins all chunks of all ranges of a level in parallel.
    void fill_bins() {
        std::vector<std::pair<std::size_t, std::size_t>> tasks;
        for (std::size_t i = 0; i < large_.size(); ++i) {
            large_[i].bins.resize((large_[i].range.size() + chunk - 1) / chunk);
            for (std::size_t k = 0; k < large_[i].bins.size(); ++k) tasks.push_back({i, k});
        }
        pool_.run(tasks.size(), [&](std::size_t task, int) {
            Pending& pending = large_[tasks[task].first];
            Bins& bins = pending.bins[tasks[task].second];
            const Binning binning = binning_of(build_, pending.range);
            const std::size_t begin = pending.range.begin + tasks[task].second * chunk;
            bins.clear(binning.bins);
            bins.fill(binning, build_.refs + begin, build_.refs + std::min(begin + chunk, pending.range.end));
        });
    }

    std::pair<PrimRange, PrimRange> halve(Pending& pending) const {
        const Binning binning = binning_of(build_, pending.range);
        for (std::size_t k = 1; k < pending.bins.size(); ++k)
            pending.bins[0].add(pending.bins[k], binning.bins);
        return split(build_, pending.range, binning, pending.bins[0], true);
    }

    void grow_small() {
        top_.nodes.reserve(top_.nodes.size() + 2 * build_.triangles.size() / expected_grain);
        top_.ranges.reserve(build_.triangles.size() / expected_grain);
        std::vector<Bins> bins(static_cast<std::size_t>(pool_.threads()));
        parallel::run_in_order<MeshTop>(
            pool_, small_.size(),
            [&](std::size_t i, int worker, MeshTop& branch) {
                branch.nodes.assign(1, {});
                branch.ranges.clear();
                grow(build_, small_[i].range, 0, bins[static_cast<std::size_t>(worker)], branch);
            },
            [&](std::size_t i, const MeshTop& branch) { graft(top_, small_[i].node, branch); });
    }

    const MeshBuild& build_;
    parallel::TaskPool& pool_;
    MeshTop top_;
    std::vector<Pending> large_;
    std::vector<Pending> small_;
};

void collect_parts(const MeshTop& top, std::uint32_t at, std::vector<std::uint32_t>& parts) {
    const BinaryNode& node = top.nodes[at];
    if (node.is_leaf || node.count <= max_part_size) {
        parts.push_back(at);
        return;
    }
    const WideRoots roots = children_of(top.nodes, at);
    for (std::uint32_t i = 0; i < roots.count; ++i) collect_parts(top, roots.nodes[i], parts);
}

} // namespace

MeshTop build_top(const MeshBuild& build, const PrimRange& root, parallel::TaskPool& pool) {
    return TopBuilder(build, pool).run(root);
}

std::vector<std::uint32_t> choose_parts(MeshTop& top, float scale) {
    for (std::size_t at = top.nodes.size(); at-- > 0;) {
        BinaryNode& node = top.nodes[at];
        const float area = half_area(node.box, scale);
        if (node.is_leaf) {
            for (std::size_t i = 0; i < node.costs.size(); ++i)
                node.costs[i] = area * (wide_node_cost - saved_by_roots[i]);
        } else {
            const BinaryNode& left = top.nodes[node.left];
            const BinaryNode& right = top.nodes[node.left + 1];
            node.count = (left.count + right.count) & 0x3fffffffu;
            set_split_cost(node, left, right, area, infinite);
        }
    }
    std::vector<std::uint32_t> parts;
    collect_parts(top, 0, parts);
    return parts;
}

} // namespace glint::trace
