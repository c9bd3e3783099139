#pragma once
// The tree that shaders traverse: one for everything, eight children a node, their boxes quantized to bytes.
// After Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG
// 2017.
//
// A node is a NodeRecord (gpu/records.shared.h). A side of a child's box is origin + byte · 2^exponent,
// rounded outward. Child i lies toward +x, +y, +z of the others where bits 0, 1, 2 of i are set: rays enter
// the children in the order of i xor the signs of their direction, unsorted. Codes: bit 31: a leaf of
// triangles (trace/mesh/tree.h: LeafCode); bits 31 … 29 = 011: an instance, by its object; 010: quadrics,
// count − 1 (5 bits) and the first (24 bits); else a node.

#include "gpu/records.shared.h"
#include "trace/world/data.h"

#include <cstdint>
#include <vector>

namespace glint::gpu {

struct GpuTree {
    std::vector<NodeRecord> nodes;
    std::vector<std::uint32_t> leaves; ///< MeshTree::leaf_words of all meshes, those of wide ones last
    std::uint32_t first_wide_leaf = invalid_index; ///< offset of the wide ones, as in LeafCode
    std::uint32_t root = invalid_index;
    std::vector<std::uint32_t> mesh_roots;   ///< of the shared meshes
    std::vector<float> mesh_max_coordinates; ///< the largest |coordinate| of their boxes
    float max_coordinate = 0;                ///< that of boxes in the world
    int stack = 0;                           ///< entries that a traversal may need
};

/// Throws Error(device) for a world with too many nodes or leaves for codes of 32 bits.
GpuTree build_gpu_tree(const trace::WorldData& world);

} // namespace glint::gpu
