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
    return triangles;
}

/// Bound on the error of transforming a point by the computed inverse and back.
double slack_of(const MeshInstance& at, const dmat3& inverse) {
    const Bounds& box = at.mesh->bounds;
    if (box.empty()) return 0;
    const double reach = std::max(largest(dvec3(box.lo)), largest(dvec3(box.hi)));
    const double residual = norm(inverse * at.linear - dmat3(1.0));
    const double stretch = norm(at.linear) * norm(inverse);
    const dvec3 t = glm::abs(at.translation);
    return norm(at.linear) * residual * 2.0 * reach +
           double_error * stretch * (std::max({t.x, t.y, t.z}) + norm(at.linear) * reach);
}

} // namespace

void check_corners(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    for (const uvec3& corners : triangles)
        if (std::max({corners.x, corners.y, corners.z}) >= positions.size())
            throw std::invalid_argument("a triangle names a vertex that its mesh does not have");
}

void add_instances(WorldData& world, WorldInput& input, TaskPool& pool) {
    for (WorldInput::SharedMesh& mesh : input.shared_meshes) {
        if (mesh.positions == nullptr || mesh.triangles == nullptr)
            throw std::invalid_argument("a shared mesh has no vertices or no triangles");
        check_corners(*mesh.positions, *mesh.triangles);
        MeshTree tree = build_mesh_tree(*mesh.positions, *mesh.triangles, pool, input.quality);
        world.shared_meshes.push_back({std::move(mesh), std::move(tree)});
    }
    std::sort(input.instances.begin(), input.instances.end(),
              [](auto& a, auto& b) { return a.object < b.object; });
    std::vector<MeshInstance> placed;
    for (const WorldInput::Instance& instance : input.instances) {
        if (instance.mesh >= world.shared_meshes.size())
            throw std::invalid_argument("an instance names a mesh that there is not");
        const MeshInstance at = inner(world, instance);
        if (!InstanceTree::accepts(at)) {
            input.meshes.push_back(baked(world.shared_meshes[instance.mesh].source, instance));
            continue;
        }
        // Normals transform by the inverse transpose; the winding flips if the transform mirrors.
        const bool mirrored = glm::determinant(at.linear) < 0;
        world.instances.push_back({instance.object, instance.mesh, instance.flip != mirrored, at.linear, 0});
        placed.push_back(at);
    }
    world.instance_tree = InstanceTree(placed, pool);
    for (std::uint32_t i = 0; i < placed.size(); ++i)
        world.instances[i].slack = slack_of(placed[i], world.instance_tree.inverse(i));
}

} // namespace glint::trace
