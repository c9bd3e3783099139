#pragma once
// Packing of triangles into the leaves of a MeshTree. Private to this room.

#include "bvh/float4.h"
#include "trace/mesh/tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace glint::trace {

/// Maximum number of vertices in a leaf.
inline constexpr std::uint32_t leaf_vertices = 8;
/// Padding behind the last leaf, in words, for vector loads of eight.
inline constexpr std::size_t tail_words = 16;

/// A leaf code addresses this many units of 16 bytes.
inline constexpr std::size_t max_leaf_blocks = 0x01ffffff;
[[noreturn]] void throw_too_many_leaves();

/// The distinct vertices of up to eight triangles, which may be too many for a leaf.
struct LeafDraft {
    static constexpr std::size_t max_vertices = 3 * max_leaf_size;

    std::array<std::uint32_t, max_leaf_size> numbers; ///< triangle indices
    std::uint32_t triangles = 0;
    std::array<std::uint8_t, max_vertices> corners; ///< vertices of triangle i at 3 i
    std::uint32_t vertices = 0;
    /// Bit patterns by axis, four vertices a vector. Written and read with the same width, so that loads do
    /// not wait for store forwarding.
    std::array<std::array<int4, max_vertices / 4>, 3> positions;

    bool fits() const { return vertices <= leaf_vertices; }
    /// The vertices of a triangle as a bit set.
    std::uint32_t vertices_of(std::uint32_t i) const {
        return 1u << corners[3 * i] | 1u << corners[3 * i + 1] | 1u << corners[3 * i + 2];
    }
};

/// When two vertices count as the same.
enum class VertexIdentity {
    position, ///< equal coordinates, bit by bit
    index     ///< equal index, so they stay the same when vertices move
};

LeafDraft draft_leaf(std::span<const vec3> positions, std::span<const uvec3> triangles,
                     std::span<const std::uint32_t> numbers, VertexIdentity identity);

/// The draft of a subset of a draft's triangles.
LeafDraft part_of(const LeafDraft& whole, std::span<const std::uint8_t> triangles);

/// Appends a leaf, which must fit, and returns its code. Throws std::length_error if a code cannot address
/// it.
std::uint32_t append_leaf(const LeafDraft& leaf, parallel::LargeVector<std::uint32_t>& words);

} // namespace glint::trace
