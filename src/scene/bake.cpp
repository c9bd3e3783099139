#include "scene/bake.h"

#include "geometry/polyhedron.h"
#include "scene/bake_mesh.h"
#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glint {
namespace {

// The factor by which m stretches all lengths alike, or 0 if it does not.
double similarity_scale(const dmat4& m) {
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double xx = glm::dot(x, x), yy = glm::dot(y, y), zz = glm::dot(z, z);
    const double skew = std::max({std::abs(glm::dot(x, y)), std::abs(glm::dot(y, z)),
                                  std::abs(glm::dot(z, x)), std::abs(xx - yy), std::abs(yy - zz)});
    return skew <= 1e-12 * xx ? std::sqrt(xx) : 0;
}

Polyhedron polyhedron_of(const PolyhedronShape& s) {
    const Footing footing{s.center, s.axis, s.sides, s.radius, s.height};
    switch (s.kind) {
    case PolyhedronKind::box:
        return make_box(s.center, s.size);
    case PolyhedronKind::tetrahedron:
        return make_tetrahedron(s.center, s.radius);
    case PolyhedronKind::octahedron:
        return make_octahedron(s.center, s.radius);
    case PolyhedronKind::dodecahedron:
        return make_dodecahedron(s.center, s.radius);
    case PolyhedronKind::icosahedron:
        return make_icosahedron(s.center, s.radius);
    case PolyhedronKind::prism:
        return make_prism(footing);
    case PolyhedronKind::pyramid:
        return make_pyramid(footing);
    }
    return {};
}

class Baker {
  public:
    Baker(const SceneDescription& description, bool need_closedness, const std::function<void()>& between)
        : scene_(description), between_(between), meshes_(description, need_closedness, between, baked_) {
        baked_.objects.resize(description.objects.size());
    }

    Baked run() {
        rank_objects();
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            between_();
            bake_object(static_cast<std::uint32_t>(i));
        }
        return std::move(baked_);
    }

  private:
    // Of overlapping solids the higher priority owns the space, of equal ones the later in the file.
    void rank_objects() {
        std::vector<std::uint32_t> order(scene_.objects.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
            return scene_.objects[a].priority < scene_.objects[b].priority;
        });
        for (std::uint32_t rank = 0; rank < order.size(); ++rank) baked_.objects[order[rank]].rank = rank;
    }

    void bake_object(std::uint32_t id) {
        const Object& object = scene_.objects[id];
        const Material* material = material_of(scene_, object);
        baked_.objects[id].material = static_cast<std::uint32_t>(material - scene_.materials.data());
        if (!object.visible) return;
        std::visit([&](const auto& shape) { bake_shape(shape, object, id); }, object.shape);
        check_bounds(object, baked_.objects[id].bounds);
    }

    void check_bounds(const Object& object, const Bounds& bounds) const {
        if (bounds.empty()) return;
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        if (far.x <= coordinate_limit && far.y <= coordinate_limit && far.z <= coordinate_limit) return;
        throw Error(ErrorKind::input, "the object reaches beyond coordinates of 1e12 after its transform",
                    "scale it down, or move it nearer to the origin", object.where);
    }

    std::int32_t add_affine(const dmat4& m) {
        baked_.input.world_from_local.push_back(m);
        return static_cast<std::int32_t>(baked_.input.world_from_local.size()) - 1;
    }

    // p on the plane where n · A⁻¹(p − t) = offset, so the new normal is A⁻ᵀ n and the offset moves by it.
    void bake_shape(const PlaneShape& s, const Object& object, std::uint32_t id) {
        WorldInput::Plane plane{id, s.normal, s.offset};
        if (object.transform != dmat4(1.0)) {
            const dmat3 a(object.transform);
            plane.normal = glm::transpose(glm::inverse(a)) * s.normal;
            plane.offset = s.offset + glm::dot(plane.normal, dvec3(object.transform[3]));
        }
        baked_.input.planes.push_back(plane);
        baked_.objects[id].solid = s.solid;
    }

    void bake_shape(const SphereShape& s, const Object& object, std::uint32_t id) {
        add_sphere(s.center, s.radius, object.transform, id, 0);
        baked_.objects[id].solid = true;
    }

    void add_sphere(const dvec3& center, double radius, const dmat4& m, std::uint32_t id,
                    std::uint32_t prim) {
        WorldInput::Sphere sphere{id, prim, center, radius, -1};
        if (m != dmat4(1.0)) {
            const double scale = similarity_scale(m);
            if (scale > 0) {
                sphere.center = transform_point(m, center);
                sphere.radius = radius * scale;
            } else {
                sphere.affine = add_affine(m);
            }
        }
        baked_.input.spheres.push_back(sphere);
        baked_.objects[id].bounds.grow(transform_box(m, center - radius, center + radius));
    }

    void bake_shape(const CylinderShape& s, const Object& object, std::uint32_t id) {
        WorldInput::Cylinder cylinder{id, s.base, glm::normalize(s.axis), s.height, s.radius, -1};
        const dvec3 top = s.base + cylinder.axis * s.height;
        const dvec3 reach(s.radius);
        baked_.objects[id].bounds =
            transform_box(object.transform, glm::min(s.base, top) - reach, glm::max(s.base, top) + reach);
        if (object.transform != dmat4(1.0)) {
            const double scale = similarity_scale(object.transform);
            if (scale > 0) {
                cylinder.base = transform_point(object.transform, s.base);
                cylinder.axis = glm::normalize(dmat3(object.transform) * cylinder.axis);
                cylinder.height *= scale;
                cylinder.radius *= scale;
            } else {
                cylinder.affine = add_affine(object.transform);
            }
        }
        baked_.input.cylinders.push_back(cylinder);
        baked_.objects[id].solid = true;
    }

    void bake_shape(const TriangleShape& s, const Object& object, std::uint32_t id) {
        WorldInput::Triangles triangles;
        for (const Vec3& p : s.vertices)
            triangles.positions.push_back(vec3(transform_point(object.transform, p)));
        triangles.triangles.push_back(uvec3(0, 1, 2));
        add_triangles(baked_, std::move(triangles), id, false);
    }

    void bake_shape(const PolyhedronShape& s, const Object& object, std::uint32_t id) {
        const Polyhedron solid = polyhedron_of(s);
        WorldInput::Triangles triangles;
        for (const dvec3& p : solid.positions)
            triangles.positions.push_back(vec3(transform_point(object.transform, p)));
        triangles.triangles = solid.triangles;
        add_triangles(baked_, std::move(triangles), id, true);
    }

    void bake_shape(const MeshShape&, const Object& object, std::uint32_t id) {
        meshes_.bake(object, object.transform, id);
    }

    void bake_shape(const InstanceShape& s, const Object& object, std::uint32_t id) {
        const Object& mesh = *find_mesh(scene_, s.mesh);
        meshes_.bake(mesh, object.transform * mesh.transform, id);
    }

    const SceneDescription& scene_;
    const std::function<void()>& between_;
    Baked baked_;
    MeshBaker meshes_;
};

} // namespace

Baked bake(const SceneDescription& description, bool need_closedness, const std::function<void()>& between) {
    return Baker(description, need_closedness, between).run();
}

} // namespace glint
