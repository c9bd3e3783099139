#pragma once
// Triangles packed into the leaves of a MeshTree. Private to this room.

#include "trace/mesh_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glint {

/// A leaf names at most this many vertices.
inline constexpr std::uint32_t leaf_vertices = 8;
/// Words behind the last leaf that a vector load of eight may touch.
inline constexpr std::size_t tail_words = 16;

/// A code can address as many units of 16 bytes.
inline constexpr std::size_t most_leaf_blocks = 0x01ffffff;
[[noreturn]] void throw_too_many_leaves();

/// The distinct vertices of up to eight triangles, whether they fit into a leaf or not.
struct LeafDraft {
    std::array<std::uint32_t, wide_leaf> numbers; ///< of the triangles
    std::uint32_t triangles = 0;
    std::array<vec3, 3 * wide_leaf> positions;
    std::array<std::uint32_t, 3 * wide_leaf> corners; ///< of triangle i, at 3 i: into `positions`
    std::uint32_t vertices = 0;

    bool fits() const { return vertices <= leaf_vertices; }
};

/// What makes two vertices one.
enum class Sameness {
    position, ///< equal bits
    index     ///< one number: they stay one, however they move
};

LeafDraft draft_leaf(std::span<const vec3> positions, std::span<const uvec3> triangles,
                     std::span<const std::uint32_t> numbers, Sameness sameness);

/// Writes a leaf that fits behind the others; returns its code for a node. Throws std::length_error beyond
/// what a code can address.
std::uint32_t append_leaf(const LeafDraft& leaf, std::vector<std::uint32_t>& words);

} // namespace glint
