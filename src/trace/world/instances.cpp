// Instances of shared meshes.

#include "trace/world/data.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace glint::trace {

namespace {

/// More than eight roundings in double.
constexpr double double_error = 0x1p-48;

MeshInstance inner(const WorldData& world, const WorldInput::Instance& instance) {
    return {&world.shared_meshes[instance.mesh].tree, dmat3(instance.world_from_mesh),
            dvec3(instance.world_from_mesh[3])};
}

/// Transforms in double, rounded once.
WorldInput::Triangles baked(const WorldInput::SharedMesh& mesh, const WorldInput::Instance& instance) {
    WorldInput::Triangles triangles;
    triangles.object = instance.object;
    triangles.positions.reserve(mesh.positions->size());
    for (const vec3& p : *mesh.positions)
        triangles.positions.push_back(vec3(dvec3(instance.world_from_mesh * dvec4(dvec3(p), 1.0))));
    triangles.triangles = *mesh.triangles;
    triangles.flip = instance.flip;
    triangles.wide = instance.wide;
    return triangles;
}

/// Bound on the error of transforming a point by the computed inverse and back.
double slack_of(const MeshInstance& at, const dmat3& inverse) {
    const Bounds& box = at.mesh->bounds;
    if (box.empty()) return 0;
    const double reach = double(box.max_coordinate());
    const double residual = norm(inverse * at.linear - dmat3(1.0));
    const double stretch = norm(at.linear) * norm(inverse);
    return norm(at.linear) * residual * 2.0 * reach +
           double_error * stretch * (largest(at.translation) + norm(at.linear) * reach);
}

} // namespace

void add_instances(WorldData& world, WorldInput& input, parallel::TaskPool& pool) {
    for (WorldInput::SharedMesh& mesh : input.shared_meshes) {
        if (mesh.positions == nullptr || mesh.triangles == nullptr)
            throw std::invalid_argument("a shared mesh has no vertices or no triangles");
        check_corners(*mesh.positions, *mesh.triangles);
        MeshTree tree = build_mesh_tree(*mesh.positions, *mesh.triangles, pool, input.quality);
        const double off_edges = margin_off_edges(*mesh.positions, *mesh.triangles);
        world.shared_meshes.push_back({std::move(mesh), std::move(tree), off_edges});
    }
    std::sort(input.instances.begin(), input.instances.end(),
              [](auto& a, auto& b) { return a.object < b.object; });
    std::vector<MeshInstance> tree_input;
    for (const WorldInput::Instance& instance : input.instances) {
        if (instance.mesh >= world.shared_meshes.size())
            throw std::invalid_argument("an instance refers to a mesh that does not exist");
        const MeshInstance at = inner(world, instance);
        if (instance.wide || !InstanceTree::accepts(at)) {
            input.meshes.push_back(baked(world.shared_meshes[instance.mesh].source, instance));
            continue;
        }
        // Normals transform by the inverse transpose; the winding flips if the transform mirrors.
        const bool mirrored = glm::determinant(at.linear) < 0;
        world.instances.push_back({instance.object, instance.mesh, instance.flip != mirrored, at.linear, 0});
        tree_input.push_back(at);
    }
    world.instance_tree = InstanceTree(tree_input, pool);
    for (std::uint32_t i = 0; i < tree_input.size(); ++i)
        world.instances[i].slack = slack_of(tree_input[i], world.instance_tree.inverse(i));
}

} // namespace glint::trace
