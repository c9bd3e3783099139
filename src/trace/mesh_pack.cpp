#include "trace/mesh_pack.h"

#include <bit>
#include <stdexcept>

namespace glint {
namespace {

bool same_bits(const vec3& a, const vec3& b) {
    return std::bit_cast<std::array<std::uint32_t, 3>>(a) == std::bit_cast<std::array<std::uint32_t, 3>>(b);
}

} // namespace

void throw_too_many_leaves() { throw std::length_error("the leaves of a mesh exceed 512 MiB"); }

LeafDraft draft_leaf(std::span<const vec3> positions, std::span<const uvec3> triangles,
                     std::span<const std::uint32_t> numbers, Sameness sameness) {
    LeafDraft leaf;
    std::array<std::uint32_t, 3 * wide_leaf> indices;
    for (const std::uint32_t number : numbers) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t index = triangles[number][k];
            const vec3& p = positions[index];
            std::uint32_t i = 0;
            while (i < leaf.vertices && indices[i] != index &&
                   (sameness == Sameness::index || !same_bits(leaf.positions[i], p)))
                ++i;
            leaf.corners[3 * leaf.triangles + static_cast<std::uint32_t>(k)] = i;
            if (i < leaf.vertices) continue;
            indices[i] = index;
            leaf.positions[i] = p;
            ++leaf.vertices;
        }
        leaf.numbers[leaf.triangles++] = number;
    }
    return leaf;
}

std::uint32_t append_leaf(const LeafDraft& leaf, std::vector<std::uint32_t>& words) {
    const std::size_t offset = words.size() / 4;
    if (offset >= most_leaf_blocks) throw_too_many_leaves();
    std::array<std::uint32_t, wide_leaf> corners{};
    for (std::uint32_t i = 0; i < leaf.triangles; ++i)
        corners[i] = leaf.corners[3 * i] | leaf.corners[3 * i + 1] << 3 | leaf.corners[3 * i + 2] << 6;
    for (std::size_t i = 0; i < wide_leaf; i += 2) words.push_back(corners[i] | corners[i + 1] << 16);
    for (int axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < leaf.vertices; ++i)
            words.push_back(std::bit_cast<std::uint32_t>(leaf.positions[i][axis]));
    words.insert(words.end(), leaf.numbers.begin(), leaf.numbers.begin() + leaf.triangles);
    words.resize((words.size() + 3) / 4 * 4);
    return leaf_bit | (leaf.triangles - 1) << 28 | (leaf.vertices - 1) << 25 |
           static_cast<std::uint32_t>(offset);
}

} // namespace glint
