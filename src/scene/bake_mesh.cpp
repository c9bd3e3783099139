// Meshes, point clouds and instances.

#include "scene/bake_mesh.h"

#include "geometry/mesh.h"
#include "geometry/point_cloud.h"
#include "math/trig.h"
#include "scene/validate.h"

#include <algorithm>
#include <cmath>

namespace glint::scene {

using trace::WorldInput;
namespace {

using Normals = std::shared_ptr<const std::vector<vec3>>;

double max_stretch(const dmat4& m) {
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    return std::sqrt(std::max({glm::dot(x, x), glm::dot(y, y), glm::dot(z, z)}));
}

// From the stored positions: the mesh's origin, its scale, then the transform.
dmat4 with_own_space(const dmat4& transform, const MeshShape& s) {
    dmat4 m = transform;
    for (int c = 0; c < 3; ++c) m[c] *= s.scale[c];
    m[3] = m * dvec4(s.data->origin, 1);
    return m;
}

std::vector<vec3> transformed_positions(const std::vector<vec3>& positions, const dmat4& m) {
    std::vector<vec3> moved;
    moved.reserve(positions.size());
    for (const vec3& p : positions) moved.push_back(vec3(transform_point(m, dvec3(p))));
    return moved;
}

std::vector<vec3> transformed_normals(const std::vector<vec3>& normals, const dmat3& normal_matrix) {
    std::vector<vec3> turned;
    turned.reserve(normals.size());
    for (const vec3& n : normals) turned.push_back(transformed_normal(normal_matrix, n));
    return turned;
}

dmat3 normal_matrix_of(const dmat4& m) { return glm::transpose(glm::inverse(dmat3(m))); }

// The winding of triangles in world space is then opposite to the one in the file.
bool mirrors(const dmat4& m) { return glm::determinant(dmat3(m)) < 0; }

Normals own(std::vector<vec3> normals) {
    if (normals.empty()) return nullptr;
    return std::make_shared<const std::vector<vec3>>(std::move(normals));
}

// Normals in the mesh's own space, or none; every object that shows the mesh transforms these. The mesh for
// indices and colours is the object's, or one whose vertices are split at creases.
MeshAttributes with_smooth_normals(const MeshShape& s) {
    const Mesh& mesh = *s.data;
    if (s.crease_angle >= 180) return {own(geometry::smooth_normals(mesh.positions, mesh.triangles)), s.data};
    geometry::CreasedMesh creased =
        geometry::split_at_creases(mesh.positions, mesh.triangles, cos_degrees(s.crease_angle));
    auto split = std::make_shared<Mesh>();
    split->triangles = std::move(creased.triangles);
    if (!mesh.colors.empty())
        for (const std::uint32_t vertex : creased.source) split->colors.push_back(mesh.colors[vertex]);
    return {own(std::move(creased.normals)), std::move(split)};
}

MeshAttributes attributes_of(const MeshShape& s) {
    if (s.normals == NormalsMode::smooth) return with_smooth_normals(s);
    if (s.normals != NormalsMode::automatic || s.data->normals.empty()) return {nullptr, s.data};
    return {Normals(s.data, &s.data->normals), s.data};
}

// Bounds of the vertices used by faces; others need not even be finite.
Bounds bounds_of_used(const std::vector<vec3>& positions, const std::vector<uvec3>& triangles) {
    Bounds bounds;
    for (const uvec3& t : triangles)
        for (int i = 0; i < 3; ++i) bounds.grow(positions[t[i]]);
    return bounds;
}

} // namespace

double point_radius(const MeshShape& s) {
    return s.point_radius ? *s.point_radius : geometry::default_point_radius(s.data->positions);
}

Bounds transform_box(const dmat4& m, const dvec3& lo, const dvec3& hi) {
    Bounds bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p((corner & 1) != 0 ? hi.x : lo.x, (corner & 2) != 0 ? hi.y : lo.y,
                      (corner & 4) != 0 ? hi.z : lo.z);
        bounds.grow(vec3(transform_point(m, p)));
    }
    return bounds;
}

void add_triangles(Baked& baked, WorldInput::Triangles triangles, std::uint32_t id, bool closed) {
    triangles.object = id;
    baked.objects[id].bounds = bounds_of_used(triangles.positions, triangles.triangles);
    triangles.flip = closed && geometry::signed_volume(triangles.positions, triangles.triangles) < 0;
    baked.objects[id].turned = triangles.flip;
    baked.objects[id].solid = closed;
    baked.input.meshes.push_back(std::move(triangles));
}

MeshBaker::MeshBaker(bool need_closedness, const std::function<void()>& between, Baked& baked)
    : need_closedness_(need_closedness), between_(between), baked_(baked) {}

void MeshBaker::bake(const Object& source, const dmat4& transform, std::uint32_t id, BakedAs how) {
    const auto& s = std::get<MeshShape>(source.shape);
    const dmat4 m = with_own_space(transform, s);
    if (s.data->triangles.empty()) return bake_points(s, m, id);
    baked_.objects[id].lit_as_stored = s.facing == Facing::stored;
    if (how == BakedAs::instance) return add_instance(shared(source), m, id);
    bake_once(s, m, id);
}

void MeshBaker::bake_points(const MeshShape& s, const dmat4& m, std::uint32_t id) {
    ObjectData& object = baked_.objects[id];
    const Bounds kept = geometry::cloud_without_outliers(s.data->positions);
    const double radius = point_radius(s);
    const double stretched = radius * max_stretch(m);
    std::uint32_t prim = 0;
    for (const vec3& p : s.data->positions) {
        const dvec3 center = transform_point(m, dvec3(p));
        baked_.input.quadrics.push_back({id, prim++, geometry::make_sphere(center, stretched), -1});
        const Bounds ball{vec3(center - stretched), vec3(center + stretched)};
        object.bounds.grow(ball);
        if (kept.contains(p)) object.core.grow(ball);
    }
    object.solid = true;
    if (s.vertex_colors == VertexColors::automatic && !s.data->colors.empty())
        object.attributes = add_attributes(s, {nullptr, s.data});
}

void MeshBaker::bake_once(const MeshShape& s, const dmat4& m, std::uint32_t id) {
    WorldInput::Triangles triangles;
    triangles.positions = transformed_positions(s.data->positions, m);
    triangles.triangles = s.data->triangles;
    between_();
    MeshAttributes attributes = attributes_of(s);
    if (attributes.normals)
        attributes.normals = own(transformed_normals(*attributes.normals, normal_matrix_of(m)));
    baked_.objects[id].attributes = add_attributes(s, std::move(attributes));
    between_();
    const bool closed = need_closedness_ && geometry::is_closed(triangles.positions, triangles.triangles);
    between_();
    add_triangles(baked_, std::move(triangles), id, closed);
    if (mirrors(m)) baked_.objects[id].turned = !baked_.objects[id].turned;
}

std::int32_t MeshBaker::add_attributes(const MeshShape& s, MeshAttributes attributes) {
    attributes.colored = s.vertex_colors == VertexColors::automatic && !s.data->colors.empty();
    if (attributes.normals == nullptr && !attributes.colored) return no_attributes;
    baked_.attributes.push_back(std::move(attributes));
    return static_cast<std::int32_t>(baked_.attributes.size()) - 1;
}

const MeshBaker::Shared& MeshBaker::shared(const Object& source) {
    const auto found = shared_.find(&source);
    if (found != shared_.end()) return found->second;
    const auto& s = std::get<MeshShape>(source.shape);
    const Mesh& mesh = *s.data;
    Shared shared;
    shared.mesh = static_cast<std::uint32_t>(baked_.input.shared_meshes.size());
    baked_.input.shared_meshes.push_back({{s.data, &mesh.positions}, {s.data, &mesh.triangles}});
    shared.bounds = bounds_of_used(mesh.positions, mesh.triangles);
    between_();
    shared.closed = need_closedness_ && geometry::is_closed(mesh.positions, mesh.triangles);
    between_();
    if (shared.closed) shared.volume = geometry::signed_volume(mesh.positions, mesh.triangles);
    shared.attributes = add_attributes(s, attributes_of(s));
    return shared_.emplace(&source, shared).first->second;
}

void MeshBaker::add_instance(const Shared& mesh, const dmat4& m, std::uint32_t id) {
    ObjectData& object = baked_.objects[id];
    if (!mesh.bounds.empty()) object.bounds = transform_box(m, dvec3(mesh.bounds.lo), dvec3(mesh.bounds.hi));
    object.solid = mesh.closed;
    object.attributes = mesh.attributes;
    if (mesh.attributes != no_attributes &&
        baked_.attributes[static_cast<std::size_t>(mesh.attributes)].normals != nullptr) {
        object.normal_matrix = static_cast<std::int32_t>(baked_.normal_matrices.size());
        baked_.normal_matrices.push_back(normal_matrix_of(m));
    }
    const bool mirrored = mirrors(m);
    const bool flip = mesh.closed && (mirrored ? mesh.volume > 0 : mesh.volume < 0);
    object.turned = flip != mirrored;
    baked_.input.instances.push_back({id, mesh.mesh, m, flip});
}

} // namespace glint::scene
