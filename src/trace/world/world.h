#pragma once
// World: all primitives of a scene in trees; combines bvh/ and geometry/. Knows shapes and object numbers,
// but no materials.

#include "geometry/quadric.h"
#include "geometry/surface.shared.h"
#include "math/bounds.h"
#include "math/index.h"
#include "math/ray.h"
#include "math/vec.h"
#include "parallel/task_pool.h"
#include "trace/mesh/tree.h"
#include "trace/world/instance_tree.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace glint::trace {

enum class PrimKind : std::uint8_t { none, triangle, quadric, plane };

/// A hit. Of all hits of a ray the closest is the least (t, object, prim).
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    /// Triangle: weight of vertex 1. Quadric: 0 if the ray enters, 1 if it leaves.
    float u = 0;
    float v = 0; ///< triangle: weight of vertex 2
    std::uint32_t object = invalid_index;
    std::uint32_t prim = 0; ///< primitive index within its object, in file order
    PrimKind kind = PrimKind::none;
    bool on_edge = false;  ///< triangle: hit exactly on an edge or a vertex
    bool positive = false; ///< triangle: met on its positive side. Set only by next() and all_hits()

    explicit operator bool() const { return kind != PrimKind::none; }
};

/// True for a hit after which no other need be found. Hits are asked about in no order.
using EndsSearch = std::function<bool(const Hit&)>;

/// Order of hits by (t, object, prim); at equal t a quadric is entered before it is left.
bool precedes(const Hit& a, const Hit& b);

/// Surface points of many hits as structure of arrays, indexed like the hits. Up to seven elements behind the
/// last are overwritten.
struct SurfaceRows {
    std::array<float*, 3> p, p_error, n;
};

/// Cost of a closest-hit query in scalar traversal.
struct TraceCost {
    std::uint32_t nodes = 0;  ///< nodes whose boxes were tested
    std::uint32_t shapes = 0; ///< triangles, quadrics and planes tested
};

/// Input of World. Quadrics are in double precision: their equations are solved in double and rounded once.
/// An object has one shape: one entry here, or several quadrics with different `prim`.
struct WorldInput {
    struct Triangles {
        std::uint32_t object = 0;
        std::vector<vec3> positions; ///< world space
        std::vector<uvec3> triangles;
        bool flip = false; ///< turn the normals against the winding
        bool wide = false; ///< trace these in double, and slower: see geometry/triangle.h
    };
    /// A mesh in local space, stored once for any number of instances.
    struct SharedMesh {
        std::shared_ptr<const std::vector<vec3>> positions;
        std::shared_ptr<const std::vector<uvec3>> triangles;
    };
    struct Instance {
        std::uint32_t object = 0;
        std::uint32_t mesh = 0;     ///< index into `shared_meshes`
        dmat4 world_from_mesh{1.0}; ///< affine and regular
        bool flip = false;          ///< normals are opposite to the winding in world space
        bool wide = false;          ///< bake it into world space, as a wide mesh
    };
    struct Quadric {
        std::uint32_t object = 0;
        std::uint32_t prim = 0;
        QuadricShape shape{};
        std::int32_t affine = -1; ///< index into `world_from_local`, or -1: already in world space
    };
    /// normal · p = offset; the normal may have any length but 0.
    struct Plane {
        std::uint32_t object = 0;
        dvec3 normal{0, 0, 1};
        double offset = 0;
    };
    std::vector<Triangles> meshes;
    std::vector<SharedMesh> shared_meshes;
    std::vector<Instance> instances;
    std::vector<Quadric> quadrics;
    std::vector<Plane> planes;
    std::vector<dmat4> world_from_local; ///< affine and regular
    BuildQuality quality = BuildQuality::high;
};

struct WorldStats {
    std::uint64_t triangles = 0; ///< triangles, counting those of shared meshes once per instance
    std::array<std::uint64_t, quadric_kinds> quadrics{}; ///< by kind
    std::uint64_t planes = 0;
    std::uint64_t nodes = 0;
    int depth = 0; ///< depth of the deepest tree, adding that of the instance tree for shared meshes
    std::uint64_t bytes = 0; ///< memory, counting shared meshes once
    BuildQuality quality = BuildQuality::high;
};

struct WorldData;

/// Copies share everything.
class World {
  public:
    World();
    /// Builds the trees; the result does not depend on the number of threads. Throws std::invalid_argument
    /// for an index out of range and for a quadric without finite bounds. Triangles with a vertex that is not
    /// finite are never hit.
    World(WorldInput input, parallel::TaskPool& pool);

    /// The least (t, object, prim) with tmin < t < tmax; kind `none` if there is none.
    Hit closest(const Ray& ray, const KernelChoice& choice = {}) const;
    /// The next hit after `previous` on the same ray, for skipping surfaces without moving the origin. Two
    /// hits of a mesh on a shared edge count once.
    Hit next(const Ray& ray, const Hit& previous) const;
    /// Whether there is any hit with tmin < t < tmax.
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;
    /// Scratch memory of batch queries; one per thread.
    struct Scratch {
        std::vector<Ray> rays;
        std::vector<std::uint32_t> numbers;
        std::vector<TriangleRecord> records;
        std::vector<InstanceRecord> instance_records;
        std::vector<std::uint8_t> flags;
    };
    /// Batch version; both spans must have equal length.
    void closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint, Scratch& scratch,
                 const KernelChoice& choice = {}) const;
    /// 1 for each ray that hits something, otherwise 0; both spans must have equal length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint, Scratch& scratch,
                  const KernelChoice& choice = {}) const;
    /// All hits with tmin < t < tmax in order; those on a shared edge of a mesh once. False, with nothing of
    /// use in `out`, if one of them ends the search.
    bool all_hits(const Ray& ray, std::vector<Hit>& out, const EndsSearch& ends = {}) const;
    /// closest() by testing every primitive: the reference for the trees.
    Hit closest_brute_force(const Ray& ray) const;
    bool occluded_brute_force(const Ray& ray) const;

    /// Steps of closest() in scalar traversal, the same on every machine.
    TraceCost cost(const Ray& ray) const;

    SurfacePoint surface(const Ray& ray, const Hit& hit) const;
    /// Batch version, only for planes and quadrics without local space: sets done[i] to 1 for these.
    /// Otherwise sets done[i] to 0, and the output for the hit is undefined.
    void surfaces(std::span<const Ray> rays, std::span<const Hit> hits, const SurfaceRows& rows,
                  std::span<std::uint8_t> done, const KernelChoice& choice = {}) const;

    Bounds bounds() const; ///< of everything finite
    WorldStats stats() const;
    const WorldData& data() const; ///< for backends with their own trees

  private:
    std::shared_ptr<const WorldData> data_;
};

} // namespace glint::trace
