#pragma once
// Ray tracing for programs with their own triangles: meshes and rays in, hits out. Independent of the rest of
// glint: no scene files, pictures or vector library are needed. Mesh and Scene here are acceleration
// structures; glint::Mesh and glint::Scene (glint/scene.h) are data and rendered worlds, with materials,
// lights and a camera, and build their own.
//
//     using namespace glint::tracing;
//     const Mesh mesh(xyz, indices);                     // vectors, or anything that converts to std::span
//     mesh.closest(rays, hits, RayHint::coherent);       // hits[i] belongs to rays[i]
//     mesh.occluded(rays, blocked, RayHint::incoherent);
//
// Guarantees:
// - A ray gets the least (t, triangle), or (t, instance, triangle), of all hits: ties do not depend on the
//   tree.
// - Results are bitwise identical for all hints, kernels, build qualities, numbers of threads, SIMD targets
//   and compilers.
// - Watertight: a ray through an edge or a vertex of a closed mesh hits one of the adjacent triangles (Woop,
//   Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013, with exact signs). No epsilons: scaling a
//   mesh by a power of two does not change hits.
// - Triangles are hit from both sides; degenerate ones are never hit.
// - Const members may be called by any number of threads concurrently.
//
// Batches are faster from a few dozen rays on and best with 64 to 4096. Units are those of the vertices; t is
// in units of the length of the ray's direction, which need not be 1.

#include "glint/kernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

namespace glint::tracing {

/// The points origin + t · direction with tmin < t < tmax. 32 bytes. A ray with NaN, an infinite component or
/// no direction hits nothing.
struct Ray {
    std::array<float, 3> origin{0, 0, 0};
    float tmin = 0;
    std::array<float, 3> direction{0, 0, 1};
    float tmax = std::numeric_limits<float>::infinity();
};

/// The index of no triangle and no instance.
inline constexpr std::uint32_t none = 0xffffffffu;

/// A hit in a mesh. 16 bytes. The point is (1 − u − v) · vertex 0 + u · vertex 1 + v · vertex 2.
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    float u = 0;
    float v = 0;
    std::uint32_t triangle = none; ///< index in the order given

    explicit operator bool() const { return triangle != none; }
};

/// Choices of speed, never of results (glint/kernels.h).
using glint::BuildQuality;
using glint::Kernel;
using glint::KernelChoice;
using glint::RayHint;
using glint::SimdTarget;

/// Groups of three values in the caller's memory, `stride` bytes apart.
template <class T>
struct StridedView {
    const T* first;
    std::size_t count;
    std::size_t stride; ///< a multiple of 4, at least 12

    StridedView(const T* first_value, std::size_t groups, std::size_t bytes_apart)
        : first(first_value), count(groups), stride(bytes_apart) {}
};
using Vertices = StridedView<float>;          ///< x, y, z
using Triangles = StridedView<std::uint32_t>; ///< three vertex indices

struct BuildOptions {
    BuildQuality quality = BuildQuality::high;
    int threads = 0; ///< 0 or less: one per processor; the tree does not depend on it
};

/// A closed axis-aligned box; lo > hi if empty.
struct Box {
    std::array<float, 3> lo;
    std::array<float, 3> hi;
};

struct MeshStats {
    std::size_t triangles = 0; ///< number of triangles given
    std::size_t skipped = 0;   ///< number of these with a vertex that is not finite, which are never hit
    std::size_t nodes = 0;     ///< nodes with up to eight children
    std::size_t bytes = 0;     ///< memory of the tree; the caller's arrays are not needed
    int depth = 0;             ///< number of nodes on the longest path to a leaf
    BuildQuality quality = BuildQuality::high;
};

/// An acceleration structure over triangles (unlike glint::Mesh, which is vertices and triangles of a scene
/// description). Copies share one tree.
class Mesh {
  public:
    /// An empty mesh.
    Mesh();

    /// Vertices as x y z x y z …, triangles as three vertex indices each. The arrays are read during the call
    /// and not kept. Throws std::invalid_argument if a length is not a multiple of three or an index is out
    /// of range, std::length_error for too many triangles.
    Mesh(std::span<const float> vertices, std::span<const std::uint32_t> triangles,
         const BuildOptions& options = {});
    /// Reads from arrays of structures. A stride of 12 bytes avoids a temporary copy. Also throws
    /// std::invalid_argument for an invalid stride.
    Mesh(const Vertices& vertices, const Triangles& triangles, const BuildOptions& options = {});

    Mesh(const Mesh&) = default;
    Mesh& operator=(const Mesh&) = default;

    /// Updates the mesh for moved vertices: the same triangles in the same order with new positions. Much
    /// cheaper than a new mesh, with the same results; tracing gets slower the more the shape changed. Copies
    /// and scenes made before keep the old positions: if there are any, the tree is copied first. Throws as
    /// the constructor does, and std::invalid_argument if the number of triangles changed. Must not be called
    /// while other threads use this object.
    void refit(std::span<const float> vertices, std::span<const std::uint32_t> triangles, int threads = 0);
    void refit(const Vertices& vertices, const Triangles& triangles, int threads = 0);

    /// Closest hit of each ray, the least (t, triangle), or Hit{}. Throws std::invalid_argument if `rays` and
    /// `hits` differ in length, and for an unavailable SIMD target.
    void closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint,
                 const KernelChoice& choice = {}) const;
    Hit closest(const Ray& ray, const KernelChoice& choice = {}) const;

    /// 1 for each ray that hits any triangle, otherwise 0. Throws std::invalid_argument if `rays` and
    /// `blocked` differ in length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                  const KernelChoice& choice = {}) const;
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;

    /// Bounds of all triangles that can be hit.
    Box bounds() const;
    MeshStats stats() const;

  private:
    friend class Scene;
    struct Data;
    std::shared_ptr<const Data> data_;
};

/// p_world = m · (p_local, 1): three rows with the translation in the last column. May rotate, scale, mirror
/// and shear.
struct Transform {
    std::array<std::array<float, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

/// A mesh with a transform.
struct Instance {
    Mesh mesh;
    Transform world_from_local;
};

/// A hit in a scene. 20 bytes.
struct InstanceHit {
    float t = std::numeric_limits<float>::infinity();
    float u = 0;
    float v = 0;
    std::uint32_t triangle = none; ///< index in the instance's mesh
    std::uint32_t instance = none; ///< index in the order given

    explicit operator bool() const { return instance != none; }
};

/// Of a tracing::Scene (glint::SceneStats counts objects of a rendered scene).
struct SceneStats {
    std::size_t instances = 0;
    std::size_t meshes = 0; ///< number of different meshes; each is stored once
    std::size_t bytes = 0;  ///< memory of the instance tree and all meshes
};

/// An acceleration structure over instances of meshes, without materials or lights (unlike glint::Scene,
/// which can be rendered). Rays are transformed to an instance's space without normalizing the direction, so
/// t is the same in both; u and v refer to the mesh's triangle. Watertight within each instance. Copies share
/// all data. To move instances, make a new scene: it takes microseconds per instance.
class Scene {
  public:
    /// An empty scene.
    Scene();
    /// Shares ownership of the meshes. Throws std::invalid_argument for a transform that is not finite,
    /// nearly singular (it shrinks some direction more than a million times as much as another), or that
    /// exceeds the range of floats.
    explicit Scene(std::span<const Instance> instances, const BuildOptions& options = {});

    Scene(const Scene&) = default;
    Scene& operator=(const Scene&) = default;

    /// Closest hit of each ray, the least (t, instance, triangle), or InstanceHit{}. Throws
    /// std::invalid_argument if `rays` and `hits` differ in length.
    void closest(std::span<const Ray> rays, std::span<InstanceHit> hits, RayHint hint,
                 const KernelChoice& choice = {}) const;
    InstanceHit closest(const Ray& ray, const KernelChoice& choice = {}) const;

    /// 1 for each ray that hits any triangle, otherwise 0. Throws std::invalid_argument if `rays` and
    /// `blocked` differ in length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                  const KernelChoice& choice = {}) const;
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;

    /// Bounds of everything that can be hit, slightly enlarged.
    Box bounds() const;
    SceneStats stats() const;

  private:
    struct Data;
    std::shared_ptr<const Data> data_;
};

} // namespace glint::tracing
