#pragma once
// The tree that shaders walk: one for everything, eight children a node, their boxes in bytes. After Ylitie,
// Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017.
//
// A node is six times four words:
//
//     origin x, y, z (floats) | exponents of x, y, z (8 bits each, biased by 127), which children there are
//     codes of the children 0 … 3
//     codes of the children 4 … 7
//     low sides along x of 0 … 3, of 4 … 7 (a byte each) | high sides
//     the same along y
//     the same along z
//
// A side is origin + byte · 2^exponent, rounded outward. Child i lies toward +x, +y, +z of the others where
// bits 0, 1, 2 of i are set: rays enter the children in the order of i xor the signs of their direction,
// unsorted. Codes: bit 31: a leaf of triangles (trace/mesh_tree.h: LeafCode); bits 31 … 29 = 011: an
// instance; 010: quadrics, count − 1 (5 bits) and the first (24 bits); else a node.

#include "math/vec.h"

#include <cstdint>
#include <vector>

namespace glint {

struct WorldData;

struct GpuTree {
    static constexpr std::uint32_t no_root = 0xffffffffu;

    std::vector<uvec4> nodes;
    std::vector<std::uint32_t> leaves; ///< MeshTree::leaf_words of all meshes
    std::uint32_t root = no_root;
    std::vector<std::uint32_t> mesh_roots; ///< of the shared meshes
    std::vector<float> mesh_corners;       ///< the largest |coordinate| of their boxes
    float corner = 0;                      ///< of boxes in the world
    int stack = 0;                         ///< entries that a walk may need
};

/// Throws Error(device) for a world with too many nodes or leaves for codes of 32 bits.
GpuTree build_gpu_tree(const WorldData& world);

} // namespace glint
