// Building the trees of a World.

#include "geometry/mesh.h"
#include "trace/world/data.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace glint::trace {

namespace {

constexpr std::uint32_t quadrics_a_leaf = 2;

template <class T>
std::uint64_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

/// Concatenates the wide meshes, or the others, for the build.
WorldInput::Triangles joined(const std::vector<WorldInput::Triangles>& meshes, bool wide) {
    WorldInput::Triangles all;
    for (const auto& mesh : meshes) {
        if (mesh.wide != wide) continue;
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const uvec3& corners : mesh.triangles) all.triangles.push_back(corners + first);
    }
    return all;
}

void build_triangles(WorldData& world, bool wide, BuildQuality quality, parallel::TaskPool& pool) {
    std::vector<std::uint32_t>& first_numbers = wide ? world.wide_numbers : world.first_numbers;
    std::size_t triangles = 0;
    std::size_t positions = 0;
    for (const auto& mesh : world.meshes) {
        first_numbers.push_back(static_cast<std::uint32_t>(triangles));
        if (mesh.wide != wide) continue;
        triangles += mesh.triangles.size();
        positions += mesh.positions.size();
    }
    if (std::max(triangles, positions) >= invalid_index) throw std::length_error("too many triangles");
    const bool is_only = world.meshes.size() == 1 && world.meshes.front().wide == wide;
    const WorldInput::Triangles all = is_only ? WorldInput::Triangles{} : joined(world.meshes, wide);
    const WorldInput::Triangles& source = is_only ? world.meshes.front() : all;
    (wide ? world.wide_tree : world.mesh_tree) =
        build_mesh_tree(source.positions, source.triangles, pool, quality);
}

/// Float bounds of a quadric, rounded outward by one float.
BoxRef box_of(const WorldData& world, const Quadric& quadric, std::uint32_t id) {
    BoxRef box{vec3(0.0f), id, vec3(0.0f)};
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 gradient(0.0);
        gradient[axis] = 1.0;
        double shift = 0;
        if (quadric.affine >= 0) {
            const Affine& affine = world.affines[static_cast<std::size_t>(quadric.affine)];
            gradient = glm::transpose(affine.linear) * gradient;
            shift = affine.translation[axis];
        }
        const geometry::Interval range = geometry::extent(quadric.shape, gradient);
        constexpr float infinity = std::numeric_limits<float>::infinity();
        box.lo[axis] = std::nextafter(static_cast<float>(range.low + shift), -infinity);
        box.hi[axis] = std::nextafter(static_cast<float>(range.high + shift), infinity);
    }
    return box;
}

void build_quadrics(WorldData& world, const WorldInput& input, parallel::TaskPool& pool) {
    std::vector<Quadric> quadrics;
    for (const auto& q : input.quadrics) quadrics.push_back({q.affine, q.object, q.prim, 0, q.shape});
    // Group by kind, so that leaves mostly contain one kind.
    std::stable_sort(quadrics.begin(), quadrics.end(),
                     [](const Quadric& a, const Quadric& b) { return a.shape.kind < b.shape.kind; });
    std::vector<BoxRef> boxes;
    for (Quadric& quadric : quadrics) {
        const BoxRef box = box_of(world, quadric, static_cast<std::uint32_t>(boxes.size()));
        if (!is_finite(box.lo) || !is_finite(box.hi))
            throw std::invalid_argument("a quadric has no finite bounds");
        boxes.push_back(box);
        quadric.box = {box.lo, box.hi};
    }
    world.quadric_tree = build_tree(std::move(boxes), quadrics_a_leaf, pool);
    for (const std::uint32_t id : std::exchange(world.quadric_tree.order, {}))
        world.quadrics.push_back(quadrics[id]);
}

/// Numbers planes and quadrics in the order that decides ties.
void number_surfaces(WorldData& world) {
    std::vector<QuadricRef>& refs = world.surfaces;
    std::uint32_t index = 0;
    for (const PlanePrim& p : world.planes) refs.push_back({PrimKind::plane, p.object, 0, index++});
    index = 0;
    for (const Quadric& q : world.quadrics) refs.push_back({PrimKind::quadric, q.object, q.prim, index++});
    std::sort(refs.begin(), refs.end(), [](const QuadricRef& a, const QuadricRef& b) {
        return std::pair(a.object, a.prim) < std::pair(b.object, b.prim);
    });
    for (std::uint32_t number = 0; number < refs.size(); ++number) {
        const QuadricRef& ref = refs[number];
        world.first_surface.resize(std::max<std::size_t>(world.first_surface.size(), ref.object + 1), number);
        if (ref.kind == PrimKind::plane)
            world.planes[ref.index].surface = number;
        else
            world.quadrics[ref.index].surface = number;
    }
}

/// Statistics of shared meshes and their instances.
void count_shared(WorldData& world) {
    WorldStats& stats = world.stats;
    int depth = 0;
    for (const SharedMesh& mesh : world.shared_meshes) {
        stats.nodes += mesh.tree.nodes.size();
        stats.bytes +=
            bytes_of(*mesh.source.positions) + bytes_of(*mesh.source.triangles) + mesh.tree.bytes();
        depth = std::max(depth, mesh.tree.depth);
    }
    for (const InstanceData& instance : world.instances)
        stats.triangles += world.shared_meshes[instance.mesh].source.triangles->size();
    stats.nodes += world.instance_tree.nodes();
    stats.depth = world.instance_tree.depth() + depth;
    stats.bytes += bytes_of(world.instances) + world.instance_tree.bytes();
}

void count(WorldData& world, const WorldInput& input) {
    WorldStats& stats = world.stats;
    for (const auto& mesh : world.meshes) {
        stats.triangles += mesh.triangles.size();
        stats.bytes += bytes_of(mesh.positions) + bytes_of(mesh.triangles);
    }
    count_shared(world);
    for (const Quadric& q : world.quadrics) ++stats.quadrics[static_cast<std::size_t>(q.shape.kind)];
    stats.planes = input.planes.size();
    stats.quality = input.quality;
    for (const MeshTree* tree : {&world.mesh_tree, &world.wide_tree}) {
        stats.nodes += tree->nodes.size();
        stats.depth = std::max(stats.depth, tree->depth);
        stats.bytes += tree->bytes();
    }
    stats.nodes += world.quadric_tree.nodes.size();
    stats.depth = std::max(stats.depth, world.quadric_tree.depth);
    stats.bytes += bytes_of(world.quadric_tree.nodes) + bytes_of(world.quadrics) + bytes_of(world.planes) +
                   bytes_of(world.affines) + bytes_of(world.surfaces) + bytes_of(world.first_surface);
}

} // namespace

double margin_off_edges(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    constexpr std::size_t max_searched = 4096;
    constexpr double sine_of_1_degree = 0.0175;
    if (triangles.size() > max_searched) return edge_margin;
    const double sine = geometry::sine_at_sharpest_edge(positions, triangles);
    return std::max(edge_margin, 8.5 / std::max(sine, sine_of_1_degree));
}

World::World() : data_(std::make_shared<WorldData>()) {}

World::World(WorldInput input, parallel::TaskPool& pool) {
    auto world = std::make_shared<WorldData>();
    add_instances(*world, input, pool);
    world->meshes = std::move(input.meshes);
    std::sort(world->meshes.begin(), world->meshes.end(),
              [](auto& a, auto& b) { return a.object < b.object; });
    for (const dmat4& m : input.world_from_local) {
        const dmat3 linear(m);
        world->affines.push_back({linear, inverted(linear), dvec3(m[3])});
    }
    for (const auto& p : input.planes) {
        const double squared = glm::dot(p.normal, p.normal);
        world->planes.push_back({p.object, 0, {p.normal, p.offset}, squared, p.normal / std::sqrt(squared)});
    }
    std::sort(world->planes.begin(), world->planes.end(),
              [](auto& a, auto& b) { return a.object < b.object; });

    for (const auto& mesh : world->meshes) {
        check_corners(mesh.positions, mesh.triangles);
        world->off_edges.push_back(margin_off_edges(mesh.positions, mesh.triangles));
    }
    for (const bool wide : {false, true}) build_triangles(*world, wide, input.quality, pool);
    build_quadrics(*world, input, pool);
    number_surfaces(*world);
    count(*world, input);
    data_ = std::move(world);
}

} // namespace glint::trace
