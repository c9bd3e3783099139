#pragma once
// The upper part of a MeshTree's binary tree, and its division into parts to be built for themselves. Private
// to this room.

#include "bvh/wide.h"
#include "parallel/large_pages.h"
#include "parallel/task_pool.h"
#include "trace/mesh_split.h"

#include <cstdint>
#include <vector>

namespace glint {

/// Ranges with more room than this are split; the others are the leaves of the top.
inline constexpr std::size_t top_grain = 64;

/// Binary nodes, parents before children, and the ranges that its leaves stand for: a leaf's `first` is an
/// index into them.
struct MeshTop {
    LargeVector<BinaryNode> nodes;
    LargeVector<Range> ranges;
};

MeshTop build_top(const MeshBuild& build, const Range& root, TaskPool& pool);

/// The nodes below which the tree is to be built in parts, in order. Each part's root will stand for itself
/// in the wide tree, and is chosen so that it would nearly have done so anyway: by pricing the top with what
/// is known of trees below it.
std::vector<std::uint32_t> choose_parts(MeshTop& top, float scale);

} // namespace glint
