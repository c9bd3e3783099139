#pragma once
// Parts of a MeshTree, each built independently by one thread. Private to this room.

#include "bvh/wide.h"
#include "parallel/large_pages.h"
#include "trace/mesh/pack.h"
#include "trace/mesh/split.h"
#include "trace/mesh/top.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glint::trace {

/// A part of a tree. Child codes are relative to its own nodes and words.
struct Subtree {
    parallel::LargeVector<WideNode> nodes;      ///< empty if the root is a leaf
    parallel::LargeVector<std::uint32_t> words; ///< leaf data
    std::uint32_t root = invalid_index;         ///< code of a node or leaf
    int depth = 0;                              ///< number of nodes on the longest path to a leaf
};

/// Collapses a binary tree into wide nodes, depth first with adjacent siblings. `leaf` is called with each
/// binary node that becomes a leaf and returns the leaf's code.
template <class Leaf>
class WideWriter {
  public:
    WideWriter(std::span<const BinaryNode> tree, parallel::LargeVector<WideNode>& out, Leaf leaf)
        : tree_(tree), out_(out), leaf_(leaf) {}

    /// Returns the root's code.
    std::uint32_t run() {
        const std::uint32_t root = allocate(0);
        if ((root & leaf_bit) == 0) fill(root, 0, 1);
        return root;
    }
    int depth() const { return depth_; }

  private:
    std::uint32_t allocate(std::uint32_t at) {
        if (tree_[at].is_leaf) return leaf_(tree_[at]);
        out_.emplace_back();
        return static_cast<std::uint32_t>(out_.size() - 1);
    }

    void fill(std::uint32_t wide, std::uint32_t at, int depth) {
        depth_ = std::max(depth_, depth);
        const WideRoots roots = children_of(tree_, at);
        WideNode node = empty_node();
        for (std::uint32_t i = 0; i < roots.count; ++i)
            set_child(node, i, tree_[roots.nodes[i]].box, allocate(roots.nodes[i]));
        out_[wide] = node;
        for (std::uint32_t i = 0; i < roots.count; ++i)
            if ((node.child[i] & leaf_bit) == 0) fill(node.child[i], roots.nodes[i], depth + 1);
    }

    std::span<const BinaryNode> tree_;
    parallel::LargeVector<WideNode>& out_;
    Leaf leaf_;
    int depth_ = 0;
};

/// Builds subtrees, reusing scratch memory.
class SubtreeBuilder {
  public:
    /// Builds the part of the tree below a node of the top, overwriting `subtree`.
    void run(const MeshBuild& build, const MeshTop& top, std::uint32_t root, Subtree& subtree);

  private:
    void inherit(const MeshTop& top, std::uint32_t from, std::uint32_t at);
    void grow(const PrimRange& range, std::uint32_t at);
    void grow_block(const PrimRange& range, std::uint32_t at);
    void set_costs(std::uint32_t at, std::uint32_t children);
    void cut_block(std::uint32_t at);
    float leaf_cost(const BinaryNode& node, float area) const;
    std::uint32_t add_children(const SimdBounds& left, const SimdBounds& right);

    const MeshBuild* build_ = nullptr;
    parallel::LargeVector<std::uint32_t>* words_ = nullptr; ///< of the subtree's leaves
    std::vector<BinaryNode> nodes_;
    Bins bins_;

    // The block being split into leaves: its first reference, each reference's triangle in the draft, and its
    // vertices as bits.
    std::size_t block_ = 0;
    LeafDraft draft_;
    std::array<std::uint8_t, max_leaf_size> order_;
    std::array<std::uint32_t, max_leaf_size> vertices_;
    float leaf_memory_cost_ = 0; ///< of each leaf in the block, see MeshBuild::leaf_memory_cost
};

} // namespace glint::trace
