// The public interface to instances.

#include "trace/tracing.h"
#include "trace/world/instance_tree.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace glint::tracing {

using trace::InstanceTree;
using trace::MeshInstance;
using trace::MeshTree;

struct Scene::Data {
    std::vector<Mesh> meshes; ///< each once
    InstanceTree tree;
};

namespace {

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

} // namespace

Scene::Scene() : data_(std::make_shared<Data>()) {}

Scene::Scene(std::span<const Instance> instances, const BuildOptions& options) {
    auto data = std::make_shared<Data>();
    std::vector<std::pair<const MeshTree*, std::size_t>> trees; // and the first instance of each
    std::vector<MeshInstance> placed;
    placed.reserve(instances.size());
    for (const Instance& instance : instances) {
        const MeshTree& tree = instance.mesh.data_->tree;
        trees.emplace_back(&tree, placed.size());
        placed.push_back(inner(tree, instance.world_from_local));
    }
    std::sort(trees.begin(), trees.end());
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (i == 0 || trees[i].first != trees[i - 1].first)
            data->meshes.push_back(instances[trees[i].second].mesh);
    parallel::TaskPool pool(options.threads);
    data->tree = InstanceTree(placed, pool);
    data_ = std::move(data);
}

void Scene::closest(std::span<const Ray> rays, std::span<InstanceHit> hits, RayHint hint,
                    const KernelChoice& choice) const {
    if (rays.size() != hits.size()) throw std::invalid_argument("rays and hits differ in number");
    data_->tree.closest(tracing::inner(rays), hits, hint, choice);
}

InstanceHit Scene::closest(const Ray& ray, const KernelChoice& choice) const {
    return data_->tree.closest(tracing::inner(ray), choice);
}

void Scene::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                     const KernelChoice& choice) const {
    if (rays.size() != blocked.size()) throw std::invalid_argument("rays and blocked differ in number");
    data_->tree.occluded(tracing::inner(rays), blocked, hint, choice);
}

bool Scene::occluded(const Ray& ray, const KernelChoice& choice) const {
    return data_->tree.occluded(tracing::inner(ray), choice);
}

Box Scene::bounds() const { return outer(data_->tree.bounds()); }

SceneStats Scene::stats() const {
    SceneStats stats{data_->tree.size(), data_->meshes.size(), data_->tree.bytes()};
    for (const Mesh& mesh : data_->meshes) stats.bytes += mesh.stats().bytes;
    return stats;
}

} // namespace glint::tracing
