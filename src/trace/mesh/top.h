#pragma once
// The upper part of a MeshTree's binary tree, and its division into independent parts. Private to this room.

#include "bvh/wide.h"
#include "parallel/large_pages.h"
#include "parallel/task_pool.h"
#include "trace/mesh/split.h"

#include <cstdint>
#include <vector>

namespace glint::trace {

/// Ranges with more capacity than this are split; the others are the leaves of the top.
inline constexpr std::size_t top_grain = 64;

/// Binary nodes, parents before children, and the ranges of its leaves: a leaf's `first` is an index into
/// `ranges`.
struct MeshTop {
    parallel::LargeVector<BinaryNode> nodes;
    parallel::LargeVector<PrimRange> ranges;
};

MeshTop build_top(const MeshBuild& build, const PrimRange& root, parallel::TaskPool& pool);

/// Returns the nodes at which parts are rooted, in order. A part's root becomes a root in the wide tree; it
/// is chosen such that optimal collapsing would nearly have done the same, from estimated costs of the trees
/// below the top.
std::vector<std::uint32_t> choose_parts(MeshTop& top, float scale);

} // namespace glint::trace
