#pragma once
// Parts of a MeshTree that are built for themselves, each by one thread. Private to this room.

#include "bvh/wide.h"
#include "parallel/large_pages.h"
#include "trace/mesh_pack.h"
#include "trace/mesh_split.h"
#include "trace/mesh_top.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glint {

/// A part of a tree. Its codes count from its own nodes and words.
struct Subtree {
    LargeVector<WideNode> nodes;      ///< none where the root is a leaf
    LargeVector<std::uint32_t> words; ///< of leaves
    std::uint32_t root = no_child;    ///< node or leaf
    int depth = 0;                    ///< nodes on the longest way to a leaf
};

/// Cuts wide nodes out of a binary tree, depth first, siblings side by side. Leaf is called with a binary
/// node that is a leaf and returns its code.
template <class Leaf>
class WideWriter {
  public:
    WideWriter(std::span<const BinaryNode> tree, LargeVector<WideNode>& out, Leaf leaf)
        : tree_(tree), out_(out), leaf_(leaf) {}

    /// Returns the root's code.
    std::uint32_t run() {
        const std::uint32_t root = place(0);
        if ((root & leaf_bit) == 0) fill(root, 0, 1);
        return root;
    }
    int depth() const { return depth_; }

  private:
    std::uint32_t place(std::uint32_t at) {
        if (tree_[at].is_leaf) return leaf_(tree_[at]);
        out_.emplace_back();
        return static_cast<std::uint32_t>(out_.size() - 1);
    }

    void fill(std::uint32_t wide, std::uint32_t at, int depth) {
        depth_ = std::max(depth_, depth);
        const WideRoots roots = children_of(tree_, at);
        WideNode node = empty_node();
        for (std::uint32_t i = 0; i < roots.count; ++i)
            set_child(node, i, tree_[roots.nodes[i]].box, place(roots.nodes[i]));
        out_[wide] = node;
        for (std::uint32_t i = 0; i < roots.count; ++i)
            if ((node.child[i] & leaf_bit) == 0) fill(node.child[i], roots.nodes[i], depth + 1);
    }

    std::span<const BinaryNode> tree_;
    LargeVector<WideNode>& out_;
    Leaf leaf_;
    int depth_ = 0;
};

/// Builds subtrees one after another in the same scratch memory.
class SubtreeBuilder {
  public:
    /// Makes the part of the tree below a node of the top, in the place of what `subtree` was.
    void run(const MeshBuild& build, const MeshTop& top, std::uint32_t root, Subtree& subtree);

  private:
    void inherit(const MeshTop& top, std::uint32_t from, std::uint32_t at);
    void grow(const Range& range, std::uint32_t at);
    void grow_block(const Range& range, std::uint32_t at);
    void price(std::uint32_t at, std::uint32_t children);
    void cut_block(std::uint32_t at);
    float leaf_cost(const BinaryNode& node, float area) const;
    std::uint32_t add_children(const QuadBox& left, const QuadBox& right);

    const MeshBuild* build_ = nullptr;
    LargeVector<std::uint32_t>* words_ = nullptr; ///< of the subtree's leaves
    std::vector<BinaryNode> nodes_;
    Bins bins_;

    // The block being cut: a run of a few references, the place of each in the draft, and its vertices as
    // bits.
    std::size_t block_ = 0;
    LeafDraft draft_;
    std::array<std::uint8_t, wide_leaf> order_;
    std::array<std::uint32_t, wide_leaf> vertices_;
    float leaf_price_ = 0; ///< of each leaf in the block, see MeshBuild::thrift
};

} // namespace glint
