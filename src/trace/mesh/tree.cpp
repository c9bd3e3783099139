// Building a MeshTree: first the top, then the parts below it, one task each. Each part is appended as soon
// as all parts before it are there, so nothing of the whole tree is held twice.

#include "trace/mesh/tree.h"

#include "parallel/in_order.h"
#include "parallel/large_pages.h"
#include "trace/mesh/pack.h"
#include "trace/mesh/subtree.h"
#include "trace/mesh/top.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace glint::trace {
namespace {

/// Triangles per task.
constexpr std::size_t triangles_per_task = 32768;

/// Maximum number of references: a clipped triangle counts once for each part.
std::size_t room_for(std::size_t triangles, BuildQuality quality) {
    return quality == BuildQuality::high ? triangles + triangles * 15 / 100 : triangles;
}

/// Every 17th triangle is measured for MeshTree::depth_complexity: a prime, as grids are periodic.
constexpr std::size_t sampling_stride = 17;

double area_of(const vec3& a, const vec3& b, const vec3& c) {
    return 0.5 * glm::length(glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a)));
}

struct References {
    PrimRange all;
    double surface = 0; ///< estimate
};

/// Fills in references to all triangles with finite vertices, in order.
References fill_refs(std::span<const vec3> positions, std::span<const uvec3> triangles, PrimRef* refs,
                     parallel::TaskPool& pool) {
    std::vector<PrimRange> parts((triangles.size() + triangles_per_task - 1) / triangles_per_task);
    std::vector<double> surfaces(parts.size());
    pool.run(parts.size(), [&](std::size_t task, int) {
        PrimRange part;
        part.begin = part.end = task * triangles_per_task;
        double areas = 0;
        int samples = 0;
        for (std::size_t i = part.begin; i < std::min(part.begin + triangles_per_task, triangles.size());
             ++i) {
            const vec3& a = positions[triangles[i].x];
            const vec3& b = positions[triangles[i].y];
            const vec3& c = positions[triangles[i].z];
            if (!is_finite(a) || !is_finite(b) || !is_finite(c)) continue;
            SimdBounds box{to_float4(a), to_float4(a)};
            box.grow(to_float4(b));
            box.grow(to_float4(c));
            if (part.size() % sampling_stride == 0) {
                areas += area_of(a, b, c);
                ++samples;
            }
            refs[part.end] = PrimRef::of(box.lo, box.hi, static_cast<std::uint32_t>(i));
            part.add(refs[part.end++]);
        }
        parts[task] = part;
        if (samples > 0) surfaces[task] = areas * static_cast<double>(part.size()) / samples;
    });
    PrimRange all;
    for (const PrimRange& part : parts) {
        if (all.end != part.begin) std::copy(refs + part.begin, refs + part.end, refs + all.end);
        all.end += part.size();
        all.box.grow(part.box);
        all.centers.grow(part.centers);
    }
    all.limit = all.end;
    return {all, std::accumulate(surfaces.begin(), surfaces.end(), 0.0)};
}

/// With at least this many parts, about a sixteenth of them is built first to learn the memory use of leaves;
/// otherwise all are.
constexpr std::size_t min_sampled_parts = 32;

/// Whether a part belongs to the sample, which is scattered, as neighbours are similar.
bool is_sampled(std::size_t part) { return (static_cast<std::uint32_t>(part) * 0x9e3779b9u) >> 28 == 0; }

/// Memory budget in bytes a triangle, with and without shared vertices.
constexpr double budget_shared = 47.5;
constexpr double budget_unshared = 71.5;
/// Values of MeshBuild::leaf_memory_cost to try.
constexpr std::array<float, 5> leaf_memory_costs{0.0f, 0.25f, 1.0f, 8.0f, 30000.0f};

/// Whether triangles share vertices, judged by the numbers of both.
bool shares_vertices(const MeshBuild& build) { return build.positions.size() < 2 * build.triangles.size(); }

/// The binary tree above the parts; each part is a leaf with its index in `first`.
class UpperTree {
  public:
    UpperTree(const MeshTop& top, const std::vector<std::uint32_t>& parts, float scale)
        : top_(top), parts_(parts), scale_(scale), nodes_(1) {
        copy(0, 0);
    }
    const std::vector<BinaryNode>& nodes() const { return nodes_; }

  private:
    void copy(std::uint32_t from, std::size_t to) {
        const BinaryNode& node = top_.nodes[from];
        nodes_[to].box = node.box;
        // Parts are visited in order. The cost of a part does not depend on what is above it, so it counts as
        // 0.
        if (next_ < parts_.size() && from == parts_[next_]) {
            nodes_[to].first = next_++;
            return set_leaf_cost(nodes_[to], 0.0f);
        }
        const std::size_t children = nodes_.size();
        nodes_[to].left = static_cast<std::uint32_t>(children);
        nodes_.resize(children + 2);
        copy(node.left, children);
        copy(node.left + 1, children + 1);
        set_split_cost(nodes_[to], nodes_[children], nodes_[children + 1], half_area(nodes_[to].box, scale_),
                       infinite);
    }

    const MeshTop& top_;
    const std::vector<std::uint32_t>& parts_;
    float scale_;
    std::vector<BinaryNode> nodes_;
    std::uint32_t next_ = 0; ///< part
};

/// Writes a tree: first the nodes above the parts, then the parts one after another.
class TreeWriter {
  public:
    TreeWriter(const MeshBuild& build, const MeshTop& top, const std::vector<std::uint32_t>& parts,
               MeshTree& tree)
        : tree_(tree), parts_(parts.size()) {
        // Estimates of bytes a reference that are rarely too low.
        const bool shares = shares_vertices(build);
        const std::size_t node_bytes = shares ? 16 : 24;
        const std::size_t leaf_bytes = shares ? 40 : 56;
        const std::size_t references = top.nodes[0].count;
        tree_.nodes.reserve(parts.size() + references * node_bytes / sizeof(WideNode));
        tree_.leaf_words.reserve(tail_words + references * leaf_bytes / sizeof(std::uint32_t));
        const UpperTree upper(top, parts, build.scale);
        const auto number = [](const BinaryNode& leaf) { return leaf_bit | leaf.first; };
        WideWriter(upper.nodes(), tree_.nodes, number).run();
        upper_nodes_ = tree_.nodes.size();
    }

    /// Memory of all parts added, in bytes.
    std::size_t bytes() const { return tree_.bytes() - upper_nodes_ * sizeof(WideNode); }

    /// Removes all parts.
    void clear() {
        tree_.nodes.resize(upper_nodes_);
        tree_.leaf_words.clear();
    }

    void add(std::size_t part, const Subtree& subtree) {
        const auto nodes = static_cast<std::uint32_t>(tree_.nodes.size());
        assert(tree_.leaf_words.size() % 4 == 0 && subtree.words.size() % 4 == 0);
        const auto blocks = static_cast<std::uint32_t>(tree_.leaf_words.size() / 4);
        if (blocks + subtree.words.size() / 4 > max_leaf_blocks) throw_too_many_leaves();
        const auto moved = [&](std::uint32_t code) {
            return code == invalid_index ? code : code + ((code & leaf_bit) != 0 ? blocks : nodes);
        };
        tree_.leaf_words.resize(4 * std::size_t{blocks} + subtree.words.size());
        std::copy(subtree.words.begin(), subtree.words.end(),
                  tree_.leaf_words.begin() + 4 * std::ptrdiff_t{blocks});
        tree_.nodes.resize(nodes + subtree.nodes.size());
        WideNode* out = tree_.nodes.data() + nodes;
        for (const WideNode& node : subtree.nodes) {
            *out = node;
            for (std::uint32_t& child : out->child) child = moved(child);
            ++out;
        }
        parts_[part] = {moved(subtree.root), subtree.depth};
    }

    /// To be called when all parts were added.
    void finish() {
        assert(std::none_of(parts_.begin(), parts_.end(),
                            [](const Part& part) { return part.root == invalid_index; }));
        link();
        assert(tree_.depth <= max_tree_depth);
        tree_.leaf_words.resize(tree_.leaf_words.size() + tail_words, 0u);
        parallel::return_unused(tree_.nodes);
        parallel::return_unused(tree_.leaf_words);
    }

  private:
    struct Part {
        std::uint32_t root = invalid_index;
        int depth = 0;
    };

    /// Replaces the parts' indices by their roots.
    void link() {
        if (upper_nodes_ == 0) return promote_only_part();
        std::vector<int> heights(upper_nodes_, 1);
        for (std::size_t at = upper_nodes_; at-- > 0;) {
            for (std::uint32_t& child : tree_.nodes[at].child) {
                if (child == invalid_index) continue;
                int height = 0;
                if ((child & leaf_bit) == 0) {
                    height = heights[child];
                } else {
                    const Part& part = parts_[child & ~leaf_bit];
                    height = part.depth;
                    child = part.root;
                }
                heights[at] = std::max(heights[at], height + 1);
            }
        }
        tree_.depth = heights[0];
    }

    /// The only part is the whole tree. If it is a leaf, it gets a node above it.
    void promote_only_part() {
        tree_.depth = parts_[0].depth;
        if ((parts_[0].root & leaf_bit) == 0) return;
        tree_.nodes.push_back(empty_node());
        set_child(tree_.nodes[0], 0, {to_float4(tree_.bounds.lo), to_float4(tree_.bounds.hi)},
                  parts_[0].root);
        tree_.depth = 1;
    }

    MeshTree& tree_;
    std::vector<Part> parts_;
    std::size_t upper_nodes_ = 0;
};

/// Builds the parts below the top with the smallest leaf memory cost that keeps to the budget.
class PartBuilder {
  public:
    PartBuilder(const MeshBuild& build, const MeshTop& top, const std::vector<std::uint32_t>& parts,
                parallel::TaskPool& pool, TreeWriter& writer)
        : build_(build), top_(top), parts_(parts), pool_(pool), writer_(writer),
          builders_(static_cast<std::size_t>(pool.threads())) {
        assert(std::is_sorted(parts.begin(), parts.end(), [this](std::uint32_t a, std::uint32_t b) {
            return first_reference(a) < first_reference(b);
        }));
    }

    void run() {
        std::vector<std::size_t> sample;
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            (parts_.size() < min_sampled_parts || is_sampled(i) ? sample : others).push_back(i);
        if (!shares_vertices(build_) || !fit(sample, budget_shared)) fit(sample, budget_unshared);
        grow(others, true);
    }

  private:
    /// Builds the sample with increasing leaf memory cost until it fits the budget; returns false if it never
    /// does.
    bool fit(const std::vector<std::size_t>& sample, double budget) {
        for (const float leaf_memory_cost : leaf_memory_costs) {
            build_.leaf_memory_cost = leaf_memory_cost;
            writer_.clear();
            grow(sample, false);
            if (bytes_a_reference(sample) * references_a_triangle() <= budget) return true;
        }
        return false;
    }

    /// `is_final`: no part before these will be built again. Parts are in the order of their references.
    void grow(const std::vector<std::size_t>& which, bool is_final) {
        parallel::run_in_order<Subtree>(
            pool_, which.size(),
            [&](std::size_t task, int worker, Subtree& subtree) {
                builders_[static_cast<std::size_t>(worker)].run(build_, top_, parts_[which[task]], subtree);
            },
            [&](std::size_t task, const Subtree& subtree) {
                writer_.add(which[task], subtree);
                if (is_final) return_references(which[task]);
            });
    }

    /// Returns the memory of the references before a part to the system: the tree grows meanwhile.
    void return_references(std::size_t part) {
        constexpr std::size_t page = parallel::large_page / sizeof(PrimRef);
        const std::size_t done = first_reference(parts_[part]) / page * page;
        if (done <= returned_) return;
        parallel::return_pages(build_.refs + returned_, (done - returned_) * sizeof(PrimRef));
        returned_ = done;
    }

    /// Of those below a node of the top.
    std::size_t first_reference(std::uint32_t node) const {
        while (!top_.nodes[node].is_leaf) node = top_.nodes[node].left;
        return top_.ranges[top_.nodes[node].first].begin;
    }

    /// Valid if only the sample was built.
    double bytes_a_reference(const std::vector<std::size_t>& sample) const {
        std::size_t references = 0;
        for (const std::size_t i : sample) references += top_.nodes[parts_[i]].count;
        return static_cast<double>(writer_.bytes()) / static_cast<double>(references);
    }

    double references_a_triangle() const {
        return static_cast<double>(top_.nodes[0].count) / static_cast<double>(build_.triangles.size());
    }

    MeshBuild build_;
    const MeshTop& top_;
    const std::vector<std::uint32_t>& parts_;
    parallel::TaskPool& pool_;
    TreeWriter& writer_;
    std::vector<SubtreeBuilder> builders_;
    std::size_t returned_ = 0; ///< references whose memory was returned to the system
};

} // namespace

void check_corners(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    for (const uvec3& corners : triangles)
        if (std::max({corners.x, corners.y, corners.z}) >= positions.size())
            throw std::invalid_argument("a triangle names a vertex that its mesh does not have");
}

MeshTree build_mesh_tree(std::span<const vec3> positions, std::span<const uvec3> triangles,
                         parallel::TaskPool& pool, BuildQuality quality) {
    MeshTree tree;
    tree.triangles = triangles.size();
    tree.quality = quality;
    const std::size_t limit = room_for(triangles.size(), quality);
    parallel::LargeVector<PrimRef> refs(limit);
    auto [all, surface] = fill_refs(positions, triangles, refs.data(), pool);
    tree.left_out = triangles.size() - all.size();
    tree.bounds = all.box.bounds();
    if (all.size() == 0) return tree;

    tree.depth_complexity = surface / static_cast<double>(tree.bounds.half_area());
    all.limit = limit;
    const float scale = area_scale(all.box);
    const MeshBuild build{positions, triangles, quality, scale, half_area(all.box, scale), refs.data()};
    MeshTop top = build_top(build, all, pool);
    const std::vector<std::uint32_t> parts = choose_parts(top, build.scale);
    TreeWriter writer(build, top, parts, tree);
    PartBuilder(build, top, parts, pool, writer).run();
    writer.finish();
    return tree;
}

} // namespace glint::trace
