// The GPU's tree holds what the CPU's holds, in boxes that are never smaller.

#include "gallery.h"

#include "gpu/tree.h"
#include "scene/scene_data.h"
#include "trace/world/data.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

namespace glint::gpu {

using trace::LeafCode;
using trace::WorldData;
namespace {

/// The box of a node's child as the shader reads it.
Bounds child_box(const GpuTree& tree, std::uint32_t node, std::uint32_t child) {
    Bounds box;
    const NodeRecord& record = tree.nodes[node];
    const uvec4* const sides[] = {&record.sides_x, &record.sides_y, &record.sides_z};
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t exponent = record.exponents_and_mask >> (8 * axis) & 255u;
        const float step = std::ldexp(1.0f, static_cast<int>(exponent) - 127);
        const auto side = [&](std::uint32_t word) {
            const std::uint32_t four = (*sides[axis])[static_cast<int>(word + child / 4)];
            return record.origin[axis] + static_cast<float>(four >> (8 * (child % 4)) & 255u) * step;
        };
        box.lo[axis] = side(0);
        box.hi[axis] = side(2);
    }
    return box;
}

/// What is found below a node.
struct Found {
    std::set<std::uint32_t> triangles, quadrics, instances;
};

bool holds(const Bounds& box, const vec3& p) {
    const float slack = 1e-6f * (glm::length(p) + 1);
    return glm::all(glm::lessThanEqual(box.lo - slack, p)) && glm::all(glm::lessThanEqual(p, box.hi + slack));
}

void visit_leaf(const GpuTree& tree, std::uint32_t code, const Bounds& box, Found& found) {
    const LeafCode leaf{code};
    for (std::uint32_t i = 0; i < leaf.triangles(); ++i)
        found.triangles.insert(tree.leaves[leaf.word() + 4 + 3 * leaf.vertices() + i]);
    // Cut triangles reach beyond their boxes: some vertex or the box's own side is near.
    for (std::uint32_t i = 0; i < leaf.vertices(); ++i) {
        vec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::bit_cast<float>(
                tree.leaves[leaf.word() + 4 + static_cast<std::uint32_t>(axis) * leaf.vertices() + i]);
        EXPECT_TRUE(holds(box, p)) << "a vertex outside its box";
    }
}

void visit(const GpuTree& tree, std::uint32_t node, int depth, Found& found) {
    ASSERT_LT(depth, tree.stack);
    for (std::uint32_t child = 0; child < 8; ++child) {
        if ((tree.nodes[node].exponents_and_mask >> (24 + child) & 1u) == 0) continue;
        const std::uint32_t code = tree.nodes[node].children[child];
        if (code >> 31 != 0)
            visit_leaf(tree, code, child_box(tree, node, child), found);
        else if (code >> 30 == 0)
            visit(tree, code, depth + 1, found);
        else if (code >> 29 == 3)
            EXPECT_TRUE(found.instances.insert(code & 0x1fffffffu).second);
        else
            for (std::uint32_t i = 0; i <= (code >> 24 & 31u); ++i)
                EXPECT_TRUE(found.quadrics.insert((code & 0xffffffu) + i).second);
    }
}

TEST(GpuTree, HoldsEverythingOnce) {
    for (const kit::Exhibit& exhibit : kit::gallery()) {
        const Scene scene = build_scene(exhibit.scene);
        const WorldData& world = scene.data().world.data();
        const GpuTree tree = build_gpu_tree(world);
        if (tree.root == invalid_index) continue;
        Found found;
        visit(tree, tree.root, 0, found);
        std::size_t triangles = 0;
        for (const trace::MeshTree* mesh : {&world.mesh_tree, &world.wide_tree})
            triangles += mesh->triangles - mesh->left_out;
        EXPECT_EQ(found.triangles.size(), triangles) << exhibit.name;
        EXPECT_EQ(found.quadrics.size(), world.quadrics.size()) << exhibit.name;
        EXPECT_EQ(found.instances.size(), world.instances.size()) << exhibit.name;
        for (std::size_t i = 0; i < world.shared_meshes.size(); ++i) {
            Found below;
            visit(tree, tree.mesh_roots[i], 0, below);
            EXPECT_EQ(below.triangles.size(), world.shared_meshes[i].tree.triangles) << exhibit.name;
        }
    }
}

} // namespace
} // namespace glint::gpu
