// The public tracing interface: validates arguments and calls the trees.

#include "glint/trace.h"

#include "trace/tracing.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace glint::tracing {

using trace::build_mesh_tree;
using trace::MeshTree;

namespace {

static_assert(sizeof(vec3) == 12 && sizeof(uvec3) == 12);

template <class T>
std::size_t threes(std::span<const T> values, const char* message) {
    if (values.size() % 3 != 0) throw std::invalid_argument(message);
    return values.size() / 3;
}

/// Elements of three values as a contiguous array: the view itself if it is contiguous, otherwise a copy in
/// `copy`.
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

/// The caller's mesh as contiguous arrays, validated.
class Source {
  public:
    Source(const Vertices& vertices, const Triangles& triangles)
        : positions_(packed(vertices, positions_copy_)), corners_(packed(triangles, corners_copy_)) {
        if (corners_.size() >= none) throw std::length_error("a mesh has too many triangles");
        for (const uvec3& t : corners_)
            if (std::max({t.x, t.y, t.z}) >= positions_.size())
                throw std::invalid_argument("a triangle names a vertex that its mesh does not have");
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    std::span<const vec3> positions() const { return positions_; }
    std::span<const uvec3> triangles() const { return corners_; }

  private:
    std::vector<vec3> positions_copy_; ///< empty if the caller's array is used
    std::vector<uvec3> corners_copy_;
    std::span<const vec3> positions_;
    std::span<const uvec3> corners_;
};

Vertices viewed(std::span<const float> vertices) {
    return {vertices.data(), threes(vertices, "the vertices are not three floats each"), 12};
}

Triangles viewed(std::span<const std::uint32_t> triangles) {
    return {triangles.data(), threes(triangles, "the triangles are not three numbers each"), 12};
}

} // namespace

Mesh::Mesh() : data_(std::make_shared<Data>()) {}

Mesh::Mesh(std::span<const float> vertices, std::span<const std::uint32_t> triangles,
           const BuildOptions& options)
    : Mesh(viewed(vertices), viewed(triangles), options) {}

Mesh::Mesh(const Vertices& vertices, const Triangles& triangles, const BuildOptions& options) {
    const Source source(vertices, triangles);
    parallel::TaskPool pool(options.threads);
    data_ = std::make_shared<Data>(
        Data{build_mesh_tree(source.positions(), source.triangles(), pool, options.quality)});
}

void Mesh::refit(std::span<const float> vertices, std::span<const std::uint32_t> triangles, int threads) {
    refit(viewed(vertices), viewed(triangles), threads);
}

void Mesh::refit(const Vertices& vertices, const Triangles& triangles, int threads) {
    const Source source(vertices, triangles);
    if (source.triangles().size() != data_->tree.triangles)
        throw std::invalid_argument("the number of triangles is not that of the mesh");
    // Modify the data in place only if no other Mesh shares it.
    const bool is_sole_owner = data_.use_count() == 1;
    const auto data =
        is_sole_owner ? std::const_pointer_cast<Data>(data_) : std::make_shared<Data>(Data{data_->tree});
    parallel::TaskPool pool(threads);
    trace::refit(data->tree, source.positions(), source.triangles(), pool);
    data_ = data;
}

void Mesh::closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint,
                   const KernelChoice& choice) const {
    if (rays.size() != hits.size()) throw std::invalid_argument("rays and hits differ in number");
    trace::closest(data_->tree, inner(rays), hits, hint, choice);
}

Hit Mesh::closest(const Ray& ray, const KernelChoice& choice) const {
    return trace::closest(data_->tree, inner(ray), choice);
}

void Mesh::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                    const KernelChoice& choice) const {
    if (rays.size() != blocked.size()) throw std::invalid_argument("rays and blocked differ in number");
    trace::occluded(data_->tree, inner(rays), blocked, hint, choice);
}

bool Mesh::occluded(const Ray& ray, const KernelChoice& choice) const {
    return trace::occluded(data_->tree, inner(ray), choice);
}

Box Mesh::bounds() const { return outer(data_->tree.bounds); }

MeshStats Mesh::stats() const {
    const MeshTree& tree = data_->tree;
    return {tree.triangles, tree.left_out, tree.nodes.size(), tree.bytes(), tree.depth, tree.quality};
}

} // namespace glint::tracing
