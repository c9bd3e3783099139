#pragma once
// Triangles in a wide tree with compact leaves, and the batches of rays that go through it.

#include "bvh/tree.h"
#include "bvh/wide.h"
#include "glint/kernels.h"
#include "math/bounds.h"
#include "math/ray.h"
#include "math/vec.h"
#include "parallel/large_pages.h"
#include "parallel/task_pool.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace glint {

/// The least (t, triangle) of a ray, or triangle = no_triangle.
struct TriangleRecord {
    float t = std::numeric_limits<float>::infinity();
    float u = 0; ///< weight of vertex 1
    float v = 0; ///< weight of vertex 2
    std::uint32_t triangle = 0xffffffffu;
};
inline constexpr std::uint32_t no_triangle = 0xffffffffu;

/// What a caller knows of the rays of a batch. It decides the speed, never the answer.
enum class RayHint {
    coherent,  ///< neighbours in the batch go nearly the same way
    incoherent ///< they do not
};

/// What a build strives for. It decides the speed of rays, never their answers.
enum class BuildQuality {
    fast, ///< soon: to be built often, or for few rays
    high  ///< for many rays
};

/// A leaf's place in MeshTree::leaf_words: leaf_bit | triangles − 1 (3 bits) | vertices − 1 (3 bits) | offset
/// in units of 16 bytes (25 bits).
struct LeafCode {
    std::uint32_t code;
    std::uint32_t triangles() const { return ((code >> 28) & 7u) + 1; }
    std::uint32_t vertices() const { return ((code >> 25) & 7u) + 1; }
    std::size_t word() const { return std::size_t(code & 0x01ffffffu) * 4; }
};

/// Triangles over shared vertices, numbered from 0 in the order given.
///
/// A leaf is a block of 32-bit words: eight 16-bit words, each three 3-bit numbers of vertices (v0 in the low
/// bits), then x, y and z of all its vertices, then the numbers of its triangles. Vertices that triangles of
/// the leaf share are stored once.
struct MeshTree {
    LargeVector<WideNode> nodes;           ///< children: a node, or a LeafCode
    LargeVector<std::uint32_t> leaf_words; ///< with a tail that vector loads may read
    Bounds bounds;
    int depth = 0;
    /// How often a line through the bounds meets the surface on average: the triangles' area by half that of
    /// the bounds (Crofton's formula), estimated from some of them when it was built. It decides speed alone.
    double crossings = 0;
    std::size_t triangles = 0; ///< as given
    std::size_t left_out = 0;  ///< of these, with a vertex that is not finite
    BuildQuality quality = BuildQuality::high;

    std::size_t bytes() const { return nodes.size() * sizeof(WideNode) + leaf_words.size() * 4; }
};

/// Builds the tree with the pool's threads; it does not depend on their number. Triangles with a vertex that
/// is not finite are left out: nothing hits them. Throws std::length_error where the leaves exceed 512 MiB.
MeshTree build_mesh_tree(std::span<const vec3> positions, std::span<const uvec3> triangles, TaskPool& pool,
                         BuildQuality quality = BuildQuality::high);

/// Follows vertices that moved: leaves take the new positions, boxes grow and shrink with them, the shape of
/// the tree stays. Every ray is answered as by a new tree; after large movements more slowly. Where a vertex
/// is or was not finite the tree is built anew. Throws std::invalid_argument if the number of triangles is
/// not that of the build.
void refit(MeshTree& tree, std::span<const vec3> positions, std::span<const uvec3> triangles, TaskPool& pool);

/// One ray in plain C++, as the kernels must answer it.
TriangleRecord closest_scalar(const MeshTree& tree, const Ray& ray);
bool occluded_scalar(const MeshTree& tree, const Ray& ray);

/// The same with the machine's vectors.
TriangleRecord closest(const MeshTree& tree, const Ray& ray, const KernelChoice& choice = {});
bool occluded(const MeshTree& tree, const Ray& ray, const KernelChoice& choice = {});

/// The least (t, triangle) with tmin < t < tmax of each ray. rays and records have one length.
void closest(const MeshTree& tree, std::span<const Ray> rays, std::span<TriangleRecord> records, RayHint hint,
             const KernelChoice& choice = {});

/// Whether each ray hits anything with tmin < t < tmax: 1 or 0. rays and blocked have one length.
void occluded(const MeshTree& tree, std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
              const KernelChoice& choice = {});

} // namespace glint
