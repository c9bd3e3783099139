#pragma once
// Tracing for programs that bring their own triangles: meshes in, rays in, hits out. It stands alone: neither
// scene files nor pictures nor a library of vectors come with it.
//
//     using namespace glint::tracing;
//     const Mesh mesh(xyz, indices);                    // vectors, or whatever converts to std::span
//     mesh.closest(rays, hits, RayHint::coherent);      // hits[i] belongs to rays[i]
//     mesh.occluded(rays, blocked, RayHint::incoherent);
//
// What is promised:
// - Of all hits a ray gets the least (t, triangle), or (t, instance, triangle): no tree decides a tie.
// - The same bits for every hint, kernel, quality of the tree, number of threads, SIMD target and compiler.
// - Watertight: a ray that meets an edge or a vertex of a closed mesh hits one of the triangles there (Woop,
//   Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013, with exact signs). No epsilons: scaled by a
//   power of two, a mesh is hit alike.
// - Both sides of a triangle are hit. One without an area is hit by no ray.
// - Const members may be called by any number of threads at once.
//
// Batches pay from a few dozen rays on and are best with 64 to 4096. Units are those of the vertices; t
// counts in lengths of the ray's direction, which need not be 1.

#include "glint/kernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

namespace glint::tracing {

/// The points origin + t · direction with tmin < t < tmax. 32 bytes. A ray that is infinite, has a NaN, or
/// has no direction hits nothing.
struct Ray {
    std::array<float, 3> origin{0, 0, 0};
    float tmin = 0;
    std::array<float, 3> direction{0, 0, 1};
    float tmax = std::numeric_limits<float>::infinity();
};

/// Stands for no triangle and no instance.
inline constexpr std::uint32_t none = 0xffffffffu;

/// What a ray meets in a mesh. 16 bytes. The point is (1 − u − v) · vertex 0 + u · vertex 1 + v · vertex 2.
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    float u = 0;
    float v = 0;
    std::uint32_t triangle = none; ///< in the order given

    explicit operator bool() const { return triangle != none; }
};

/// Choices of speed, never of results (glint/kernels.h).
using glint::BuildQuality;
using glint::Kernel;
using glint::KernelChoice;
using glint::RayHint;
using glint::SimdTarget;

/// Vertices in the caller's memory: x, y, z as three floats, `stride` bytes from one vertex to the next.
struct Vertices {
    const float* first;
    std::size_t count;
    std::size_t stride; ///< a multiple of 4, at least 12

    Vertices(const float* first_vertex, std::size_t vertex_count, std::size_t bytes_apart)
        : first(first_vertex), count(vertex_count), stride(bytes_apart) {}
};

/// Triangles in the caller's memory: three numbers of vertices, `stride` bytes from one triangle to the next.
struct Triangles {
    const std::uint32_t* first;
    std::size_t count;
    std::size_t stride; ///< a multiple of 4, at least 12

    Triangles(const std::uint32_t* first_triangle, std::size_t triangle_count, std::size_t bytes_apart)
        : first(first_triangle), count(triangle_count), stride(bytes_apart) {}
};

struct BuildOptions {
    BuildQuality quality = BuildQuality::high;
    int threads = 0; ///< 0 or less: one for each core; the tree does not depend on it
};

/// An axis-aligned box, closed; lo > hi where there is nothing.
struct Box {
    std::array<float, 3> lo;
    std::array<float, 3> hi;
};

struct MeshStats {
    std::size_t triangles = 0; ///< as given
    std::size_t skipped = 0;   ///< of these: with a vertex that is not finite, hit by no ray
    std::size_t nodes = 0;     ///< of eight children each
    std::size_t bytes = 0;     ///< held by the tree and its leaves; the caller's arrays are not needed
    int depth = 0;             ///< nodes on the longest way to a leaf
    BuildQuality quality = BuildQuality::high;
};

/// Triangles ready for rays. Copies share one tree.
class Mesh {
  public:
    /// No triangles: no ray hits.
    Mesh();

    /// Vertices as x y z x y z …, triangles as three numbers of vertices each. The arrays are read during the
    /// call and not kept. Throws std::invalid_argument where a length is no multiple of three or a triangle
    /// names a vertex that there is not, std::length_error where there are too many triangles.
    Mesh(std::span<const float> vertices, std::span<const std::uint32_t> triangles,
         const BuildOptions& options = {});
    /// The same from arrays of structures. A stride of 12 bytes spares a copy during the call. Throws
    /// std::invalid_argument for a stride that is impossible too.
    Mesh(const Vertices& vertices, const Triangles& triangles, const BuildOptions& options = {});

    Mesh(const Mesh&) = default;
    Mesh& operator=(const Mesh&) = default;

    /// Follows vertices that moved: the same triangles, in the same order, over new positions. Much cheaper
    /// than a new mesh, and answers as one; slower to trace the more the shape has changed. Copies and scenes
    /// made before keep the old positions: while there are any, the tree is copied first. Throws as the
    /// constructor does, and std::invalid_argument where the number of triangles is another. Not to be called
    /// while other threads use this object.
    void refit(std::span<const float> vertices, std::span<const std::uint32_t> triangles, int threads = 0);
    void refit(const Vertices& vertices, const Triangles& triangles, int threads = 0);

    /// The least (t, triangle) of each ray; Hit{} where there is none. Throws std::invalid_argument unless
    /// rays and hits have one length, and for a SIMD target that the machine does not have.
    void closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint,
                 const KernelChoice& choice = {}) const;
    Hit closest(const Ray& ray, const KernelChoice& choice = {}) const;

    /// 1 where the ray meets any triangle, else 0. Throws std::invalid_argument unless rays and blocked have
    /// one length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                  const KernelChoice& choice = {}) const;
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;

    /// Around all triangles that can be hit.
    Box bounds() const;
    MeshStats stats() const;

  private:
    friend class Scene;
    struct Data;
    std::shared_ptr<const Data> data_;
};

/// p_world = m · (p_local, 1): three rows, the translation in the last column. Rotations, scales, mirrors and
/// shears may be in it.
struct Transform {
    std::array<std::array<float, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

/// A mesh at a place of the world.
struct Instance {
    Mesh mesh;
    Transform world_from_local;
};

/// What a ray meets in a scene. 20 bytes.
struct InstanceHit {
    float t = std::numeric_limits<float>::infinity();
    float u = 0;
    float v = 0;
    std::uint32_t triangle = none; ///< of the instance's mesh
    std::uint32_t instance = none; ///< in the order given

    explicit operator bool() const { return instance != none; }
};

struct SceneStats {
    std::size_t instances = 0;
    std::size_t meshes = 0; ///< different ones: each is stored once
    std::size_t bytes = 0;  ///< held by the tree of instances and all meshes
};

/// Meshes at many places. An instance is hit as its mesh is hit by the ray taken to its space, direction and
/// all, so that t counts alike in both; u and v are those of the mesh's triangle. Watertight within each
/// instance. Copies share everything. To move instances, make a new scene: it takes microseconds each.
class Scene {
  public:
    /// No instances: no ray hits.
    Scene();
    /// Keeps the meshes alive. Throws std::invalid_argument for a transform that is not finite, or singular:
    /// one that squeezes some direction more than a million times as much as another, or that puts a mesh
    /// beyond the range of floats.
    explicit Scene(std::span<const Instance> instances, const BuildOptions& options = {});

    Scene(const Scene&) = default;
    Scene& operator=(const Scene&) = default;

    /// The least (t, instance, triangle) of each ray; InstanceHit{} where there is none. Throws
    /// std::invalid_argument unless rays and hits have one length.
    void closest(std::span<const Ray> rays, std::span<InstanceHit> hits, RayHint hint,
                 const KernelChoice& choice = {}) const;
    InstanceHit closest(const Ray& ray, const KernelChoice& choice = {}) const;

    /// 1 where the ray meets any triangle, else 0. Throws std::invalid_argument unless rays and blocked have
    /// one length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                  const KernelChoice& choice = {}) const;
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;

    /// Around all that can be hit, and a little more.
    Box bounds() const;
    SceneStats stats() const;

  private:
    struct Data;
    std::shared_ptr<const Data> data_;
};

} // namespace glint::tracing
