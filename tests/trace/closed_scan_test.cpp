// A closed scan of a real head: no ray crosses it an odd number of times.

#include "worlds.h"

#include "geometry/mesh.h"
#include "glint/mesh_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace glint {

using trace::Hit;
using trace::World;
using trace::WorldInput;
namespace {

TEST(ClosedScan, IsCrossedEvenly) {
    const std::string path = std::string(GLINT_SOURCE_DIR) + "/../shared/models/igea.ply";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "there is no " << path;
    const auto mesh = load_mesh(path).mesh;
    ASSERT_TRUE(geometry::is_closed(mesh->positions, mesh->triangles));
    WorldInput input;
    input.meshes.push_back({0, mesh->positions, mesh->triangles, false});
    const World world = world_of(std::move(input), 0);
    const Bounds box = world.bounds();
    const dvec3 middle = (dvec3(box.lo) + dvec3(box.hi)) * 0.5;
    const double size = glm::length(dvec3(box.extent()));

    Numbers random(1);
    std::vector<Hit> hits;
    int crossed = 0;
    for (int i = 0; i < 200'000; ++i) {
        const vec3 from(middle + random.direction() * size * 2.0);
        // At vertices, or anywhere.
        const auto vertex = random.below(static_cast<std::uint32_t>(mesh->positions.size()));
        const vec3 goal = i % 2 == 0 ? mesh->positions[vertex] : vec3(middle + random.point() * size * 0.3);
        world.all_hits(ray_from(from, goal - from), hits);
        const bool on_edge =
            std::any_of(hits.begin(), hits.end(), [](const Hit& hit) { return hit.on_edge; });
        crossed += hits.empty() ? 0 : 1;
        ASSERT_TRUE(on_edge || hits.size() % 2 == 0) << "ray " << i << ": " << hits.size() << " crossings";
    }
    EXPECT_GT(crossed, 100'000);
}

} // namespace
} // namespace glint
