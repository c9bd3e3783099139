#pragma once
// Everything that rays can hit, in trees: combines bvh/ and geometry/. It knows shapes and numbers of
// objects, nothing of materials.

#include "geometry/quadric.h"
#include "geometry/surface.shared.h"
#include "math/bounds.h"
#include "math/ray.h"
#include "math/vec.h"
#include "parallel/task_pool.h"
#include "trace/mesh/tree.h"
#include "trace/world/instance_tree.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace glint::trace {

enum class PrimKind : std::uint8_t { none, triangle, quadric, plane };

/// Where a ray meets the world. Of all hits the closest is the least (t, object, prim).
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    /// Triangle: weight of vertex 1 (the report's β). Quadric: 0 on the ray's way in, 1 on its way out.
    float u = 0;
    float v = 0; ///< triangle: weight of vertex 2 (the report's γ)
    std::uint32_t object = 0xffffffffu;
    std::uint32_t prim = 0; ///< within its object, in the order of the file
    PrimKind kind = PrimKind::none;
    bool on_edge = false; ///< triangle: exactly through an edge or a vertex

    explicit operator bool() const { return kind != PrimKind::none; }
};

/// (t, object, prim) of a before those of b; of one quadric's two hits at one t, the way in before the way
/// out.
bool precedes(const Hit& a, const Hit& b);

/// Surface points of many hits: each row has one number of each, at the hit's place. Up to seven more numbers
/// are written behind the last.
struct SurfaceRows {
    std::array<float*, 3> p, p_error, n;
};

/// What a search for the closest hit does, counted on a plain walk through the trees.
struct TraceCost {
    std::uint32_t nodes = 0;  ///< whose boxes were tested
    std::uint32_t shapes = 0; ///< triangles, quadrics and planes that were tested
};

/// Plain input of World. Quadrics in double: their equations are solved in double and rounded once. An object
/// has one shape: one entry here, or several quadrics with different `prim`.
struct WorldInput {
    struct Triangles {
        std::uint32_t object = 0;
        std::vector<vec3> positions; ///< world space
        std::vector<uvec3> triangles;
        bool flip = false; ///< turn the normals against the winding
    };
    /// A mesh in a space of its own, to stand in the world any number of times. Stored once.
    struct SharedMesh {
        std::shared_ptr<const std::vector<vec3>> positions;
        std::shared_ptr<const std::vector<uvec3>> triangles;
    };
    struct Instance {
        std::uint32_t object = 0;
        std::uint32_t mesh = 0;     ///< index into `shared_meshes`
        dmat4 world_from_mesh{1.0}; ///< affine and regular
        bool flip = false;          ///< turn the normals against the winding as it is in the world
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
    std::uint64_t triangles = 0; ///< those of a shared mesh as often as it stands there
    std::array<std::uint64_t, quadric_kinds> quadrics{}; ///< by kind
    std::uint64_t planes = 0;
    std::uint64_t nodes = 0;
    int depth = 0;           ///< a shared mesh's below that of the tree of instances
    std::uint64_t bytes = 0; ///< shared meshes once
    BuildQuality quality = BuildQuality::high;
};

struct WorldData;

class World {
  public:
    World();
    /// Builds the trees with the pool's threads; the result does not depend on their number. Throws
    /// std::invalid_argument for an index out of range and for a quadric without finite bounds. Triangles
    /// with a corner that is not finite are never hit.
    World(WorldInput input, TaskPool& pool);
    ~World();
    World(const World&); ///< copies share everything
    World& operator=(const World&);
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    /// The least (t, object, prim) with tmin < t < tmax; kind `none` if there is none.
    Hit closest(const Ray& ray, const KernelChoice& choice = {}) const;
    /// The least one after `previous` on the same ray: surfaces passed over one by one, without new origins.
    /// Two hits of one mesh on a shared edge are one crossing, and it is not given twice.
    Hit next(const Ray& ray, const Hit& previous) const;
    /// Is there any hit with tmin < t < tmax?
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;
    /// Memory that questions for many rays work in; one for each thread.
    struct Scratch {
        std::vector<Ray> rays;
        std::vector<std::uint32_t> numbers;
        std::vector<TriangleRecord> records;
        std::vector<InstanceRecord> instance_records;
        std::vector<std::uint8_t> flags;
    };
    /// The same for many rays at once; both spans have one length.
    void closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint, Scratch& scratch,
                 const KernelChoice& choice = {}) const;
    /// 1 for every ray that meets something, else 0; both spans have one length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint, Scratch& scratch,
                  const KernelChoice& choice = {}) const;
    /// All crossings with tmin < t < tmax in order; those on a shared edge of one mesh once.
    void all_hits(const Ray& ray, std::vector<Hit>& out) const;
    /// The same as closest(), by testing every primitive: the oracle of the trees.
    Hit closest_brute_force(const Ray& ray) const;
    bool occluded_brute_force(const Ray& ray) const;

    /// The steps of closest(), as a plain walk takes them: the same on every machine.
    TraceCost cost(const Ray& ray) const;

    SurfacePoint surface(const Ray& ray, const Hit& hit) const;
    /// The same for many, but only where done[i] becomes 1: on planes and quadrics of the world's own space.
    /// Else it becomes 0, and what is written for the hit has no meaning.
    void surfaces(std::span<const Ray> rays, std::span<const Hit> hits, const SurfaceRows& rows,
                  std::span<std::uint8_t> done, const KernelChoice& choice = {}) const;

    Bounds bounds() const; ///< of everything finite
    WorldStats stats() const;
    const WorldData& data() const; ///< trace/world/data.h, for backends that have trees of their own

  private:
    struct Data;
    std::shared_ptr<const Data> data_;
};

} // namespace glint::trace
