// Every kernel gives the bits of the scalar one on every SIMD target.

#include "trace/mesh/scalar.h"

#include "math/random.shared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <string>

namespace glint {

using trace::build_mesh_tree;
using trace::closest_scalar;
using trace::MeshTree;
using trace::TriangleRecord;
namespace {

float draw(uint key, uint index) { return unit_float(hash_with(key, index)); }

vec3 draw_point(uint key, uint index) {
    return vec3(draw(key, 3 * index), draw(key, 3 * index + 1), draw(key, 3 * index + 2));
}

struct Triangles {
    std::vector<vec3> positions;
    std::vector<uvec3> corners;

    MeshTree tree() const {
        parallel::TaskPool pool(2);
        return build_mesh_tree(positions, corners, pool);
    }
};

/// Small triangles scattered in a cube, some of them twice, some without area.
Triangles soup(uint seed, std::size_t count, float scale) {
    Triangles s;
    for (uint i = 0; i < count; ++i) {
        const vec3 at = draw_point(seed, 4 * i);
        for (uint k = 1; k < 4; ++k)
            s.positions.push_back((at + (draw_point(seed, 4 * i + k) - 0.5f) * 0.2f) * scale);
        const uint first = 3 * (i % 16 == 15 ? i - 1 : i);
        s.corners.push_back(uvec3(first, first + 1, i % 32 == 7 ? first : first + 2));
    }
    return s;
}

/// A closed sphere of `rings` rings of 2 · rings quads.
Triangles ball(uint rings) {
    Triangles s;
    const uint around = 2 * rings;
    for (uint i = 0; i <= rings; ++i)
        for (uint k = 0; k < around; ++k) {
            const double polar = std::numbers::pi * i / rings;
            const double turn = 2 * std::numbers::pi * k / around;
            const double ring = i == 0 || i == rings ? 0.0 : std::sin(polar);
            s.positions.push_back(vec3(dvec3(ring * std::cos(turn), std::cos(polar), ring * std::sin(turn))));
        }
    for (uint i = 0; i < rings; ++i)
        for (uint k = 0; k < around; ++k) {
            const uint a = i * around + k;
            const uint b = i * around + (k + 1) % around;
            s.corners.push_back(uvec3(a, b, a + around));
            s.corners.push_back(uvec3(b, b + around, a + around));
        }
    return s;
}

/// Parallel, axis-parallel and scattered rays, short and long, with negative tmin, with NaN or infinity, and
/// without direction.
std::vector<Ray> scattered_rays(uint seed, std::size_t count, float scale) {
    std::vector<Ray> rays;
    for (uint i = 0; i < count; ++i) {
        Ray ray;
        ray.origin = (draw_point(seed, 2 * i) * 3.0f - 1.0f) * scale;
        ray.direction = draw_point(seed, 2 * i + 1) - 0.5f;
        if (i % 3 == 0) ray.direction = vec3(0.1f, 0.2f, 1.0f);
        if (i % 16 == 1) ray.direction = vec3(0.0f, i % 32 == 1 ? -0.0f : 0.0f, i % 64 == 1 ? -1e-12f : 2.0f);
        if (i % 8 == 2) ray.tmax = 0.4f * scale;
        if (i % 8 == 3) ray.tmin = 0.5f * scale;
        if (i % 8 == 4) ray.direction *= 1e-30f;
        if (i % 128 == 5) ray.direction.x = std::numeric_limits<float>::quiet_NaN();
        if (i % 128 == 6) ray.origin.y = std::numeric_limits<float>::infinity();
        if (i % 128 == 7) ray.direction = vec3(0.0f);
        if (i % 128 == 9) ray.tmax = std::numeric_limits<float>::quiet_NaN();
        if (i % 128 == 10) ray.tmin = std::numeric_limits<float>::quiet_NaN();
        if (i % 128 == 11) ray.direction *= std::numeric_limits<float>::max();
        if (i % 128 == 12) ray.tmax = -1.0f;
        if (i % 16 == 13) ray.tmin = -std::numeric_limits<float>::infinity();
        if (i % 16 == 14) ray.tmin = -0.7f * scale;
        rays.push_back(ray);
    }
    return rays;
}

/// Rays from one point to vertices and to points of edges.
std::vector<Ray> aimed_rays(const Triangles& mesh, vec3 from, uint seed) {
    std::vector<Ray> rays;
    for (uint i = 0; i < mesh.corners.size(); ++i) {
        const vec3 a = mesh.positions[mesh.corners[i].x];
        const vec3 b = mesh.positions[mesh.corners[i].y];
        Ray ray;
        ray.origin = from;
        ray.direction = a - from;
        rays.push_back(ray);
        ray.direction = a + (b - a) * draw(seed, i) - from;
        rays.push_back(ray);
    }
    return rays;
}

/// A narrow bundle of rays of one octant and axis, some of them invalid, often the last.
std::vector<Ray> bundle_with_odd_rays(uint seed, std::size_t count) {
    std::vector<Ray> rays;
    for (uint i = 0; i < count; ++i) {
        Ray ray;
        ray.origin = vec3(0.1f, 0.1f, -1.0f) + 0.5f * draw_point(seed, 2 * i);
        ray.direction = vec3(0.05f, 0.05f, 1.0f) + 0.1f * draw_point(seed, 2 * i + 1);
        const bool is_last = i + 1 == count;
        if (draw(seed + 1, i) < (is_last ? 0.5f : 0.125f)) {
            const auto axis = static_cast<int>(3.0f * draw(seed + 2, i));
            if (draw(seed + 3, i) < 0.5f)
                ray.origin[axis] = std::numeric_limits<float>::quiet_NaN();
            else
                ray.direction[axis] = std::numeric_limits<float>::infinity();
        }
        rays.push_back(ray);
    }
    return rays;
}

struct NamedChoice {
    const char* name;
    KernelChoice choice;
};

std::vector<NamedChoice> choices() {
    std::vector<NamedChoice> all;
    const std::pair<const char*, SimdTarget> targets[] = {{"plain", SimdTarget::plain},
                                                          {"sse4", SimdTarget::sse4},
                                                          {"avx2", SimdTarget::avx2},
                                                          {"avx512", SimdTarget::avx512},
                                                          {"best", SimdTarget::best}};
    for (const auto& [name, target] : targets)
        for (const Kernel kernel : {Kernel::automatic, Kernel::single, Kernel::packets, Kernel::streams})
            if (is_available(target)) all.push_back({name, {kernel, target}});
    all.push_back({"scalar", {Kernel::scalar, SimdTarget::best}});
    return all;
}

void expect_agreement(const MeshTree& tree, const std::vector<Ray>& rays) {
    std::vector<TriangleRecord> wanted;
    for (const Ray& ray : rays) wanted.push_back(closest_scalar(tree, ray));
    std::vector<TriangleRecord> records(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    for (const NamedChoice& named : choices())
        for (const RayHint hint : {RayHint::coherent, RayHint::incoherent}) {
            closest(tree, rays, records, hint, named.choice);
            occluded(tree, rays, blocked, hint, named.choice);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (std::memcmp(&records[i], &wanted[i], sizeof wanted[i]) != 0) ++wrong;
                if (blocked[i] != (wanted[i].triangle != invalid_index ? 1 : 0)) ++wrong;
            }
            EXPECT_EQ(wrong, 0u) << named.name << ", kernel " << int(named.choice.kernel) << ", hint "
                                 << int(hint);
        }
}

class KernelsAtScale : public testing::TestWithParam<float> {};

TEST_P(KernelsAtScale, GiveTheBitsOfThePlainWalk) {
    const std::vector<Ray> rays = scattered_rays(7, 5000, GetParam());
    expect_agreement(soup(7, 3000, GetParam()).tree(), rays);
}

INSTANTIATE_TEST_SUITE_P(Scales, KernelsAtScale, testing::Values(1e-12f, 1.0f, 1e12f));

TEST(Kernels, AgreeOnBundlesWithAFewOddRays) {
    const MeshTree tree = soup(5, 3000, 1.0f).tree();
    for (uint count = 1; count <= 130; ++count)
        expect_agreement(tree, bundle_with_odd_rays(10 * count, count));
}

TEST(Kernels, AgreeOnRaysThroughVerticesAndEdges) {
    const Triangles mesh = ball(12);
    expect_agreement(mesh.tree(), aimed_rays(mesh, vec3(0.25f, -0.125f, 0.0625f), 3));
    expect_agreement(mesh.tree(), aimed_rays(mesh, vec3(2.0f, 3.0f, -4.0f), 4));
}

TEST(Kernels, LetNoRayOutOfAClosedBall) {
    const Triangles mesh = ball(24);
    const MeshTree tree = mesh.tree();
    for (uint seed = 0; seed < 4; ++seed) {
        const std::vector<Ray> rays = aimed_rays(mesh, (draw_point(9, seed) - 0.5f) * 0.9f, seed);
        std::vector<TriangleRecord> records(rays.size());
        std::vector<std::uint8_t> blocked(rays.size());
        for (const NamedChoice& named : choices()) {
            closest(tree, rays, records, RayHint::incoherent, named.choice);
            occluded(tree, rays, blocked, RayHint::incoherent, named.choice);
            std::size_t leaks = 0;
            for (std::size_t i = 0; i < rays.size(); ++i)
                if (records[i].triangle == invalid_index || blocked[i] == 0) ++leaks;
            EXPECT_EQ(leaks, 0u) << named.name << ", kernel " << int(named.choice.kernel);
        }
    }
}

TEST(Kernels, FollowTheWholeLineWhereRaysBeginBeforeTheirOrigins) {
    const Triangles mesh = ball(24);
    const MeshTree tree = mesh.tree();
    for (const float tmin : {-std::numeric_limits<float>::infinity(), -1.5f, -0.25f}) {
        // From inside and outside the sphere, each also with one ray in 64 that starts at its origin.
        for (const vec3& from : {vec3(0.25f, -0.125f, 0.0625f), vec3(2.0f, 3.0f, -4.0f)}) {
            std::vector<Ray> rays = aimed_rays(mesh, from, 5);
            for (std::size_t i = 0; i < rays.size(); ++i)
                if (i % 64 != 7) rays[i].tmin = tmin;
            expect_agreement(tree, rays);
            for (Ray& ray : rays) ray.origin += ray.direction * 1.25f;
            expect_agreement(tree, rays);
        }
    }
}

class KernelsOnBatches : public testing::TestWithParam<std::size_t> {};

TEST_P(KernelsOnBatches, TakeAnyNumberOfRays) {
    const MeshTree tree = soup(2, 500, 1.0f).tree();
    expect_agreement(tree, scattered_rays(5, GetParam(), 1.0f));
}

INSTANTIATE_TEST_SUITE_P(Sizes, KernelsOnBatches, testing::Values(0, 1, 7, 63, 64, 65, 4096, 4097));

TEST(Kernels, HitNothingInAnEmptyTree) { expect_agreement(Triangles{}.tree(), scattered_rays(1, 200, 1.0f)); }

TEST(Kernels, FindOneTriangle) {
    Triangles one;
    one.positions = {vec3(-1, -1, 0.5f), vec3(1, -1, 0.5f), vec3(0, 1, 0.5f)};
    one.corners = {uvec3(0, 1, 2)};
    expect_agreement(one.tree(), scattered_rays(1, 1000, 1.0f));
}

TEST(Kernels, HitTheFirstOfEqualTriangles) {
    Triangles many;
    many.positions = {vec3(-1, -1, 0.5f), vec3(1, -1, 0.5f), vec3(0, 1, 0.5f)};
    many.corners.assign(1000, uvec3(0, 1, 2));
    expect_agreement(many.tree(), scattered_rays(1, 1000, 1.0f));
}

TEST(Kernels, RefuseTargetsThatTheMachineLacks) {
    const MeshTree tree = soup(2, 10, 1.0f).tree();
    for (const SimdTarget target : {SimdTarget::sse4, SimdTarget::avx2, SimdTarget::avx512}) {
        const KernelChoice choice{Kernel::single, target};
        if (is_available(target)) {
            EXPECT_NO_THROW(closest(tree, Ray{}, choice));
        } else {
            EXPECT_THROW(closest(tree, Ray{}, choice), std::invalid_argument);
        }
    }
}

} // namespace
} // namespace glint
