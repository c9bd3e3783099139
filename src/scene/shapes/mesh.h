#pragma once
// Meshes and their instances. scene/bake_mesh.h does the work.

#include "geometry/point_cloud.h"
#include "scene/shapes/shape_baker.h"

namespace glint::scene {

/// Baking finds out whether a mesh is closed.
inline bool has_inside(const MeshShape&) { return true; }
inline bool has_inside(const InstanceShape&) { return true; }

/// Over the vertices that faces use, or over the points without outliers where there are no faces.
inline double farthest(const Mesh& mesh, const dvec3& d) {
    double most = no_support;
    for (const uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) raise_support(most, d, dvec3(mesh.positions[t[corner]]));
    if (mesh.triangles.empty()) {
        const Bounds kept = geometry::cloud_without_outliers(mesh.positions);
        for (const vec3& p : mesh.positions)
            if (kept.contains(p)) raise_support(most, d, dvec3(p));
    }
    return most + glm::dot(d, mesh.origin);
}

inline double support(const MeshShape& s, const dvec3& d) {
    if (!s.data) return no_support;
    const double radius = s.data->triangles.empty() ? point_radius(s) : 0;
    return farthest(*s.data, s.scale * d) + radius * glm::length(s.scale * d);
}
/// support() of a scene (scene/support.h) looks up the mesh.
inline double support(const InstanceShape&, const dvec3&) { return no_support; }

/// Around the finite vertices as stored, before the mesh's own scale.
inline ShapeBox box(const MeshShape& s) {
    ShapeBox box;
    if (!s.data) return box;
    for (const vec3& p : s.data->positions)
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
            box.grow(s.data->origin + dvec3(p));
    return box;
}

inline void bake(const MeshShape&, ShapeBaker& out) { out.mesh(); }
inline void bake(const InstanceShape& s, ShapeBaker& out) { out.instance(s.mesh); }

} // namespace glint::scene
