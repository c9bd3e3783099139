#pragma once
// A BVH over triangles with eight children a node and compact leaves, and the kernels that trace rays through
// it.

#include "bvh/tree.h"
#include "bvh/wide.h"
#include "glint/kernels.h"
#include "glint/trace.h"
#include "math/bounds.h"
#include "math/index.h"
#include "math/ray.h"
#include "math/vec.h"
#include "parallel/large_pages.h"
#include "parallel/task_pool.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace glint::trace {

using namespace bvh;

/// The least (t, triangle) of a ray, or triangle = invalid_index.
using TriangleRecord = tracing::Hit;

/// Position of a leaf in MeshTree::leaf_words: leaf_bit | triangles − 1 (3 bits) | vertices − 1 (3 bits) |
/// offset in units of 16 bytes (25 bits).
struct LeafCode {
    std::uint32_t code;
    std::uint32_t triangles() const { return ((code >> 28) & 7u) + 1; }
    std::uint32_t vertices() const { return ((code >> 25) & 7u) + 1; }
    std::size_t word() const { return std::size_t(code & 0x01ffffffu) * 4; }
};

/// A tree over indexed triangles, which are numbered from 0 in the order given.
///
/// A leaf is a block of 32-bit words: eight 16-bit words, each with three 3-bit vertex indices (v0 in the low
/// bits), then x, y and z of all its vertices, then the triangle indices. Vertices shared by triangles of the
/// leaf are stored once.
struct MeshTree {
    parallel::LargeVector<WideNode> nodes;           ///< child codes: a node index or a LeafCode
    parallel::LargeVector<std::uint32_t> leaf_words; ///< with padding at the end for vector loads
    Bounds bounds;
    int depth = 0;
    /// Average number of surface crossings of a random line through the bounds: triangle area divided by half
    /// the area of the bounds (Crofton's formula), estimated from a subset at build time. Affects speed only.
    double depth_complexity = 0;
    std::size_t triangles = 0; ///< number of triangles given
    std::size_t left_out = 0;  ///< number of these with a vertex that is not finite
    BuildQuality quality = BuildQuality::high;

    std::size_t bytes() const { return nodes.size() * sizeof(WideNode) + leaf_words.size() * 4; }
};

/// Throws std::invalid_argument for a vertex index out of range.
void check_corners(std::span<const vec3> positions, std::span<const uvec3> triangles);

/// Builds a tree; it does not depend on the number of threads. Triangles with a vertex that is not finite are
/// left out, so nothing hits them. Throws std::length_error if the leaves exceed 512 MiB.
MeshTree build_mesh_tree(std::span<const vec3> positions, std::span<const uvec3> triangles,
                         parallel::TaskPool& pool, BuildQuality quality = BuildQuality::high);

/// Updates a tree for moved vertices: leaves get the new positions and boxes are recomputed; the topology
/// stays. Rays get the same results as from a new tree, more slowly after large movements. If a vertex is or
/// was not finite the tree is rebuilt. Throws std::invalid_argument if the number of triangles differs from
/// that of the build.
void refit(MeshTree& tree, std::span<const vec3> positions, std::span<const uvec3> triangles,
           parallel::TaskPool& pool);

/// Single-ray queries with the chosen kernel.
TriangleRecord closest(const MeshTree& tree, const Ray& ray, const KernelChoice& choice = {});
bool occluded(const MeshTree& tree, const Ray& ray, const KernelChoice& choice = {});

/// The least (t, triangle) with tmin < t < tmax of each ray. `rays` and `records` have equal length.
void closest(const MeshTree& tree, std::span<const Ray> rays, std::span<TriangleRecord> records, RayHint hint,
             const KernelChoice& choice = {});

/// Whether each ray hits anything with tmin < t < tmax: 1 or 0. `rays` and `blocked` have equal length.
void occluded(const MeshTree& tree, std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
              const KernelChoice& choice = {});

} // namespace glint::trace
