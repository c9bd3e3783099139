#pragma once
// Triangles packed into the leaves of a MeshTree. Private to this room.

#include "bvh/quad.h"
#include "trace/mesh_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

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
    static constexpr std::size_t most = 3 * wide_leaf;

    std::array<std::uint32_t, wide_leaf> numbers; ///< of the triangles
    std::uint32_t triangles = 0;
    std::array<std::uint8_t, most> corners; ///< of triangle i, at 3 i: which vertices
    std::uint32_t vertices = 0;
    /// By axis, as bits, four vertices at a time: written and read alike, so that no read waits for a write.
    std::array<std::array<QuadInts, most / 4>, 3> positions;

    bool fits() const { return vertices <= leaf_vertices; }
    /// The vertices of a triangle, as bits.
    std::uint32_t vertices_of(std::uint32_t i) const {
        return 1u << corners[3 * i] | 1u << corners[3 * i + 1] | 1u << corners[3 * i + 2];
    }
};

/// What makes two vertices one.
enum class Sameness {
    position, ///< equal bits
    index     ///< one number: they stay one, however they move
};

LeafDraft draft_leaf(std::span<const vec3> positions, std::span<const uvec3> triangles,
                     std::span<const std::uint32_t> numbers, Sameness sameness);

/// The leaf of some of a draft's triangles.
LeafDraft part_of(const LeafDraft& whole, std::span<const std::uint8_t> triangles);

/// Writes a leaf that fits behind the others; returns its code for a node. Throws std::length_error beyond
/// what a code can address.
std::uint32_t append_leaf(const LeafDraft& leaf, LargeVector<std::uint32_t>& words);

} // namespace glint
