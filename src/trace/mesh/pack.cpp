// Leaves: finding distinct vertices and writing them in the packed layout.

#include "trace/mesh/pack.h"

#include "bvh/float4.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <stdexcept>

namespace glint::trace {
namespace {

using Row = std::array<int4, LeafDraft::max_vertices / 4>;

int4 all_lanes(std::uint32_t x) {
    const auto i = static_cast<std::int32_t>(x);
    return int4{i, i, i, i};
}

/// Lane numbers, counted from 1, where the mask is set. At most one lane is, so that lanes can be joined by
/// or.
int4 numbered(int4 mask, std::size_t first) {
    const auto n = static_cast<std::int32_t>(first);
    return mask & int4{n + 1, n + 2, n + 3, n + 4};
}

std::uint32_t only(int4 q) { return static_cast<std::uint32_t>(q[0] | q[1] | q[2] | q[3]); }

/// Finds vertices in a leaf draft, four comparisons at a time.
class VertexFinder {
  public:
    explicit VertexFinder(LeafDraft& leaf) : leaf_(leaf) {}

    std::uint32_t find_or_add(std::uint32_t index, const vec3& p, VertexIdentity identity) {
        std::uint32_t at = find(index);
        const auto bits = std::bit_cast<std::array<std::uint32_t, 3>>(p);
        if (at == 0 && identity == VertexIdentity::position) at = find(bits);
        if (at == 0) at = add(index, bits);
        return at - 1;
    }

  private:
    /// Position of the vertex plus one; 0 if not found.
    std::uint32_t find(std::uint32_t index) const {
        int4 found{};
        for (std::size_t i = 0; i < leaf_.vertices; i += 4)
            found |= numbered(indices_[i / 4] == all_lanes(index), i);
        return only(found);
    }

    std::uint32_t find(const std::array<std::uint32_t, 3>& bits) const {
        const auto& rows = leaf_.positions;
        int4 found{};
        for (std::size_t i = 0; i < leaf_.vertices; i += 4)
            found |=
                numbered((rows[0][i / 4] == all_lanes(bits[0])) & (rows[1][i / 4] == all_lanes(bits[1])) &
                             (rows[2][i / 4] == all_lanes(bits[2])),
                         i);
        return only(found);
    }

    std::uint32_t add(std::uint32_t index, const std::array<std::uint32_t, 3>& bits) {
        const std::size_t at = leaf_.vertices;
        set(indices_, at, index);
        for (std::size_t axis = 0; axis < 3; ++axis) set(leaf_.positions[axis], at, bits[axis]);
        return ++leaf_.vertices;
    }

    /// Fills the lanes behind the last one with all ones: no vertex has that index, and no coordinate is NaN.
    static void set(Row& row, std::size_t at, std::uint32_t value) {
        const auto lane = static_cast<std::int32_t>(at % 4);
        const int4 behind = int4{0, 1, 2, 3} > int4{lane, lane, lane, lane};
        const int4 here = int4{0, 1, 2, 3} == int4{lane, lane, lane, lane};
        const int4 before = lane > 0 ? row[at / 4] & ~behind & ~here : int4{};
        row[at / 4] = before | behind | (all_lanes(value) & here);
    }

    LeafDraft& leaf_;
    Row indices_;
};

} // namespace

void throw_too_many_leaves() { throw std::length_error("the leaves of a mesh exceed 512 MiB"); }

LeafDraft draft_leaf(std::span<const vec3> positions, std::span<const uvec3> triangles,
                     std::span<const std::uint32_t> numbers, VertexIdentity identity) {
    assert(!numbers.empty() && numbers.size() <= max_leaf_size);
    LeafDraft leaf;
    VertexFinder finder(leaf);
    // Prefetch all positions, which may be scattered.
    std::array<std::uint32_t, LeafDraft::max_vertices> indices;
    std::size_t corner = 0;
    for (const std::uint32_t number : numbers) {
        for (int k = 0; k < 3; ++k) {
            indices[corner] = triangles[number][k];
            __builtin_prefetch(&positions[indices[corner++]]);
        }
        leaf.numbers[leaf.triangles++] = number;
    }
    for (std::size_t i = 0; i < corner; ++i)
        leaf.corners[i] =
            static_cast<std::uint8_t>(finder.find_or_add(indices[i], positions[indices[i]], identity));
    return leaf;
}

LeafDraft part_of(const LeafDraft& whole, std::span<const std::uint8_t> triangles) {
    LeafDraft part;
    std::array<std::uint8_t, LeafDraft::max_vertices> new_index;
    new_index.fill(0xff);
    std::size_t corner = 0;
    for (const std::size_t triangle : triangles) {
        part.numbers[part.triangles++] = whole.numbers[triangle];
        for (std::size_t k = 3 * triangle; k < 3 * triangle + 3; ++k) {
            const std::size_t vertex = whole.corners[k];
            if (new_index[vertex] == 0xff) {
                for (std::size_t axis = 0; axis < 3; ++axis)
                    part.positions[axis][part.vertices / 4][part.vertices % 4] =
                        whole.positions[axis][vertex / 4][vertex % 4];
                new_index[vertex] = static_cast<std::uint8_t>(part.vertices++);
            }
            part.corners[corner++] = new_index[vertex];
        }
    }
    return part;
}

std::uint32_t append_leaf(const LeafDraft& leaf, parallel::LargeVector<std::uint32_t>& words) {
    assert(leaf.triangles >= 1 && leaf.triangles <= max_leaf_size);
    assert(leaf.vertices >= 1 && leaf.fits());
    assert(words.size() % 4 == 0);
    const std::size_t offset = words.size() / 4;
    if (offset >= max_leaf_blocks) throw_too_many_leaves();
    words.resize(words.size() + (4 + 3 * leaf.vertices + leaf.triangles + 3) / 4 * 4, 0);
    std::uint32_t* out = words.data() + 4 * offset;
    for (std::size_t i = 0; i < leaf.triangles; ++i) {
        const std::uint8_t* corners = leaf.corners.data() + 3 * i;
        const std::uint32_t packed =
            std::uint32_t(corners[0]) | std::uint32_t(corners[1]) << 3 | std::uint32_t(corners[2]) << 6;
        out[i / 2] |= packed << (16 * (i % 2));
    }
    out += 4;
    for (const Row& row : leaf.positions) {
        std::memcpy(out, row.data(), leaf.vertices * sizeof(std::uint32_t));
        out += leaf.vertices;
    }
    std::copy_n(leaf.numbers.begin(), leaf.triangles, out);
    return leaf_bit | (leaf.triangles - 1) << 28 | (leaf.vertices - 1) << 25 |
           static_cast<std::uint32_t>(offset);
}

} // namespace glint::trace
