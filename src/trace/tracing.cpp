// The public tracing interface: validates arguments and calls the trees.

#include "glint/trace.h"

#include "trace/mesh/tree.h"
#include "trace/world/instance_tree.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace glint::tracing {

using trace::build_mesh_tree;
using trace::InstanceTree;
using trace::MeshInstance;
using trace::MeshTree;

struct Mesh::Data {
    trace::MeshTree tree;
};

struct Scene::Data {
    std::vector<Mesh> meshes; ///< each once
    InstanceTree tree;
};

namespace {

// Rays and hits are passed to the kernels without conversion. This is safe because nothing here accesses them
// through both types: the kernels are compiled separately.
static_assert(sizeof(Ray) == sizeof(glint::Ray) && std::is_standard_layout_v<glint::Ray>);
static_assert(offsetof(Ray, tmin) == offsetof(glint::Ray, tmin));
static_assert(offsetof(Ray, direction) == offsetof(glint::Ray, direction));
static_assert(offsetof(Ray, tmax) == offsetof(glint::Ray, tmax));

std::span<const glint::Ray> inner(std::span<const Ray> rays) {
    return {reinterpret_cast<const glint::Ray*>(rays.data()), rays.size()};
}

glint::Ray inner(const Ray& ray) {
    return {vec3(ray.origin[0], ray.origin[1], ray.origin[2]), ray.tmin,
            vec3(ray.direction[0], ray.direction[1], ray.direction[2]), ray.tmax};
}

Box outer(const Bounds& b) { return {{b.lo.x, b.lo.y, b.lo.z}, {b.hi.x, b.hi.y, b.hi.z}}; }

MeshInstance inner(const MeshTree& mesh, const Transform& transform) {
    MeshInstance instance;
    instance.mesh = &mesh;
    for (int row = 0; row < 3; ++row) {
        const std::array<float, 4>& from = transform.m[static_cast<std::size_t>(row)];
        for (int column = 0; column < 3; ++column)
            instance.linear[column][row] = from[static_cast<std::size_t>(column)];
        instance.translation[row] = from[3];
    }
    return instance;
}

static_assert(sizeof(vec3) == 12 && sizeof(uvec3) == 12);

template <class T>
StridedView<T> viewed(std::span<const T> values, const char* message) {
    if (values.size() % 3 != 0) throw std::invalid_argument(message);
    return {values.data(), values.size() / 3, 12};
}

/// The groups of a view as a contiguous array: the view itself if it is contiguous, otherwise `copy`.
template <class V, class T>
std::span<const V> packed(const StridedView<T>& view, std::vector<V>& copy) {
    if (view.count == 0) return {};
    if (view.stride % 4 != 0 || view.stride < sizeof(V))
        throw std::invalid_argument("a stride is no multiple of 4 bytes or below 12");
    if (view.stride == sizeof(V)) return {reinterpret_cast<const V*>(view.first), view.count};
    copy.reserve(view.count);
    for (std::size_t i = 0; i < view.count; ++i) {
        const T* at = view.first + i * (view.stride / 4);
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
        trace::check_corners(positions_, corners_);
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
    return viewed(vertices, "the vertices are not three floats each");
}

Triangles viewed(std::span<const std::uint32_t> triangles) {
    return viewed(triangles, "the triangles are not three numbers each");
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

Scene::Scene() : data_(std::make_shared<Data>()) {}

Scene::Scene(std::span<const Instance> instances, const BuildOptions& options) {
    auto data = std::make_shared<Data>();
    std::vector<std::pair<const MeshTree*, std::size_t>> trees; // and the first instance of each
    std::vector<MeshInstance> tree_input;
    tree_input.reserve(instances.size());
    for (const Instance& instance : instances) {
        const MeshTree& tree = instance.mesh.data_->tree;
        trees.emplace_back(&tree, tree_input.size());
        tree_input.push_back(inner(tree, instance.world_from_local));
    }
    std::sort(trees.begin(), trees.end());
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (i == 0 || trees[i].first != trees[i - 1].first)
            data->meshes.push_back(instances[trees[i].second].mesh);
    parallel::TaskPool pool(options.threads);
    data->tree = InstanceTree(tree_input, pool);
    data_ = std::move(data);
}

void Scene::closest(std::span<const Ray> rays, std::span<InstanceHit> hits, RayHint hint,
                    const KernelChoice& choice) const {
    if (rays.size() != hits.size()) throw std::invalid_argument("rays and hits differ in number");
    data_->tree.closest(inner(rays), hits, hint, choice);
}

InstanceHit Scene::closest(const Ray& ray, const KernelChoice& choice) const {
    return data_->tree.closest(inner(ray), choice);
}

void Scene::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                     const KernelChoice& choice) const {
    if (rays.size() != blocked.size()) throw std::invalid_argument("rays and blocked differ in number");
    data_->tree.occluded(inner(rays), blocked, hint, choice);
}

bool Scene::occluded(const Ray& ray, const KernelChoice& choice) const {
    return data_->tree.occluded(inner(ray), choice);
}

Box Scene::bounds() const { return outer(data_->tree.bounds()); }

SceneStats Scene::stats() const {
    SceneStats stats{data_->tree.size(), data_->meshes.size(), data_->tree.bytes()};
    for (const Mesh& mesh : data_->meshes) stats.bytes += mesh.stats().bytes;
    return stats;
}

} // namespace glint::tracing
