// The public tracing interface: checks what callers give and hands it to the trees.

#include "glint/trace.h"

#include "trace/tracing.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace glint::tracing {

namespace {

static_assert(sizeof(vec3) == 12 && sizeof(uvec3) == 12);

template <class T>
std::size_t threes(std::span<const T> values, const char* message) {
    if (values.size() % 3 != 0) throw std::invalid_argument(message);
    return values.size() / 3;
}

/// Elements of three values side by side: where they lie, if they do, else copied to `copy`.
template <class V, class View>
std::span<const V> packed(const View& view, std::vector<V>& copy) {
    if (view.count == 0) return {};
    if (view.stride % 4 != 0 || view.stride < sizeof(V))
        throw std::invalid_argument("a stride is no multiple of 4 bytes or below 12");
    if (view.stride == sizeof(V)) return {reinterpret_cast<const V*>(view.first), view.count};
    copy.reserve(view.count);
    for (std::size_t i = 0; i < view.count; ++i) {
        const auto* at = view.first + i * (view.stride / 4);
        copy.emplace_back(at[0], at[1], at[2]);
    }
    return copy;
}

bool is_finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Checks that all corners are there, and counts the triangles that nothing can hit.
std::size_t count_skipped(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    std::size_t skipped = 0;
    for (const uvec3& t : triangles) {
        if (t.x >= positions.size() || t.y >= positions.size() || t.z >= positions.size())
            throw std::invalid_argument("a triangle names a vertex that its mesh does not have");
        if (!is_finite(positions[t.x]) || !is_finite(positions[t.y]) || !is_finite(positions[t.z])) ++skipped;
    }
    return skipped;
}

} // namespace

Mesh::Mesh() : data_(std::make_shared<Data>()) {}

Mesh::Mesh(std::span<const float> vertices, std::span<const std::uint32_t> triangles,
           const BuildOptions& options)
    : Mesh(Vertices(vertices.data(), threes(vertices, "the vertices are not three floats each"), 12),
           Triangles(triangles.data(), threes(triangles, "the triangles are not three numbers each"), 12),
           options) {}

Mesh::Mesh(const Vertices& vertices, const Triangles& triangles, const BuildOptions& options) {
    std::vector<vec3> positions_copy;
    std::vector<uvec3> triangles_copy;
    const std::span<const vec3> positions = packed(vertices, positions_copy);
    const std::span<const uvec3> corners = packed(triangles, triangles_copy);
    if (corners.size() >= none) throw std::length_error("a mesh has too many triangles");

    auto data = std::make_shared<Data>();
    data->skipped = count_skipped(positions, corners);
    TaskPool pool(options.threads);
    data->tree = build_mesh_tree(positions, corners, pool);
    data_ = std::move(data);
}

void Mesh::closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) const {
    if (rays.size() != hits.size()) throw std::invalid_argument("rays and hits differ in number");
    const std::span records(reinterpret_cast<TriangleRecord*>(hits.data()), hits.size());
    glint::closest(data_->tree, inner(rays), records, inner(hint));
}

Hit Mesh::closest(const Ray& ray) const {
    const TriangleRecord record = glint::closest(data_->tree, inner(ray));
    return {record.t, record.u, record.v, record.triangle};
}

void Mesh::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint) const {
    if (rays.size() != blocked.size()) throw std::invalid_argument("rays and blocked differ in number");
    glint::occluded(data_->tree, inner(rays), blocked, inner(hint));
}

bool Mesh::occluded(const Ray& ray) const { return glint::occluded(data_->tree, inner(ray)); }

Box Mesh::bounds() const { return outer(data_->tree.bounds); }

MeshStats Mesh::stats() const {
    const MeshTree& tree = data_->tree;
    return {tree.triangles, data_->skipped, tree.nodes.size(), tree.bytes(), tree.depth};
}

} // namespace glint::tracing
