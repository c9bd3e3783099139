#include "scene/bake.h"

#include "geometry/mesh.h"
#include "geometry/polyhedron.h"
#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glint {
namespace {

constexpr float coordinate_limit = 1e12f;

vec3 to_float(const dvec3& p) { return vec3(p); }

dvec3 transform_point(const dmat4& m, const dvec3& p) { return dvec3(m * dvec4(p, 1.0)); }

// The factor by which m stretches all lengths alike, or 0 if it does not.
double similarity_scale(const dmat4& m) {
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double xx = glm::dot(x, x), yy = glm::dot(y, y), zz = glm::dot(z, z);
    const double skew = std::max({std::abs(glm::dot(x, y)), std::abs(glm::dot(y, z)),
                                  std::abs(glm::dot(z, x)), std::abs(xx - yy), std::abs(yy - zz)});
    return skew <= 1e-12 * xx ? std::sqrt(xx) : 0;
}

double largest_stretch(const dmat4& m) {
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    return std::sqrt(std::max({glm::dot(x, x), glm::dot(y, y), glm::dot(z, z)}));
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

// Bounds of the image of a box under an affine map.
Bounds transform_box(const dmat4& m, const dvec3& lo, const dvec3& hi) {
    Bounds bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p((corner & 1) != 0 ? hi.x : lo.x, (corner & 2) != 0 ? hi.y : lo.y,
                      (corner & 4) != 0 ? hi.z : lo.z);
        bounds.grow(to_float(transform_point(m, p)));
    }
    return bounds;
}

class Baker {
  public:
    Baker(const SceneDescription& description, bool need_closedness)
        : scene_(description), need_closedness_(need_closedness) {
        baked_.objects.resize(description.objects.size());
    }

    Baked run() {
        rank_objects();
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) bake_object(static_cast<std::uint32_t>(i));
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
            triangles.positions.push_back(to_float(transform_point(object.transform, p)));
        triangles.triangles.push_back(uvec3(0, 1, 2));
        add_triangles(std::move(triangles), id, false);
    }

    void bake_shape(const PolyhedronShape& s, const Object& object, std::uint32_t id) {
        const Polyhedron solid = polyhedron_of(s);
        WorldInput::Triangles triangles;
        for (const dvec3& p : solid.positions)
            triangles.positions.push_back(to_float(transform_point(object.transform, p)));
        triangles.triangles = solid.triangles;
        add_triangles(std::move(triangles), id, true);
    }

    void bake_shape(const MeshShape& s, const Object& object, std::uint32_t id) {
        bake_mesh(s, object.transform, id);
    }

    void bake_shape(const InstanceShape& s, const Object& object, std::uint32_t id) {
        const Object& mesh = *find_mesh(scene_, s.mesh);
        bake_mesh(std::get<MeshShape>(mesh.shape), object.transform * mesh.transform, id);
    }

    void bake_mesh(const MeshShape& s, const dmat4& transform, std::uint32_t id) {
        dmat4 m = transform;
        for (int c = 0; c < 3; ++c) m[c] *= s.scale[c];
        if (s.data->triangles.empty()) {
            bake_points(s, m, id);
            return;
        }
        WorldInput::Triangles triangles;
        triangles.positions.reserve(s.data->positions.size());
        for (const vec3& p : s.data->positions)
            triangles.positions.push_back(to_float(transform_point(m, dvec3(p))));
        triangles.triangles = s.data->triangles;
        add_attributes(s, m, triangles, id);
        baked_.objects[id].lit_as_stored = s.facing == Facing::stored;
        const bool closed = need_closedness_ && is_closed(triangles.positions, triangles.triangles);
        add_triangles(std::move(triangles), id, closed);
    }

    void bake_points(const MeshShape& s, const dmat4& m, std::uint32_t id) {
        const double radius = s.point_radius ? *s.point_radius : default_point_radius(s.data->positions);
        const double stretched = radius * largest_stretch(m);
        std::uint32_t prim = 0;
        for (const vec3& p : s.data->positions)
            add_sphere(transform_point(m, dvec3(p)), stretched, dmat4(1.0), id, prim++);
        baked_.objects[id].solid = true;
        if (s.vertex_colors == VertexColors::automatic && !s.data->colors.empty())
            attach(MeshAttributes{{}, s.data, true}, id);
    }

    // Half the spacing that as many points would have if they lay evenly on the sides of their box.
    static double default_point_radius(const std::vector<vec3>& points) {
        Bounds bounds;
        for (const vec3& p : points) bounds.grow(p);
        if (points.empty()) return 1;
        const dvec3 d(bounds.extent());
        const double area = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
        const double spacing = std::sqrt(area / static_cast<double>(points.size()));
        if (spacing > 0) return spacing / 2;
        const double length = std::max({d.x, d.y, d.z});
        return length > 0 ? length / (2.0 * static_cast<double>(points.size())) : 1;
    }

    void add_attributes(const MeshShape& s, const dmat4& m, const WorldInput::Triangles& triangles,
                        std::uint32_t id) {
        MeshAttributes attributes;
        attributes.colored = s.vertex_colors == VertexColors::automatic && !s.data->colors.empty();
        if (s.normals == NormalsMode::smooth) {
            attributes.normals = smooth_normals(triangles.positions, triangles.triangles);
        } else if (s.normals == NormalsMode::automatic && !s.data->normals.empty()) {
            attributes.normals = transform_normals(s.data->normals, m);
        }
        if (attributes.normals.empty() && !attributes.colored) return;
        attributes.mesh = s.data;
        attach(std::move(attributes), id);
    }

    void attach(MeshAttributes attributes, std::uint32_t id) {
        baked_.objects[id].attributes = static_cast<std::int32_t>(baked_.attributes.size());
        baked_.attributes.push_back(std::move(attributes));
    }

    static std::vector<vec3> transform_normals(const std::vector<vec3>& normals, const dmat4& m) {
        const dmat3 normal_matrix = glm::transpose(glm::inverse(dmat3(m)));
        std::vector<vec3> turned;
        turned.reserve(normals.size());
        for (const vec3& n : normals) {
            const dvec3 t = normal_matrix * dvec3(n);
            const double squared = glm::dot(t, t);
            turned.push_back(squared > 0 ? to_float(t / std::sqrt(squared)) : vec3(0.0f));
        }
        return turned;
    }

    // Closed shapes are turned outward: a mirror in the transform, or a winding inside out, shows in the
    // volume.
    void add_triangles(WorldInput::Triangles triangles, std::uint32_t id, bool closed) {
        triangles.object = id;
        // Vertices that no face uses need not even be finite.
        for (const uvec3& t : triangles.triangles)
            for (int i = 0; i < 3; ++i) baked_.objects[id].bounds.grow(triangles.positions[t[i]]);
        triangles.flip = closed && signed_volume(triangles.positions, triangles.triangles) < 0;
        baked_.objects[id].solid = closed;
        baked_.input.meshes.push_back(std::move(triangles));
    }

    const SceneDescription& scene_;
    bool need_closedness_;
    Baked baked_;
};

} // namespace

Baked bake(const SceneDescription& description, bool need_closedness) {
    return Baker(description, need_closedness).run();
}

} // namespace glint
