// What the GPU's renderer promises beside its pictures.

#include "gpu_kit.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::gpu {
namespace {

TEST(GpuRenderer, GivesTheSameBitsTwice) {
    GLINT_NEEDS_GPU();
    SceneDescription description = exhibit("fresnel_glass");
    description.render.spp = 5;
    const Scene scene = build_scene(description);
    gpu()->prepare(scene);
    const std::string first = picture_hash(gpu()->render().image);
    EXPECT_EQ(picture_hash(gpu()->render().image), first);
    gpu()->prepare(build_scene(exhibit("mirrors")));
    gpu()->prepare(scene);
    EXPECT_EQ(picture_hash(gpu()->render().image), first);
}

TEST(GpuRenderer, TermsAddUpToThePictureAndMatchTheCpu) {
    GLINT_NEEDS_GPU();
    for (const char* name : {"phong_clamped", "colored_glass", "sunlight"}) {
        SceneDescription description = exhibit(name);
        description.render.spp = 3;
        description.render.background = Vec3(0.25);
        const Scene scene = build_scene(description);
        RenderOptions options;
        options.terms = true;
        options.coverage = true;
        gpu()->prepare(scene);
        const Picture ours = gpu()->render(options);
        const Picture cpu = render(scene, options);
        EXPECT_EQ(ours.coverage, cpu.coverage) << name;
        Image sum(ours.image.width, ours.image.height);
        for (std::size_t t = 0; t < ours.terms.size(); ++t) {
            const Agreement found = agreement(ours.terms[t], cpu.terms[t]);
            EXPECT_LE(found.far, 0.001) << name << ", " << term_name(static_cast<Term>(t));
            EXPECT_LE(found.error, 1e-5) << name << ", " << term_name(static_cast<Term>(t));
            for (std::size_t i = 0; i < sum.pixels.size(); ++i)
                sum.pixels[i] = t == 0 ? ours.terms[t].pixels[i] : sum.pixels[i] + ours.terms[t].pixels[i];
        }
        EXPECT_EQ(sum.pixels, ours.image.pixels) << name;
    }
}

TEST(GpuRenderer, NumbersOfFirstHitsHaveNeitherTermsNorCoverage) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors"));
    RenderOptions options;
    options.show = Aov::normal;
    options.terms = true;
    options.coverage = true;
    gpu()->prepare(scene);
    for (const Picture& picture : {gpu()->render(options), render(scene, options)}) {
        EXPECT_EQ(picture.image.width, scene.render_settings().width);
        EXPECT_TRUE(picture.coverage.empty());
        for (const Image& term : picture.terms) EXPECT_TRUE(term.pixels.empty());
    }
}

TEST(GpuRenderer, CountsTheRaysOfTheCpu) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("nested"));
    gpu()->prepare(scene);
    const RenderStats ours = gpu()->render().stats;
    const RenderStats cpu = render(scene).stats;
    EXPECT_EQ(ours.primary_rays, cpu.primary_rays);
    // A ray that grazes a surface may meet it on one and miss it on the other.
    const auto near = [](std::uint64_t a, std::uint64_t b) {
        EXPECT_NEAR(static_cast<double>(a), static_cast<double>(b), 0.001 * static_cast<double>(b) + 2);
    };
    near(ours.reflected_rays, cpu.reflected_rays);
    near(ours.refracted_rays, cpu.refracted_rays);
    near(ours.shadow_rays, cpu.shadow_rays);
    near(ours.left_out_rays, cpu.left_out_rays);
}

TEST(GpuRenderer, LeavesOutTheRaysThatTheCpuLeavesOut) {
    GLINT_NEEDS_GPU();
    SceneDescription description = exhibit("nested");
    description.whitted.min_weight = 0.05;
    const Scene scene = build_scene(description);
    gpu()->prepare(scene);
    const Picture ours = gpu()->render();
    const Picture cpu = render(scene);
    EXPECT_GT(cpu.stats.left_out_rays, 0u);
    EXPECT_NEAR(static_cast<double>(ours.stats.left_out_rays), static_cast<double>(cpu.stats.left_out_rays),
                0.001 * static_cast<double>(cpu.stats.left_out_rays) + 2);
    const Agreement found = agreement(ours.image, cpu.image);
    EXPECT_LE(found.far, 0.001);
    EXPECT_LE(found.error, 1e-5);
}

TEST(GpuRenderer, ACropIsAPartOfTheWhole) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors"));
    gpu()->prepare(scene);
    const Image whole = gpu()->render().image;
    RenderOptions options;
    options.crop = Rect{7, 3, 21, 13};
    const Image part = gpu()->render(options).image;
    ASSERT_EQ(part.width, 21);
    ASSERT_EQ(part.height, 13);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(part.at(x, y)[c], whole.at(x + 7, y + 3)[c]) << x << ", " << y;
    options.crop = Rect{30, 30, 20, 20};
    EXPECT_THROW(gpu()->render(options), Error);
}

TEST(GpuRenderer, TreesOfRaysAreFollowedAcrossDispatches) {
    GLINT_NEEDS_GPU();
    // Two mirrors that face each other: deeper than one dispatch follows.
    SceneDescription scene = kit::empty_scene(Vec3(0.1, 0, 0.2), Vec3(1, 0.1, 0.05), 16, 50);
    scene.whitted.max_depth = 400;
    scene.render.background = Vec3(1, 2, 3);
    Material wall = kit::mirror(0.99);
    wall.emission = Vec3(0.01);
    kit::add(scene, PlaneShape{Vec3(1, 0, 0), 2}, wall);
    kit::add(scene, PlaneShape{Vec3(1, 0, 0), -2}, wall);
    expect_agreement(scene, "facing mirrors");
}

TEST(GpuRenderer, CancellingLeavesAnIncompletePicture) {
    GLINT_NEEDS_GPU();
    gpu()->prepare(build_scene(exhibit("mirrors")));
    CancelFlag cancel = true;
    RenderOptions options;
    options.cancel = &cancel;
    EXPECT_FALSE(gpu()->render(options).complete);
    cancel = false;
    EXPECT_TRUE(gpu()->render(options).complete);
}

TEST(GpuRenderer, ACoarsePictureFirstChangesNoFinishedPictureAndShowsInACancelledOne) {
    GLINT_NEEDS_GPU();
    gpu()->prepare(build_scene(exhibit("mirrors")));
    RenderOptions options;
    options.coverage = true;
    const Picture expected = gpu()->render(options);
    options.coarse_first = true;
    const Picture finished = gpu()->render(options);
    EXPECT_EQ(finished.image.pixels, expected.image.pixels);
    EXPECT_EQ(finished.coverage, expected.coverage);
    CancelFlag cancel{false};
    options.cancel = &cancel;
    options.progress = [&](const Progress& progress) { cancel = progress.fraction > 0.01; };
    const Picture coarse = gpu()->render(options);
    EXPECT_FALSE(coarse.complete);
    double difference = 0;
    for (std::size_t i = 0; i < coarse.coverage.size(); ++i)
        difference += std::abs(double(coarse.coverage[i]) - expected.coverage[i]);
    EXPECT_LT(difference / static_cast<double>(coarse.coverage.size()), 0.1);
}

TEST(GpuRenderer, TellsOfItsProgress) {
    GLINT_NEEDS_GPU();
    gpu()->prepare(build_scene(exhibit("mirrors")));
    Progress last;
    RenderOptions options;
    options.progress = [&](const Progress& progress) {
        EXPECT_GE(progress.tiles_done, last.tiles_done);
        EXPECT_GE(progress.rays, last.rays);
        last = progress;
    };
    const Picture picture = gpu()->render(options);
    EXPECT_EQ(last.tiles_done, last.tiles);
    EXPECT_EQ(last.rays, picture.stats.rays());
}

TEST(GpuRenderer, MoreThanEightSolidsAroundARayAreRefused) {
    GLINT_NEEDS_GPU();
    SceneDescription scene = kit::empty_scene(Vec3(0, -30, 0), Vec3(0, 1, 0), 16, 40);
    for (int i = 0; i < 9; ++i) kit::add(scene, SphereShape{Vec3(0), 10.0 - i}, kit::glass(1.1, 0.9));
    scene.whitted.max_depth = 12;
    gpu()->prepare(build_scene(scene));
    EXPECT_NE(refusal([] { gpu()->render(); }).find("more than eight transparent solids"), std::string::npos);

    scene.camera->eye = Vec3(0);
    EXPECT_NE(
        refusal([&] { gpu()->prepare(build_scene(scene)); }).find("the camera is in 9 transparent solids"),
        std::string::npos);
}

TEST(GpuRenderer, TakesMoreSamplesWhereNeighboursDifferAsTheCpuDoes) {
    GLINT_NEEDS_GPU();
    for (const int samples : {1, 2}) {
        SceneDescription description = exhibit("mirrors", samples);
        description.render.max_spp = 8;
        expect_agreement(description, "adaptive");
        const Scene scene = build_scene(description);
        gpu()->prepare(scene);
        RenderOptions options;
        options.terms = true;
        options.coverage = true;
        options.crop = Rect{7, 3, 21, 13};
        const Picture ours = gpu()->render(options);
        const Picture theirs = render(scene, options);
        expect_agreement(ours.image, theirs.image, "part of an adaptive picture");
        EXPECT_NEAR(double(ours.stats.primary_rays), double(theirs.stats.primary_rays), 8 * 2);
    }
}

TEST(GpuRenderer, ADeviceThatIsNotThereIsRefused) {
    GLINT_NEEDS_GPU();
    EXPECT_NE(refusal([] { GpuRenderer(1000); }).find("there is no device 1000"), std::string::npos);
}

TEST(GpuRenderer, DevicesAreDescribed) {
    GLINT_NEEDS_GPU();
    const std::vector<GpuDevice> devices = gpu_devices();
    const auto usable = std::find_if(devices.begin(), devices.end(), [](auto& d) { return d.fault.empty(); });
    ASSERT_NE(usable, devices.end());
    EXPECT_NE(usable->name, "");
    EXPECT_NE(usable->driver.find("OpenGL"), std::string::npos);
    EXPECT_GE(usable->max_buffer, 1u << 24);
    EXPECT_GE(usable->buffers, 8u);
}

} // namespace
} // namespace glint::gpu
