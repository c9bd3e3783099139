// Trees of boxes: complete, tight, bounded in depth, and independent of the number of threads.

#include "bvh/traverse.h"
#include "bvh/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

namespace glint::bvh {
namespace {

constexpr std::uint32_t max_leaf = 4;

struct Rng {
    std::mt19937_64 engine{7};
    float unit() { return static_cast<float>(engine() >> 40) * 0x1p-24f; }
    vec3 point() {
        const float x = unit();
        const float y = unit();
        const float z = unit();
        return {x, y, z};
    }
};

std::vector<BoxRef> random_boxes(std::uint32_t count, float size) {
    Rng rng;
    std::vector<BoxRef> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 lo = rng.point();
        boxes.push_back({lo, i, lo + rng.point() * size});
    }
    return boxes;
}

/// Every element is in one leaf, every box holds what is below it, no leaf is too long or too deep.
void expect_sound(const Tree& tree, const std::vector<BoxRef>& boxes) {
    std::vector<std::uint32_t> sorted = tree.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint32_t> all(boxes.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(sorted, all) << "elements are lost or doubled";

    std::size_t elements = 0;
    std::size_t nodes = 0;
    int deepest = 0;
    const std::function<Bounds(TreeRef, int)> check = [&](TreeRef ref, int depth) {
        deepest = std::max(deepest, depth);
        Bounds box;
        if (ref.count > 0) {
            EXPECT_LE(ref.count, max_leaf);
            elements += ref.count;
            for (std::uint32_t i = ref.first; i < ref.first + ref.count; ++i) {
                box.grow(boxes[tree.order[i]].lo);
                box.grow(boxes[tree.order[i]].hi);
            }
            return box;
        }
        ++nodes;
        const TreeNode& node = tree.nodes[ref.first];
        for (int child = 0; child < 2; ++child) {
            const Bounds inside = check(node.child[child], depth + 1);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(node.lo[axis][child], inside.lo[axis]);
                EXPECT_EQ(node.hi[axis][child], inside.hi[axis]);
            }
            box.grow(inside);
        }
        return box;
    };
    const Bounds whole = check(tree.root, 0);
    EXPECT_EQ(elements, boxes.size());
    EXPECT_EQ(nodes, tree.nodes.size());
    EXPECT_EQ(deepest, tree.depth);
    EXPECT_LE(tree.depth, max_tree_depth);
    EXPECT_EQ(whole.lo, tree.bounds.lo);
    EXPECT_EQ(whole.hi, tree.bounds.hi);
}

Tree build(const std::vector<BoxRef>& boxes, int threads = 1) {
    parallel::TaskPool pool(threads);
    return build_tree(boxes, max_leaf, pool);
}

TEST(Tree, IsEmptyWithoutBoxes) {
    const Tree tree = build({});
    EXPECT_TRUE(tree.empty());
    EXPECT_TRUE(tree.bounds.empty());
}

TEST(Tree, HoldsEveryBoxOnce) {
    for (const std::uint32_t count : {1u, 2u, 3u, 5u, 17u, 1000u, 50'000u}) {
        SCOPED_TRACE(count);
        const auto boxes = random_boxes(count, 0.01f);
        expect_sound(build(boxes), boxes);
    }
}

TEST(Tree, HalvesWhatCannotBeToldApart) {
    auto boxes = random_boxes(100'000, 0.0f);
    for (BoxRef& box : boxes) box.lo = box.hi = vec3(0.5f);
    const Tree tree = build(boxes);
    expect_sound(tree, boxes);
    EXPECT_LE(tree.depth, 17) << "100000 equal boxes, four a leaf";
}

TEST(Tree, IsNotDeepUnderGeometricSpacing) {
    // Each box is half as far from the origin as the last, so every SAH split separates one box only.
    std::vector<BoxRef> boxes;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const float x = std::ldexp(1.0f, 100 - static_cast<int>(i % 240));
        boxes.push_back({vec3(x), i, vec3(x) * 1.0001f});
    }
    expect_sound(build(boxes), boxes);
}

TEST(Tree, TakesCoordinatesOfAnySize) {
    for (const float scale : {1e-30f, 1e-12f, 1e12f, 1e18f, 3e38f}) {
        SCOPED_TRACE(scale);
        auto boxes = random_boxes(2000, 0.001f);
        for (BoxRef& box : boxes) {
            box.lo = (box.lo - 0.5f) * scale;
            box.hi = (box.hi - 0.5f) * scale;
        }
        const Tree tree = build(boxes);
        expect_sound(tree, boxes);
        EXPECT_LE(tree.depth, 24) << "the cuts are useless";
    }
}

TEST(Tree, IsTheSameOnAnyNumberOfThreads) {
    const auto boxes = random_boxes(60'000, 0.01f);
    const Tree one = build(boxes, 1);
    for (const int threads : {2, 7}) {
        const Tree many = build(boxes, threads);
        EXPECT_EQ(many.order, one.order);
        ASSERT_EQ(many.nodes.size(), one.nodes.size());
        EXPECT_EQ(std::memcmp(many.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(TreeNode)), 0);
    }
}

TEST(Traverse, GivesEveryLeafWhoseBoxTheRayMeetsNearestFirst) {
    // A row of unit cubes along x.
    std::vector<BoxRef> boxes;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const float x = static_cast<float>(2 * i);
        boxes.push_back({{x, 0, 0}, i, {x + 1, 1, 1}});
    }
    parallel::TaskPool pool(1);
    const Tree tree = build_tree(boxes, 1, pool);
    Ray ray;
    ray.origin = {200.0f, 0.5f, 0.5f};
    ray.direction = {-1.0f, 0.0f, 0.0f};
    std::vector<std::uint32_t> met;
    const float limit = 150.0f;
    traverse(tree, BoxRay(ray, tree.bounds), 100.0f, limit, [&](std::uint32_t first, std::uint32_t) {
        met.push_back(tree.order[first]);
        return false;
    });
    // t from 100 to 150 is x from 100 down to 50.
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 50; i >= 25; --i) expected.push_back(i);
    EXPECT_EQ(met, expected);
}

TEST(Traverse, EndsWhenTheLeafSaysSo) {
    const auto boxes = random_boxes(1000, 0.5f);
    const Tree tree = build(boxes);
    Ray ray;
    ray.origin = vec3(-1.0f);
    ray.direction = vec3(1.0f);
    int leaves = 0;
    const float limit = 100.0f;
    traverse(tree, BoxRay(ray, tree.bounds), 0.0f, limit,
             [&](std::uint32_t, std::uint32_t) { return ++leaves == 3; });
    EXPECT_EQ(leaves, 3);
}

#ifndef NDEBUG
TEST(TreeDeathTest, BoxesThatAreInvertedOrNotFiniteFailAnAssertion) {
    const auto build_one = [](const vec3& lo, const vec3& hi) { build({{lo, 0, hi}}); };
    build_one(vec3(0.0f), vec3(0.0f));
    EXPECT_DEATH(build_one(vec3(1.0f), vec3(0.0f)), "is_valid");
    EXPECT_DEATH(build_one(vec3(0.0f), vec3(std::numeric_limits<float>::infinity())), "is_valid");
    EXPECT_DEATH(build_one(vec3(std::nanf("")), vec3(0.0f)), "is_valid");
}
#endif

TEST(BoxRay, HasNeitherInfinityNorNaN) {
    const vec3 one(1.0f);
    for (const float tiny : {0.0f, -0.0f, 1e-45f, -1e-38f, 1e-20f})
        for (const float size : {1e-38f, 1e-12f, 1.0f, 1e30f}) {
            Ray ray;
            ray.direction = {tiny, -size, tiny};
            const BoxRay box_ray(ray, Bounds{-one, one});
            for (const float inverse : box_ray.inverse) {
                EXPECT_TRUE(std::isfinite(inverse)) << tiny << " beside " << size;
                EXPECT_NE(inverse, 0.0f) << tiny << " beside " << size;
            }
            EXPECT_LT(box_ray.inverse[1], 0.0f);
            EXPECT_EQ(std::signbit(box_ray.inverse[0]), std::signbit(tiny));
        }
}

} // namespace
} // namespace glint::bvh
