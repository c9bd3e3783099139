#pragma once
// Baking of triangles and points: meshes and their instances. Private to this room.

#include "scene/bake.h"

#include <map>

namespace glint::scene {

inline dvec3 transform_point(const dmat4& m, const dvec3& p) { return dvec3(m * dvec4(p, 1.0)); }

/// Radius of the spheres that show the points of a mesh without faces, before its scale.
double point_radius(const MeshShape& s);

/// Bounds of a transformed box.
Bounds transform_box(const dmat4& m, const dvec3& lo, const dvec3& hi);

/// Adds triangles in world space as object `id`. Closed shapes are oriented outward, judged by the sign of
/// their volume.
void add_triangles(Baked& baked, trace::WorldInput::Triangles triangles, std::uint32_t id, bool closed);

/// Bakes meshes in world space, and their instances as references to one in local space. How an object is
/// baked does not depend on the others, so neither does its picture.
class MeshBaker {
  public:
    /// All arguments must outlive this object.
    MeshBaker(bool need_closedness, const std::function<void()>& between, Baked& baked);

    enum class BakedAs { triangles, instance };

    /// Adds the mesh of object `source` as object `id`, transformed by its own origin and scale, then by
    /// `transform`.
    void bake(const Object& source, const dmat4& transform, std::uint32_t id, BakedAs how);

  private:
    /// Data shared by all instances of a mesh.
    struct Shared {
        std::uint32_t mesh = 0; ///< index into WorldInput::shared_meshes
        Bounds bounds;          ///< in the mesh's space
        bool closed = false;
        double volume = 0; ///< of closed meshes; negative if wound inside out
        std::int32_t attributes = no_attributes;
    };

    void bake_points(const MeshShape& s, const dmat4& m, std::uint32_t id);
    void bake_once(const MeshShape& s, const dmat4& m, std::uint32_t id);
    const Shared& shared(const Object& source);
    void add_instance(const Shared& mesh, const dmat4& m, std::uint32_t id);
    std::int32_t add_attributes(const MeshShape& s, MeshAttributes attributes);

    bool need_closedness_;
    const std::function<void()>& between_;
    Baked& baked_;
    std::map<const Object*, Shared> shared_;
};

} // namespace glint::scene
