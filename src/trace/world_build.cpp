// From plain input to trees.

#include "trace/world_data.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace glint {

namespace {

constexpr std::uint32_t triangles_a_leaf = 4;
constexpr std::uint32_t quadrics_a_leaf = 2;

template <class T>
std::uint64_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

bool is_finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The inverse by cofactors: homogeneous in every column, so that it scales by 2^k to the bit.
dmat3 inverted(const dmat3& m) {
    const dvec3 r0 = glm::cross(m[1], m[2]);
    const dvec3 r1 = glm::cross(m[2], m[0]);
    const dvec3 r2 = glm::cross(m[0], m[1]);
    const double determinant = glm::dot(m[0], r0);
    return glm::transpose(dmat3(r0 / determinant, r1 / determinant, r2 / determinant));
}

/// Triangles of all meshes under one running number.
class TriangleNumbers {
  public:
    explicit TriangleNumbers(const std::vector<WorldInput::Triangles>& meshes) : meshes_(meshes) {
        for (const auto& mesh : meshes) {
            firsts_.push_back(total_);
            total_ += mesh.triangles.size();
        }
        if (total_ > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("too many triangles");
    }
    std::uint32_t first(std::size_t mesh) const { return static_cast<std::uint32_t>(firsts_[mesh]); }
    std::size_t total() const { return total_; }

    PackedTriangle packed(std::uint32_t number) const {
        const auto above = std::upper_bound(firsts_.begin(), firsts_.end(), std::size_t(number));
        const std::size_t at = static_cast<std::size_t>(above - firsts_.begin()) - 1;
        const WorldInput::Triangles& mesh = meshes_[at];
        const std::uint32_t prim = number - first(at);
        PackedTriangle result{{}, mesh.object, prim};
        for (int i = 0; i < 3; ++i) {
            const vec3& p = mesh.positions[mesh.triangles[prim][i]];
            result.vertices[static_cast<std::size_t>(i)] = {p.x, p.y, p.z};
        }
        return result;
    }

  private:
    const std::vector<WorldInput::Triangles>& meshes_;
    std::vector<std::size_t> firsts_;
    std::size_t total_ = 0;
};

void add_boxes(const WorldInput::Triangles& mesh, std::uint32_t first, std::vector<BoxRef>& boxes) {
    for (std::size_t prim = 0; prim < mesh.triangles.size(); ++prim) {
        const uvec3 corners = mesh.triangles[prim];
        if (std::max({corners.x, corners.y, corners.z}) >= mesh.positions.size())
            throw std::invalid_argument("a triangle names a vertex that its mesh does not have");
        const vec3& a = mesh.positions[corners.x];
        const vec3& b = mesh.positions[corners.y];
        const vec3& c = mesh.positions[corners.z];
        // No ray hits a triangle with an infinite or NaN corner.
        if (!is_finite(a) || !is_finite(b) || !is_finite(c)) continue;
        boxes.push_back({glm::min(glm::min(a, b), c), first + static_cast<std::uint32_t>(prim),
                         glm::max(glm::max(a, b), c)});
    }
}

void build_triangles(WorldData& world, TaskPool& pool) {
    const TriangleNumbers numbers(world.meshes);
    std::vector<BoxRef> boxes;
    boxes.reserve(numbers.total());
    for (std::size_t i = 0; i < world.meshes.size(); ++i) add_boxes(world.meshes[i], numbers.first(i), boxes);
    world.triangle_tree = build_tree(std::move(boxes), triangles_a_leaf, pool);

    std::vector<std::uint32_t> order = std::move(world.triangle_tree.order);
    world.triangles.resize(order.size());
    constexpr std::size_t chunk = 65536;
    pool.run((order.size() + chunk - 1) / chunk, [&](std::size_t task, int) {
        const std::size_t end = std::min(order.size(), (task + 1) * chunk);
        for (std::size_t i = task * chunk; i < end; ++i) world.triangles[i] = numbers.packed(order[i]);
    });
}

/// The float box around a quadric: each side the exact one, one float further out.
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
        const Interval reach = quadric.kind == PrimKind::cylinder ? extent(quadric.shape, gradient)
                                                                  : extent(quadric.sphere(), gradient);
        constexpr float infinity = std::numeric_limits<float>::infinity();
        box.lo[axis] = std::nextafter(static_cast<float>(reach.enter + shift), -infinity);
        box.hi[axis] = std::nextafter(static_cast<float>(reach.leave + shift), infinity);
    }
    return box;
}

std::vector<Quadric> collect_quadrics(const WorldInput& input) {
    std::vector<Quadric> quadrics;
    for (const auto& s : input.spheres)
        quadrics.push_back(
            {PrimKind::sphere, s.affine, s.object, s.prim, {s.center, dvec3(0.0), 0.0, s.radius}});
    for (const auto& c : input.cylinders)
        quadrics.push_back({PrimKind::cylinder, c.affine, c.object, 0, {c.base, c.axis, c.height, c.radius}});
    return quadrics;
}

void build_quadrics(WorldData& world, const WorldInput& input, TaskPool& pool) {
    const std::vector<Quadric> quadrics = collect_quadrics(input);
    std::vector<BoxRef> boxes;
    for (const Quadric& quadric : quadrics) {
        const BoxRef box = box_of(world, quadric, static_cast<std::uint32_t>(boxes.size()));
        if (!is_finite(box.lo) || !is_finite(box.hi))
            throw std::invalid_argument("a quadric has no finite bounds");
        boxes.push_back(box);
    }
    world.quadric_tree = build_tree(std::move(boxes), quadrics_a_leaf, pool);
    for (const std::uint32_t id : std::exchange(world.quadric_tree.order, {})) {
        world.quadrics_by_number.push_back(static_cast<std::uint32_t>(world.quadrics.size()));
        world.quadrics.push_back(quadrics[id]);
    }
    std::sort(world.quadrics_by_number.begin(), world.quadrics_by_number.end(), [&](auto a, auto b) {
        const Quadric& x = world.quadrics[a];
        const Quadric& y = world.quadrics[b];
        return std::pair(x.object, x.prim) < std::pair(y.object, y.prim);
    });
}

void count(WorldData& world, const WorldInput& input) {
    WorldStats& stats = world.stats;
    for (const auto& mesh : world.meshes) {
        stats.triangles += mesh.triangles.size();
        stats.bytes += bytes_of(mesh.positions) + bytes_of(mesh.triangles);
    }
    stats.spheres = input.spheres.size();
    stats.cylinders = input.cylinders.size();
    stats.planes = input.planes.size();
    stats.nodes = world.triangle_tree.nodes.size() + world.quadric_tree.nodes.size();
    stats.depth = std::max(world.triangle_tree.depth, world.quadric_tree.depth);
    stats.bytes += bytes_of(world.triangle_tree.nodes) + bytes_of(world.quadric_tree.nodes) +
                   bytes_of(world.triangles) + bytes_of(world.quadrics) + bytes_of(world.planes) +
                   bytes_of(world.affines) + bytes_of(world.quadrics_by_number);
}

} // namespace

World::World() : data_(std::make_unique<Data>()) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

World::World(WorldInput input, TaskPool& pool) {
    auto world = std::make_unique<Data>();
    world->meshes = std::move(input.meshes);
    std::sort(world->meshes.begin(), world->meshes.end(),
              [](auto& a, auto& b) { return a.object < b.object; });
    for (const dmat4& m : input.world_from_local) {
        const dmat3 linear(m);
        world->affines.push_back({linear, inverted(linear), dvec3(m[3])});
    }
    for (const auto& p : input.planes) world->planes.push_back({p.object, {p.normal, p.offset}});
    std::sort(world->planes.begin(), world->planes.end(),
              [](auto& a, auto& b) { return a.object < b.object; });

    build_triangles(*world, pool);
    build_quadrics(*world, input, pool);
    count(*world, input);
    data_ = std::move(world);
}

} // namespace glint
