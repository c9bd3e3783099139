// From triangles to a tree: the top level by level, then subtrees, one a task, each written down as wide
// nodes before the next begins, so that no binary tree of the whole is ever held.

#include "trace/mesh_tree.h"

#include "math/finite.h"
#include "parallel/large_pages.h"
#include "trace/mesh_pack.h"
#include "trace/mesh_subtree.h"
#include "trace/mesh_top.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace glint {
namespace {

/// Triangles of one task.
constexpr std::size_t piece = 32768;

/// How many references a tree may have: cut triangles count for each part.
std::size_t room_for(std::size_t triangles, BuildQuality quality) {
    return quality == BuildQuality::high ? triangles + triangles * 15 / 100 : triangles;
}

/// References to all triangles whose vertices are finite, in order.
Range fill_refs(std::span<const vec3> positions, std::span<const uvec3> triangles, Ref* refs,
                TaskPool& pool) {
    std::vector<Range> parts((triangles.size() + piece - 1) / piece);
    pool.run(parts.size(), [&](std::size_t task, int) {
        Range part;
        part.begin = part.end = task * piece;
        for (std::size_t i = part.begin; i < std::min(part.begin + piece, triangles.size()); ++i) {
            const vec3& a = positions[triangles[i].x];
            const vec3& b = positions[triangles[i].y];
            const vec3& c = positions[triangles[i].z];
            if (!is_finite(a) || !is_finite(b) || !is_finite(c)) continue;
            QuadBox box{quad(a), quad(a)};
            box.grow(quad(b));
            box.grow(quad(c));
            refs[part.end] = Ref::of(box.lo, box.hi, static_cast<std::uint32_t>(i));
            part.add(refs[part.end++]);
        }
        parts[task] = part;
    });
    Range all;
    for (const Range& part : parts) {
        if (all.end != part.begin) std::copy(refs + part.begin, refs + part.end, refs + all.end);
        all.end += part.size();
        all.box.grow(part.box);
        all.middles.grow(part.middles);
    }
    all.limit = all.end;
    return all;
}

/// Of so many parts about a sixteenth is built first, to learn how much memory leaves take; of fewer all.
constexpr std::size_t least_sampled = 32;

/// Whether a part is of the sample: scattered, as neighbours are alike.
bool is_sampled(std::size_t part) { return (static_cast<std::uint32_t>(part) * 0x9e3779b9u) >> 28 == 0; }

/// Bytes a triangle that a tree may take: over shared vertices, and else.
constexpr double budget_shared = 47.5;
constexpr double budget_apart = 71.5;
/// And hardly ever more than so many.
constexpr std::size_t expected_bytes = 48;
/// How thrifty leaves may have to be for that, see MeshBuild::thrift.
constexpr std::array<float, 5> thrifts{0.0f, 0.25f, 1.0f, 8.0f, 30000.0f};

/// Builds the parts below the top, with leaves as thrifty as the memory budget asks for.
class PartBuilder {
  public:
    PartBuilder(const MeshBuild& build, const MeshTop& top, const std::vector<std::uint32_t>& parts,
                TaskPool& pool)
        : build_(build), top_(top), parts_(parts), pool_(pool), subtrees_(parts.size()),
          workers_(static_cast<std::size_t>(pool.threads())) {}

    /// They stay this builder's.
    std::span<const Subtree> run() {
        std::vector<std::size_t> sample;
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            (parts_.size() < least_sampled || is_sampled(i) ? sample : others).push_back(i);
        const bool shared = build_.positions.size() < 2 * build_.triangles.size();
        if (!shared || !fit(sample, budget_shared)) fit(sample, budget_apart);
        grow(others);
        return subtrees_;
    }

  private:
    struct Worker {
        explicit Worker(std::size_t expected) : arena(expected) {}
        SubtreeBuilder builder;
        PageArena arena;
    };

    /// Builds the sample with the least thrift that keeps to a budget; false if none does.
    bool fit(const std::vector<std::size_t>& sample, double budget) {
        for (const float thrift : thrifts) {
            build_.thrift = thrift;
            for (const auto& worker : workers_)
                if (worker) worker->arena.clear(); // of what took too much
            grow(sample);
            if (bytes_a_reference(sample) * references_a_triangle() <= budget) return true;
        }
        return false;
    }

    void grow(const std::vector<std::size_t>& which) {
        pool_.run(which.size(), [&](std::size_t task, int worker) {
            auto& own = workers_[static_cast<std::size_t>(worker)];
            if (!own)
                own = std::make_unique<Worker>(expected_bytes * build_.triangles.size() / workers_.size());
            subtrees_[which[task]] = own->builder.run(build_, top_, parts_[which[task]], own->arena);
        });
    }

    double bytes_a_reference(const std::vector<std::size_t>& sample) const {
        std::size_t bytes = 0;
        std::size_t references = 0;
        for (const std::size_t i : sample) {
            bytes += subtrees_[i].nodes.size() * sizeof(WideNode) +
                     subtrees_[i].words.size() * sizeof(std::uint32_t);
            references += top_.nodes[parts_[i]].count;
        }
        return static_cast<double>(bytes) / static_cast<double>(references);
    }

    double references_a_triangle() const {
        return static_cast<double>(top_.nodes[0].count) / static_cast<double>(build_.triangles.size());
    }

    MeshBuild build_;
    const MeshTop& top_;
    const std::vector<std::uint32_t>& parts_;
    TaskPool& pool_;
    std::vector<Subtree> subtrees_;
    std::vector<std::unique_ptr<Worker>> workers_;
};

/// Writes the top, then all subtrees behind it.
class Assembler {
  public:
    Assembler(MeshTop& top, const std::vector<std::uint32_t>& parts, std::span<const Subtree> subtrees,
              MeshTree& tree)
        : top_(top), parts_(parts), subtrees_(subtrees), tree_(tree) {}

    void run(float scale, TaskPool& pool) {
        price(scale);
        WideWriter writer(top_.nodes, tree_.nodes,
                          [](const BinaryNode& leaf) { return leaf_bit | leaf.first; });
        const std::uint32_t root = writer.run();
        if ((root & leaf_bit) != 0) start_with_leaf();
        place();
        link();
        tree_.nodes.resize(nodes_before_.back());
        tree_.leaf_words.resize(words_before_.back() + tail_words);
        std::fill_n(tree_.leaf_words.end() - tail_words, tail_words, 0u);
        pool.run(subtrees_.size(), [&](std::size_t i, int) { write(i); });
    }

  private:
    /// Now that the parts' prices are known. Children stand behind their parents.
    void price(float scale) {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            BinaryNode& part = top_.nodes[parts_[i]];
            part.is_split = 0;
            part.first = static_cast<std::uint32_t>(i);
            price_leaf(part, subtrees_[i].cost);
        }
        for (std::size_t at = top_.nodes.size(); at-- > 0;) {
            BinaryNode& node = top_.nodes[at];
            if (node.is_split)
                price_split(node, top_.nodes[node.left], top_.nodes[node.left + 1],
                            half_area(node.box, scale), std::numeric_limits<float>::infinity());
        }
    }

    /// The only subtree is the tree. If it is a leaf, that needs a node above it.
    void start_with_leaf() {
        if ((subtrees_[0].root & leaf_bit) == 0) return;
        tree_.nodes.push_back(empty_node());
        set_child(tree_.nodes[0], 0, top_.nodes[0].box, leaf_bit);
    }

    void place() {
        nodes_before_.push_back(tree_.nodes.size());
        words_before_.push_back(0);
        for (const Subtree& subtree : subtrees_) {
            nodes_before_.push_back(nodes_before_.back() + subtree.nodes.size());
            words_before_.push_back(words_before_.back() + subtree.words.size());
        }
        if (words_before_.back() / 4 > most_leaf_blocks) throw_too_many_leaves();
    }

    /// The top's leaves name subtrees; puts their roots instead.
    void link() {
        const std::size_t count = tree_.nodes.size();
        std::vector<int> heights(count, 1);
        for (std::size_t at = count; at-- > 0;) {
            for (std::uint32_t& child : tree_.nodes[at].child) {
                if (child == no_child) continue;
                int height = 0;
                if ((child & leaf_bit) == 0) {
                    height = heights[child];
                } else {
                    const std::uint32_t subtree = child & ~leaf_bit;
                    height = subtrees_[subtree].depth;
                    child = moved(subtrees_[subtree].root, subtree);
                }
                heights[at] = std::max(heights[at], height + 1);
            }
        }
        tree_.depth = count > 0 ? heights[0] : subtrees_[0].depth;
    }

    /// The code of a subtree's node or leaf in the whole tree.
    std::uint32_t moved(std::uint32_t code, std::size_t subtree) const {
        if (code == no_child) return code;
        return code + static_cast<std::uint32_t>((code & leaf_bit) != 0 ? words_before_[subtree] / 4
                                                                        : nodes_before_[subtree]);
    }

    void write(std::size_t i) {
        const Subtree& subtree = subtrees_[i];
        WideNode* out = tree_.nodes.data() + nodes_before_[i];
        for (const WideNode& node : subtree.nodes) {
            *out = node;
            for (std::uint32_t& child : out->child) child = moved(child, i);
            ++out;
        }
        std::copy(subtree.words.begin(), subtree.words.end(), tree_.leaf_words.data() + words_before_[i]);
    }

    MeshTop& top_;
    const std::vector<std::uint32_t>& parts_;
    std::span<const Subtree> subtrees_;
    MeshTree& tree_;
    std::vector<std::size_t> nodes_before_;
    std::vector<std::size_t> words_before_;
};

} // namespace

MeshTree build_mesh_tree(std::span<const vec3> positions, std::span<const uvec3> triangles, TaskPool& pool,
                         BuildQuality quality) {
    MeshTree tree;
    tree.triangles = triangles.size();
    tree.quality = quality;
    const std::size_t limit = room_for(triangles.size(), quality);
    LargeVector<Ref> refs(limit);
    Range all = fill_refs(positions, triangles, refs.data(), pool);
    tree.left_out = triangles.size() - all.size();
    tree.bounds = all.box.bounds();
    if (all.size() == 0) return tree;

    all.limit = limit;
    const float scale = area_scale(all.box);
    const MeshBuild build{positions, triangles, quality, scale, half_area(all.box, scale), refs.data()};
    MeshTop top = build_top(build, all, pool);
    const std::vector<std::uint32_t> parts = choose_parts(top, build.scale);
    PartBuilder builder(build, top, parts, pool);
    const std::span<const Subtree> subtrees = builder.run();
    LargeVector<Ref>().swap(refs);
    Assembler(top, parts, subtrees, tree).run(build.scale, pool);
    return tree;
}

} // namespace glint
