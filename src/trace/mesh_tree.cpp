#include "trace/mesh_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace glint {
namespace {

constexpr std::uint32_t leaf_vertices = 8;
/// Words behind the last leaf that a vector load of eight may touch.
constexpr std::size_t tail_words = 16;
/// Prices of a leaf in steps into a node, measured: one round of eight vertices and triangles, and each more.
constexpr float leaf_base = 0.7f;
constexpr float leaf_triangle = 0.12f;

bool is_finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool same_bits(const vec3& a, const vec3& b) {
    return std::bit_cast<std::array<std::uint32_t, 3>>(a) == std::bit_cast<std::array<std::uint32_t, 3>>(b);
}

/// The distinct vertices of up to eight triangles, by their bits.
struct LeafVertices {
    std::array<vec3, 24> positions;
    std::uint32_t count = 0;

    std::uint32_t add(const vec3& p) {
        for (std::uint32_t i = 0; i < count; ++i)
            if (same_bits(positions[i], p)) return i;
        positions[count] = p;
        return count++;
    }
};

class Packer {
  public:
    Packer(std::span<const vec3> positions, std::span<const uvec3> triangles, const Tree& tree)
        : positions_(positions), triangles_(triangles), tree_(tree) {}

    /// The price of a leaf, infinite with too many vertices.
    float cost(std::uint32_t first, std::uint32_t count) const {
        LeafVertices vertices;
        for (std::uint32_t i = first; i < first + count; ++i) {
            const uvec3 corner = triangles_[tree_.order[i]];
            for (int k = 0; k < 3; ++k) vertices.add(positions_[corner[k]]);
        }
        if (vertices.count > leaf_vertices) return std::numeric_limits<float>::infinity();
        return leaf_base + leaf_triangle * static_cast<float>(count);
    }

    /// Writes all leaves and puts their codes into the nodes.
    void pack(WideTree& wide, std::vector<std::uint32_t>& words) const {
        words.reserve(triangles_.size() * 7);
        for (WideNode& node : wide.nodes)
            for (std::uint32_t& child : node.child)
                if (child != no_child && (child & leaf_bit) != 0)
                    child = write(wide.leaves[child & ~leaf_bit], words);
        words.resize(words.size() + tail_words);
        words.shrink_to_fit();
    }

  private:
    std::uint32_t write(const LeafRun& run, std::vector<std::uint32_t>& words) const {
        LeafVertices vertices;
        std::array<std::uint16_t, 8> corners{};
        for (std::uint32_t i = 0; i < run.count; ++i) {
            const uvec3 corner = triangles_[tree_.order[run.first + i]];
            std::uint32_t packed = 0;
            for (int k = 0; k < 3; ++k) packed |= vertices.add(positions_[corner[k]]) << (3 * k);
            corners[i] = static_cast<std::uint16_t>(packed);
        }
        const std::size_t offset = words.size() / 4;
        if (offset > 0x01ffffff - 1) throw std::length_error("the leaves of a mesh exceed 512 MiB");
        for (std::size_t i = 0; i < 8; i += 2)
            words.push_back(corners[i] | static_cast<std::uint32_t>(corners[i + 1]) << 16);
        for (int axis = 0; axis < 3; ++axis)
            for (std::uint32_t i = 0; i < vertices.count; ++i)
                words.push_back(std::bit_cast<std::uint32_t>(vertices.positions[i][axis]));
        for (std::uint32_t i = 0; i < run.count; ++i) words.push_back(tree_.order[run.first + i]);
        words.resize((words.size() + 3) / 4 * 4);
        return leaf_bit | (run.count - 1) << 28 | (vertices.count - 1) << 25 |
               static_cast<std::uint32_t>(offset);
    }

    std::span<const vec3> positions_;
    std::span<const uvec3> triangles_;
    const Tree& tree_;
};

std::vector<BoxRef> boxes_of(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    std::vector<BoxRef> boxes;
    boxes.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const vec3& a = positions[triangles[i].x];
        const vec3& b = positions[triangles[i].y];
        const vec3& c = positions[triangles[i].z];
        if (!is_finite(a) || !is_finite(b) || !is_finite(c)) continue;
        boxes.push_back(
            {glm::min(glm::min(a, b), c), static_cast<std::uint32_t>(i), glm::max(glm::max(a, b), c)});
    }
    return boxes;
}

} // namespace

MeshTree build_mesh_tree(std::span<const vec3> positions, std::span<const uvec3> triangles, TaskPool& pool) {
    MeshTree mesh;
    const Tree tree = build_tree(boxes_of(positions, triangles), 1, pool);
    const Packer packer(positions, triangles, tree);
    WideTree wide =
        collapse(tree, [&](std::uint32_t first, std::uint32_t count) { return packer.cost(first, count); });
    packer.pack(wide, mesh.leaf_words);
    mesh.nodes = std::move(wide.nodes);
    mesh.bounds = tree.bounds;
    mesh.depth = wide.depth;
    mesh.triangles = triangles.size();
    return mesh;
}

} // namespace glint
