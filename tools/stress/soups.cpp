// Making worlds of difficult primitives.

#include "soups.h"

#include <array>
#include <iterator>
#include <memory>
#include <utility>

namespace glint::stress {

using trace::WorldInput;

namespace {

using Corners = std::array<dvec3, 3>;

/// A point of the grid of quarters in [-1, 1]^3: makes shared coordinates and exact ties.
dvec3 on_grid(Random& random) {
    const int x = random.between(-4, 4);
    const int y = random.between(-4, 4);
    const int z = random.between(-4, 4);
    return dvec3(x, y, z) * 0.25;
}

/// A triangle with two long sides and a very short one.
Corners needle(Random& random) {
    const dvec3 a = random.in_cube(1.0);
    const dvec3 b = random.in_cube(1.0);
    const double width = random.power_of_ten(-9, -2);
    return {a, b, b + random.in_cube(width)};
}

/// A triangle with nearly collinear corners.
Corners sliver(Random& random) {
    const dvec3 a = random.in_cube(1.0);
    const dvec3 b = random.in_cube(1.0);
    const double height = random.power_of_ten(-9, -2);
    const double along = random.unit();
    const dvec3 between = a + (b - a) * along + random.in_cube(height);
    return random.one_in(2) ? Corners{a, b, between} : Corners{a, between, b};
}

Corners square_to_axis(Random& random) {
    Corners t{on_grid(random), on_grid(random), on_grid(random)};
    const int axis = random.axis();
    t[1][axis] = t[2][axis] = t[0][axis];
    return t;
}

Corners without_area(Random& random) {
    const dvec3 a = on_grid(random);
    const dvec3 step = on_grid(random) * 0.25;
    const int k = random.between(0, 4);
    return {a, a + step * double(k), a + step * 4.0};
}

Corners triangle(Soup kind, Random& random) {
    switch (kind) {
    case Soup::needles:
        return needle(random);
    case Soup::slivers:
        return sliver(random);
    case Soup::axis_aligned:
        return square_to_axis(random);
    case Soup::coplanar: {
        Corners t{on_grid(random), on_grid(random), on_grid(random)};
        t[0].z = t[1].z = t[2].z = 0.25;
        return t;
    }
    case Soup::zero_area:
        return random.one_in(3) ? Corners{on_grid(random), on_grid(random), on_grid(random)}
                                : without_area(random);
    default: {
        const dvec3 a = random.in_cube(1.0);
        const double size = random.one_in(2) ? 1.0 : 0.1;
        const dvec3 ab = random.in_cube(size);
        const dvec3 ac = random.in_cube(size);
        return {a, a + ab, a + ac};
    }
    }
}

void add_triangles(Soup kind, const ScaledOffset& to_world, Random& random, WorldInput& world) {
    std::array<WorldInput::Triangles, 3> meshes;
    const std::uint32_t count = 1 + random.below(kind == Soup::mixed ? 24 : 64);
    Corners last{};
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool again = kind == Soup::duplicates && i > 0 && !random.one_in(3);
        if (!again) last = triangle(kind, random);
        WorldInput::Triangles& mesh = meshes[random.below(3)];
        const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
        const std::uint32_t turn = random.below(3);
        for (std::uint32_t k = 0; k < 3; ++k) mesh.positions.push_back(to_world(last[(k + turn) % 3]));
        if (random.one_in(2))
            mesh.triangles.emplace_back(first, first + 1, first + 2);
        else
            mesh.triangles.emplace_back(first, first + 2, first + 1);
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
        meshes[k].object = 7 - 2 * k;
        meshes[k].wide = kind == Soup::mixed && random.one_in(3);
        world.meshes.push_back(std::move(meshes[k]));
    }
}

/// A local space near the placed cube, stretched and sheared.
std::int32_t add_affine(const ScaledOffset& to_world, Random& random, WorldInput& world) {
    dmat4 m(1.0);
    for (int column = 0; column < 3; ++column) {
        dvec3 side = random.in_cube(0.4);
        side[column] += 1.0;
        m[column] = dvec4(side * to_world.scale, 0.0);
    }
    m[3] = dvec4(dvec3(to_world(random.in_cube(0.5))), 1.0);
    world.world_from_local.push_back(m);
    return static_cast<std::int32_t>(world.world_from_local.size()) - 1;
}

QuadricShape any_standing(const dvec3& p, const dvec3& axis, double height, double radius, Random& random) {
    switch (random.below(3)) {
    case 0:
        return geometry::make_cylinder(p, axis, height, radius);
    case 1:
        return geometry::make_cone(p, axis, height, radius);
    default:
        return geometry::make_disk(p, axis, radius);
    }
}

void add_quadrics(const ScaledOffset& to_world, Random& random, WorldInput& world) {
    for (std::uint32_t i = 0; i < 12; ++i) {
        const bool local = random.one_in(3);
        const std::int32_t affine = local ? add_affine(to_world, random, world) : -1;
        const dvec3 at = random.one_in(2) ? on_grid(random) : random.in_cube(1.0);
        const dvec3 p = local ? at * 0.5 : dvec3(to_world(at));
        const double radius = 0.25 * random.between(1, 3) * (local ? 1.0 : to_world.scale);
        if (random.one_in(2)) {
            world.quadrics.push_back({20 + i / 4, i, geometry::make_sphere(p, radius), affine});
            continue;
        }
        const dvec3 axis = random.one_in(2) ? random.along_axis() : random.direction();
        world.quadrics.push_back(
            {40 + i, 0, any_standing(p, axis, radius * random.between(1, 4), radius, random), affine});
    }
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        const dvec3 normal = random.one_in(2) ? dvec3(0, 0, 1) : random.in_cube(3.0);
        world.planes.push_back({30 + i, normal, glm::dot(normal, dvec3(to_world(on_grid(random))))});
    }
}

} // namespace

/// A transform with random rotation, shear, reflection and scale; sometimes the identity, sometimes nearly
/// singular.
dmat4 any_transform(const ScaledOffset& to_world, Random& random) {
    dmat3 linear(1.0);
    const double size = random.one_in(4) ? 1.0 : random.uniform(0.05, 1.0);
    for (int column = 0; column < 3; ++column) {
        if (random.one_in(2)) linear[column] = random.in_cube(0.5);
        linear[column][column] += random.one_in(2) ? 1.5 : -1.5;
        if (random.one_in(8)) linear[column] *= random.power_of_ten(-4, 0);
    }
    if (random.one_in(3)) linear = dmat3(1.0);
    const dvec3 at = random.one_in(2) ? on_grid(random) : random.in_cube(1.0);
    dmat4 m(linear * (size * to_world.scale));
    m[3] = dvec4((at + to_world.offset) * to_world.scale, 1.0);
    return m;
}

WorldInput::SharedMesh shared_soup(Random& random) {
    static constexpr Soup kinds[] = {Soup::random,       Soup::needles,  Soup::slivers,
                                     Soup::axis_aligned, Soup::coplanar, Soup::zero_area};
    const Soup kind = kinds[random.below(std::size(kinds))];
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    for (int i = random.between(1, 16); i > 0; --i) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (const dvec3& p : triangle(kind, random)) positions.push_back(vec3(p));
        triangles.emplace_back(first, first + 1, first + 2);
        // Two more triangles that share its edges.
        if (random.one_in(2)) continue;
        positions.push_back(vec3(random.in_cube(1.0)));
        triangles.emplace_back(first + 1, first, first + 3);
        triangles.emplace_back(first, first + 2, first + 3);
    }
    return {std::make_shared<const std::vector<vec3>>(std::move(positions)),
            std::make_shared<const std::vector<uvec3>>(std::move(triangles))};
}

void add_instances(const ScaledOffset& to_world, Random& random, WorldInput& world) {
    for (std::uint32_t i = 0; i < 3; ++i) world.shared_meshes.push_back(shared_soup(random));
    for (std::uint32_t i = 1 + random.below(12); i > 0; --i) {
        const bool again = !world.instances.empty() && random.one_in(6);
        WorldInput::Instance instance;
        if (again) instance = world.instances.back();
        if (!again) instance.world_from_mesh = any_transform(to_world, random);
        if (!again) instance.mesh = random.below(3);
        // Object numbers interleaved with those of the other objects.
        instance.object = 2 * i;
        world.instances.push_back(instance);
    }
}

WorldInput make_soup(Soup kind, const ScaledOffset& to_world, Random& random) {
    WorldInput world;
    if (kind == Soup::instanced) {
        add_instances(to_world, random, world);
        if (random.one_in(2)) add_triangles(Soup::mixed, to_world, random, world);
        if (random.one_in(4)) add_quadrics(to_world, random, world);
        return world;
    }
    if (kind != Soup::quadrics) add_triangles(kind, to_world, random, world);
    if (kind == Soup::quadrics || kind == Soup::mixed) add_quadrics(to_world, random, world);
    return world;
}

} // namespace glint::stress
