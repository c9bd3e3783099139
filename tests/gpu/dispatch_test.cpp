// A picture is the same whatever its dispatches hold: nothing is lost or doubled between two of them.

#include "gpu_kit.h"
#include "scene_kit.h"

#include "glint/image.h"
#include "glint/scene_files.h"

#include <gtest/gtest.h>

namespace glint::gpu {
namespace {

GpuLimits dispatches_of(std::uint32_t pixels, std::uint32_t rays) {
    GpuLimits limits;
    limits.pixels = pixels;
    limits.rays = rays;
    return limits;
}

const GpuLimits sizes[] = {dispatches_of(64, 1), dispatches_of(4096, 4), dispatches_of(1u << 19, 1000)};

/// The pictures of dispatches of all sizes against that of sizes that are learned.
void expect_same_bits(const SceneDescription& description, const std::string& name) {
    const Scene scene = build_scene(description);
    gpu()->prepare(scene);
    RenderOptions options;
    options.coverage = true;
    const Picture expected = gpu()->render(options);
    for (const GpuLimits& limits : sizes) {
        GpuRenderer renderer(-1, limits);
        renderer.prepare(scene);
        const std::string how = name + ", " + std::to_string(limits.rays) + " rays of " +
                                std::to_string(limits.pixels) + " pixels a dispatch";
        const Picture picture = renderer.render(options);
        EXPECT_EQ(picture_hash(picture.image), picture_hash(expected.image)) << how;
        EXPECT_EQ(picture.coverage, expected.coverage) << how;
        EXPECT_EQ(picture.stats.rays(), expected.stats.rays()) << how;
    }
}

TEST(GpuDispatches, SizesChangeNoBitOfTrees) {
    GLINT_NEEDS_GPU();
    expect_same_bits(exhibit("nested", 2), "nested");
    expect_same_bits(exhibit("mirrors", 3), "mirrors");
}

/// Hundreds of rays behind most pixels.
SceneDescription small_drink() {
    SceneDescription drink = load_scene(std::string(GLINT_SOURCE_DIR) + "/scenes/drink.toml").description;
    drink.render.width = 24;
    drink.render.height = 18;
    drink.render.spp = 4;
    return drink;
}

TEST(GpuDispatches, SizesChangeNoBitOfTheDrink) {
    GLINT_NEEDS_GPU();
    expect_same_bits(small_drink(), "drink");
}

TEST(GpuDispatches, WhatADriverCutShortIsToldAndNotShown) {
    GLINT_NEEDS_GPU();
    // Without the bound on steps llvmpipe ends the loops of long trees; other drivers end none.
    GpuLimits limits = dispatches_of(1u << 19, 1u << 20);
    limits.steps = 1u << 30;
    GpuRenderer renderer(-1, limits);
    if (renderer.device().name.rfind("llvmpipe", 0) != 0) GTEST_SKIP() << "not llvmpipe";
    SceneDescription drink = small_drink();
    drink.render.spp = 16;
    renderer.prepare(build_scene(drink));
    EXPECT_NE(refusal([&] { renderer.render(); }).find("ended the walk of a ray before its end"),
              std::string::npos);
}

} // namespace
} // namespace glint::gpu
