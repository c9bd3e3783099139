#include "trace/mesh_tree.h"

#include "trace/mesh_pack.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace glint {
namespace {

/// Prices of a leaf in steps into a node, measured: one round of eight vertices and triangles, and each more.
constexpr float leaf_base = 0.7f;
constexpr float leaf_triangle = 0.12f;

bool is_finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

class Packer {
  public:
    Packer(std::span<const vec3> positions, std::span<const uvec3> triangles, const Tree& tree)
        : positions_(positions), triangles_(triangles), tree_(tree) {}

    /// The price of a leaf, infinite with too many vertices.
    float cost(std::uint32_t first, std::uint32_t count) const {
        if (!draft(first, count).fits()) return std::numeric_limits<float>::infinity();
        return leaf_base + leaf_triangle * static_cast<float>(count);
    }

    /// Writes all leaves and puts their codes into the nodes.
    void pack(WideTree& wide, std::vector<std::uint32_t>& words) const {
        words.reserve(triangles_.size() * 7);
        for (WideNode& node : wide.nodes)
            for (std::uint32_t& child : node.child)
                if (child != no_child && (child & leaf_bit) != 0) {
                    const LeafRun& run = wide.leaves[child & ~leaf_bit];
                    child = append_leaf(draft(run.first, run.count), words);
                }
        words.resize(words.size() + tail_words);
        words.shrink_to_fit();
    }

  private:
    LeafDraft draft(std::uint32_t first, std::uint32_t count) const {
        return draft_leaf(positions_, triangles_, std::span(tree_.order).subspan(first, count),
                          Sameness::position);
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

MeshTree build_mesh_tree(std::span<const vec3> positions, std::span<const uvec3> triangles, TaskPool& pool,
                         BuildQuality quality) {
    MeshTree mesh;
    const Tree tree = build_tree(boxes_of(positions, triangles), 1, pool, quality);
    const Packer packer(positions, triangles, tree);
    WideTree wide =
        collapse(tree, [&](std::uint32_t first, std::uint32_t count) { return packer.cost(first, count); });
    packer.pack(wide, mesh.leaf_words);
    mesh.nodes = std::move(wide.nodes);
    mesh.bounds = tree.bounds;
    mesh.depth = wide.depth;
    mesh.triangles = triangles.size();
    mesh.left_out = triangles.size() - tree.order.size();
    mesh.quality = quality;
    return mesh;
}

} // namespace glint
