// Refitting: new vertex positions in an existing tree.

#include "trace/mesh/pack.h"
#include "trace/mesh/tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <stdexcept>

namespace glint::trace {
namespace {

/// Nodes per task.
constexpr std::size_t grain = 256;

Bounds bounds_of(const WideNode& node) {
    Bounds box;
    for (std::size_t child = 0; child < wide_children; ++child)
        if (node.child[child] != invalid_index) box.grow(child_box(node, child));
    return box;
}

class Refitter {
  public:
    Refitter(MeshTree& tree, std::span<const vec3> positions, std::span<const uvec3> triangles)
        : tree_(tree), positions_(positions), triangles_(triangles) {}

    void run(parallel::TaskPool& pool) {
        std::vector<std::vector<ChildSlot>> broken((tree_.nodes.size() + grain - 1) / grain);
        pool.run(broken.size(), [&](std::size_t task, int) {
            const std::size_t end = std::min((task + 1) * grain, tree_.nodes.size());
            for (std::size_t node = task * grain; node < end; ++node) move_leaves(node, broken[task]);
        });
        rewrite(broken);
        grow_boxes();
    }

  private:
    struct ChildSlot {
        std::size_t node;
        std::size_t child;
    };

    void move_leaves(std::size_t at, std::vector<ChildSlot>& broken) {
        WideNode& node = tree_.nodes[at];
        for (std::size_t child = 0; child < wide_children; ++child) {
            if (node.child[child] == invalid_index || (node.child[child] & leaf_bit) == 0) continue;
            const LeafCode leaf{node.child[child]};
            set_box(node, child, box_of(leaf));
            if (!move(leaf)) broken.push_back({at, child});
        }
    }

    std::uint32_t number(LeafCode leaf, std::uint32_t i) const {
        return tree_.leaf_words[leaf.word() + 4 + 3 * std::size_t(leaf.vertices()) + i];
    }

    Bounds box_of(LeafCode leaf) const {
        Bounds box;
        for (std::uint32_t i = 0; i < leaf.triangles(); ++i)
            for (int k = 0; k < 3; ++k) box.grow(positions_[triangles_[number(leaf, i)][k]]);
        return box;
    }

    /// Writes the new positions of a leaf. Returns false if vertices that shared a position no longer do.
    bool move(LeafCode leaf) {
        std::uint32_t* words = tree_.leaf_words.data() + leaf.word();
        const std::uint32_t n = leaf.vertices();
        std::uint32_t moved = 0;
        for (std::uint32_t i = 0; i < leaf.triangles(); ++i) {
            const std::uint32_t corners = words[i / 2] >> (16 * (i % 2));
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t vertex = corners >> (3 * k) & 7u;
                const vec3& p = positions_[triangles_[number(leaf, i)][static_cast<int>(k)]];
                for (std::uint32_t axis = 0; axis < 3; ++axis) {
                    std::uint32_t& word = words[4 + axis * n + vertex];
                    const auto bits = std::bit_cast<std::uint32_t>(p[static_cast<int>(axis)]);
                    if ((moved >> vertex & 1u) != 0 && word != bits) return false;
                    word = bits;
                }
                moved |= 1u << vertex;
            }
        }
        return true;
    }

    /// Appends new versions of leaves whose shared vertices came apart.
    void rewrite(const std::vector<std::vector<ChildSlot>>& broken) {
        tree_.leaf_words.resize(tree_.leaf_words.size() - tail_words);
        for (const auto& slots : broken)
            for (const ChildSlot& slot : slots) {
                const LeafCode leaf{tree_.nodes[slot.node].child[slot.child]};
                std::array<std::uint32_t, max_leaf_size> numbers;
                for (std::uint32_t i = 0; i < leaf.triangles(); ++i) numbers[i] = number(leaf, i);
                const std::uint32_t code = write(std::span(numbers).first(leaf.triangles()));
                tree_.nodes[slot.node].child[slot.child] = code;
            }
        tree_.leaf_words.resize(tree_.leaf_words.size() + tail_words);
    }

    /// Writes a leaf or, if its vertices do not fit, a node over leaves of two triangles, which always fit.
    std::uint32_t write(std::span<const std::uint32_t> numbers) {
        const LeafDraft leaf = draft_leaf(positions_, triangles_, numbers, VertexIdentity::index);
        if (leaf.fits()) return append_leaf(leaf, tree_.leaf_words);
        WideNode node = empty_node();
        for (std::size_t child = 0; 2 * child < numbers.size(); ++child) {
            node.child[child] =
                write(numbers.subspan(2 * child, std::min<std::size_t>(2, numbers.size() - 2 * child)));
            set_box(node, child, box_of(LeafCode{node.child[child]}));
        }
        tree_.nodes.push_back(node);
        return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
    }

    /// Updates boxes bottom-up: children come after their parents, so one backward pass suffices.
    void grow_boxes() {
        std::vector<int> heights(tree_.nodes.size(), 1);
        for (std::size_t at = tree_.nodes.size(); at-- > 0;) {
            WideNode& node = tree_.nodes[at];
            for (std::size_t child = 0; child < wide_children; ++child) {
                if ((node.child[child] & leaf_bit) != 0) continue;
                assert(node.child[child] > at);
                set_box(node, child, bounds_of(tree_.nodes[node.child[child]]));
                heights[at] = std::max(heights[at], heights[node.child[child]] + 1);
            }
        }
        tree_.bounds = bounds_of(tree_.nodes.front());
        tree_.depth = heights.front();
    }

    MeshTree& tree_;
    std::span<const vec3> positions_;
    std::span<const uvec3> triangles_;
};

bool all_finite(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const uvec3& corners) {
        return is_finite(positions[corners.x]) && is_finite(positions[corners.y]) &&
               is_finite(positions[corners.z]);
    });
}

} // namespace

void refit(MeshTree& tree, std::span<const vec3> positions, std::span<const uvec3> triangles,
           parallel::TaskPool& pool) {
    if (triangles.size() != tree.triangles)
        throw std::invalid_argument("the number of triangles is not that of the tree");
    if (tree.left_out > 0 || !all_finite(positions, triangles)) {
        tree = build_mesh_tree(positions, triangles, pool, tree.quality);
    } else if (!tree.nodes.empty()) {
        Refitter(tree, positions, triangles).run(pool);
    }
}

} // namespace glint::trace
