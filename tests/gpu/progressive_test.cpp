// Pictures that get better on the GPU.

#include "gpu/context.h"
#include "gpu_kit.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

namespace glint::gpu {
namespace {

/// One for all tests, as there is one renderer.
GpuProgressive& progressive() {
    static GpuProgressive one;
    return one;
}

std::string whole(const Scene& scene) {
    gpu()->prepare(scene);
    return picture_hash(gpu()->render().image);
}

std::string finished() {
    while (progressive().advance(0)) {
    }
    return picture_hash(progressive().image());
}

ProgressiveOptions from(int coarsest, const CancelFlag* cancel = nullptr) {
    ProgressiveOptions options;
    options.coarsest = coarsest;
    options.cancel = cancel;
    return options;
}

TEST(GpuProgressive, ComesToTheBitsOfTheWholePicture) {
    GLINT_NEEDS_GPU();
    struct Case {
        const char* name;
        int width, height, samples, coarsest;
    };
    for (const Case& c : {Case{"mirrors", 61, 47, 1, 8}, Case{"fresnel_glass", 64, 48, 5, 4},
                          Case{"nested", 3, 5, 2, 64}, Case{"sunlight", 120, 7, 17, 1}}) {
        const Scene scene = build_scene(exhibit(c.name, c.width, c.height, c.samples));
        progressive().start(scene, from(c.coarsest));
        EXPECT_EQ(finished(), whole(scene)) << c.name;
        const Refinement& reached = progressive().reached();
        EXPECT_TRUE(reached.finished);
        EXPECT_EQ(reached.step, 1);
        EXPECT_EQ(reached.samples, c.samples == 1 ? 0 : c.samples);
        EXPECT_EQ(reached.fraction, 1);
        EXPECT_FALSE(progressive().advance(1));
    }
}

TEST(GpuProgressive, TakesMoreSamplesWhereNeighboursDifferAsTheWholePictureDoes) {
    GLINT_NEEDS_GPU();
    for (const int samples : {1, 2, 3}) {
        SceneDescription description = exhibit("mirrors", 61, 47, samples);
        description.render.max_spp = 9;
        const Scene scene = build_scene(description);
        description.render.max_spp = 0;
        const Scene fixed = build_scene(description);
        // Another picture before and after leaves no trace.
        for (int i = 0; i < 2; ++i) {
            progressive().start(scene, from(4));
            EXPECT_EQ(finished(), whole(scene)) << samples;
            EXPECT_TRUE(progressive().reached().finished);
            progressive().start(fixed, from(4));
            EXPECT_EQ(finished(), whole(fixed)) << samples;
        }
    }
}

TEST(GpuProgressive, EveryViewComesToTheBitsOfTheWholePicture) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors", 61, 47, 3));
    gpu()->prepare(scene);
    for (const Aov aov : {Aov::normal, Aov::depth, Aov::shadows, Aov::cost, Aov::diffuse, Aov::reflection,
                          Aov::clamp, Aov::final}) {
        RenderOptions options;
        options.show = aov;
        ProgressiveOptions how = from(4);
        how.show = aov;
        progressive().start(scene, how);
        EXPECT_EQ(finished(), picture_hash(gpu()->render(options).image)) << aov_name(aov);
    }
}

TEST(GpuProgressive, CoarseNumbersStandInBlocks) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors", 61, 47, 3));
    for (const Aov aov : {Aov::normal, Aov::depth, Aov::ambient}) {
        ProgressiveOptions how = from(8);
        how.show = aov;
        Progressive cpu(1);
        cpu.start(scene, how);
        cpu.advance(0);
        progressive().start(scene, how);
        progressive().advance(0);
        ASSERT_EQ(progressive().reached().step, cpu.reached().step);
        expect_agreement(progressive().image(), cpu.image(), std::string("coarse ") + aov_name(aov));
    }
}

void expect_what_the_cpu_shows(const Scene& scene) {
    Progressive cpu(1);
    cpu.start(scene, from(8));
    progressive().start(scene, from(8));
    int compared = 0;
    Refinement last;
    for (bool more = true; more;) {
        more = progressive().advance(0);
        const Refinement& reached = progressive().reached();
        // Within a pass some pixels are ahead.
        if (reached.step == last.step && reached.samples == last.samples) continue;
        last = reached;
        while (cpu.reached().step != reached.step || cpu.reached().samples != reached.samples) {
            ASSERT_FALSE(cpu.reached().finished);
            cpu.advance(0);
        }
        expect_agreement(progressive().image(), cpu.image(),
                         "step " + std::to_string(reached.step) + ", samples " +
                             std::to_string(reached.samples));
        ++compared;
    }
    EXPECT_EQ(compared, 7) << "steps 8, 4, 2, 1 and samples 1, 2, 4";
}

TEST(GpuProgressive, ShowsWhatTheCpuShowsOnTheWay) {
    GLINT_NEEDS_GPU();
    SceneDescription description = exhibit("mirrors", 61, 47, 4);
    expect_what_the_cpu_shows(build_scene(description));
    description.render.spp = 1;
    description.render.max_spp = 4;
    expect_what_the_cpu_shows(build_scene(description));
}

TEST(GpuProgressive, TheFirstPassIsThereAfterOneCall) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors", 200, 150, 4));
    progressive().start(scene, from(4));
    EXPECT_EQ(progressive().picture(), nullptr);
    EXPECT_TRUE(progressive().advance(0));
    EXPECT_GE(progressive().reached().step, 1);
    EXPECT_LE(progressive().reached().step, 4);
    EXPECT_GT(progressive().reached().rays, 200u * 150 / 16);
    EXPECT_GT(progressive().reached().fraction, 0);
    EXPECT_LT(progressive().reached().fraction, 1);
}

TEST(GpuProgressive, AnotherCameraOrSizeLaysNothingAnew) {
    GLINT_NEEDS_GPU();
    const SceneDescription description = exhibit("fresnel_glass", 40, 30, 2);
    const Scene scene = build_scene(description);
    progressive().start(scene);
    progressive().advance(0);
    const int upload_count = progressive().upload_count();
    CameraDescription camera = scene.camera();
    for (int i = 0; i < 3; ++i) {
        camera.eye.x += 0.3;
        const Scene moved = with_view(scene, camera, 40 + 7 * i, 30);
        progressive().start(moved);
        EXPECT_EQ(finished(), whole(build_scene(moved.description()))) << i;
    }
    EXPECT_EQ(progressive().upload_count(), upload_count);

    SceneDescription painted = description;
    painted.materials.front().color = Vec3(0.9, 0.1, 0.4);
    painted.materials.front().reflectivity = 0.25;
    const Scene edited = update_scene(scene, painted);
    progressive().start(edited);
    EXPECT_EQ(finished(), whole(build_scene(painted)));
    EXPECT_EQ(progressive().upload_count(), upload_count + 1);
}

TEST(GpuProgressive, CancellingLosesNothing) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors", 160, 120, 6));
    CancelFlag cancel = false;
    progressive().start(scene, from(2, &cancel));
    bool more = true;
    for (int i = 0; more; ++i) {
        cancel = i % 2 == 1;
        const Refinement before = progressive().reached();
        more = progressive().advance(0);
        if (!cancel) continue;
        EXPECT_TRUE(more);
        EXPECT_EQ(progressive().reached().rays, before.rays);
        EXPECT_EQ(progressive().reached().samples, before.samples);
    }
    cancel = false;
    EXPECT_EQ(finished(), whole(scene));
}

TEST(GpuProgressive, APictureGivenUpLeavesNoTrace) {
    GLINT_NEEDS_GPU();
    const Scene first = build_scene(exhibit("nested", 160, 120, 16));
    const Scene second = build_scene(exhibit("mirrors", 160, 120, 2));
    progressive().start(first, from(1));
    progressive().advance(0.2);
    progressive().start(second, from(8));
    EXPECT_EQ(finished(), whole(second));
}

TEST(GpuProgressive, APictureStaysAsItWas) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    const GpuScope scope(context);
    GpuProgressive picture{GpuCurrentContext{}};
    EXPECT_EQ(picture.device().name, context.device().name);
    picture.start(build_scene(exhibit("mirrors", 40, 30, 4)), from(8));
    picture.advance(0);
    std::shared_ptr<const GpuPicture> coarse = picture.picture();
    const std::string hash = picture_hash(coarse->read());
    while (picture.advance(1)) {
    }
    std::shared_ptr<const GpuPicture> fine = picture.picture();
    EXPECT_NE(fine->texture(), coarse->texture());
    EXPECT_EQ(picture_hash(coarse->read()), hash);
    EXPECT_NE(picture_hash(fine->read()), hash);
    EXPECT_EQ(picture_hash(fine->read()), picture_hash(picture.image()));

    // One that was drawn and let go serves again.
    const std::uint32_t texture = coarse->texture();
    coarse->was_drawn();
    coarse.reset();
    fine.reset();
    const auto next = picture.picture();
    const auto after = picture.picture();
    EXPECT_TRUE(next->texture() == texture || after->texture() == texture);
    context.check("showing pictures");
    EXPECT_TRUE(context.complaints().empty()) << context.complaints().front();
}

TEST(GpuProgressive, WhatItCannotDrawIsRefused) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors", 16, 16, 1));
    EXPECT_THROW(progressive().start(scene, from(3)), Error);

    SceneDescription onion = kit::empty_scene(Vec3(0, -30, 0), Vec3(0, 1, 0), 16, 40);
    for (int i = 0; i < 9; ++i) kit::add(onion, SphereShape{Vec3(0), 10.0 - i}, kit::glass(1.1, 0.9));
    onion.whitted.max_depth = 12;
    progressive().start(build_scene(onion), from(1));
    EXPECT_NE(refusal([] {
                  while (progressive().advance(1)) {
                  }
              }).find("more than eight"),
              std::string::npos);
    const auto expect_nothing_left = [] {
        EXPECT_FALSE(progressive().advance(1)) << "there is nothing to go on with";
        EXPECT_EQ(progressive().picture(), nullptr);
        EXPECT_EQ(progressive().image().width, 0);
        EXPECT_EQ(progressive().reached().step, 0);
        EXPECT_EQ(progressive().reached().fraction, 0);
    };
    expect_nothing_left();

    // Larger than a texture can be: the second time as well.
    const Scene wide = build_scene(exhibit("mirrors", 65536, 1, 1));
    for (int i = 0; i < 2; ++i) {
        EXPECT_NE(refusal([&] { progressive().start(wide, from(1)); }).find("making room for the picture"),
                  std::string::npos);
        expect_nothing_left();
    }
    progressive().start(scene, from(8));
    EXPECT_EQ(finished(), whole(scene));
}

} // namespace
} // namespace glint::gpu
