// From a scene to a picture: the same bits whatever the work's order.

#include "gallery.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace glint::rendering {
namespace {

using namespace kit;

class Rendering : public testing::TestWithParam<Exhibit> {
  protected:
    SceneDescription scene(int spp = 1) const {
        SceneDescription s = GetParam().scene;
        s.render.spp = spp;
        return s;
    }
};

INSTANTIATE_TEST_SUITE_P(Gallery, Rendering, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

RenderOptions with(int threads, int tile_size) {
    RenderOptions options;
    options.threads = threads;
    options.tile_size = tile_size;
    return options;
}

TEST_P(Rendering, ThreadsAndTilesChangeNoBit) {
    const Scene scene_data = build_scene(scene(2));
    const std::string expected = picture_hash(render(scene_data, with(1, 16)).image);
    for (const int tile_size : {8, 16, 37})
        for (const int threads : {1, 2, 7, 64}) {
            const Picture picture = render(scene_data, with(threads, tile_size));
            EXPECT_EQ(picture_hash(picture.image), expected) << threads << " threads, tiles of " << tile_size;
            EXPECT_TRUE(picture.complete);
            const int tiles = ((44 + tile_size - 1) / tile_size) * ((36 + tile_size - 1) / tile_size);
            EXPECT_EQ(picture.stats.threads, std::min(threads, tiles));
        }
}

TEST_P(Rendering, KernelsAndSimdTargetsChangeNoBit) {
    const Scene scene_data = build_scene(scene(2));
    const std::string expected = picture_hash(render(scene_data, with(1, 16)).image);
    for (const Kernel kernel : {Kernel::scalar, Kernel::single, Kernel::packets, Kernel::streams})
        for (const SimdTarget target :
             {SimdTarget::plain, SimdTarget::sse4, SimdTarget::avx2, SimdTarget::avx512}) {
            if (!is_available(target)) continue;
            RenderOptions options = with(2, 16);
            options.kernel = {kernel, target};
            EXPECT_EQ(picture_hash(render(scene_data, options).image), expected)
                << "kernel " << static_cast<int>(kernel) << ", target " << static_cast<int>(target);
        }
}

TEST_P(Rendering, DoesNotDependOnTheNumberOfThreads) {
    BuildSceneOptions one, seven;
    one.threads = 1;
    seven.threads = 7;
    EXPECT_EQ(picture_hash(render(build_scene(scene(), one)).image),
              picture_hash(render(build_scene(scene(), seven)).image));
}

TEST_P(Rendering, ACropIsThatPartOfTheWhole) {
    const Scene scene_data = build_scene(scene(2));
    const Picture whole = render(scene_data, with(2, 16));
    RenderOptions options = with(2, 8);
    options.crop = Rect{13, 7, 19, 22};
    const Picture part = render(scene_data, options);
    ASSERT_EQ(part.image.width, 19);
    ASSERT_EQ(part.image.height, 22);
    for (int y = 0; y < 22; ++y)
        for (int x = 0; x < 19; ++x)
            for (int c = 0; c < 3; ++c) ASSERT_EQ(part.image.at(x, y)[c], whole.image.at(x + 13, y + 7)[c]);
    EXPECT_EQ(part.stats.primary_rays, 2u * 19 * 22);
}

TEST_P(Rendering, TermsAddUpToThePictureToTheBit) {
    for (const int spp : {1, 16}) {
        for (const bool clamp : {false, true}) {
            SceneDescription s = scene(spp);
            s.whitted.clamp = clamp;
            RenderOptions options = with(2, 16);
            options.terms = true;
            const Picture picture = rendered(s, options);
            std::size_t unlike = 0;
            for (std::size_t i = 0; i < picture.image.pixels.size(); ++i) {
                float sum = picture.terms[0].pixels[i];
                for (int t = 1; t < term_count; ++t)
                    sum += picture.terms[static_cast<std::size_t>(t)].pixels[i];
                unlike += sum == picture.image.pixels[i] ? 0 : 1;
            }
            EXPECT_EQ(unlike, 0u) << spp << " samples, clamp " << clamp;
            EXPECT_EQ(picture_hash(picture.image), picture_hash(rendered(s).image));
        }
    }
}

TEST_P(Rendering, EveryValueIsFiniteAndNoneNegativeAtPixelCentres) {
    for (const float v : rendered(scene()).image.pixels) {
        ASSERT_TRUE(std::isfinite(v));
        ASSERT_GE(v, 0);
    }
}

TEST_P(Rendering, OneSampleIsThePixelsCentreForEveryFilterAndSeed) {
    std::set<std::string> hashes;
    for (const PixelFilter filter :
         {PixelFilter::box, PixelFilter::tent, PixelFilter::gaussian, PixelFilter::mitchell})
        for (const std::uint64_t seed : {0u, 1u}) {
            SceneDescription s = scene();
            s.render.filter = filter;
            s.render.seed = seed;
            hashes.insert(picture_hash(rendered(s).image));
        }
    EXPECT_EQ(hashes.size(), 1u);
}

TEST_P(Rendering, TheSeedChangesPicturesOfManySamples) {
    SceneDescription s = scene(4);
    std::set<std::string> hashes;
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32}) {
        s.render.seed = seed;
        hashes.insert(picture_hash(rendered(s).image));
    }
    EXPECT_EQ(hashes.size(), 3u);
}

SceneDescription lamp_ball(int size) {
    SceneDescription scene = empty_scene(Vec3(0, -3, 0), Vec3(0, 1, 0), size, 50);
    add(scene, SphereShape{}, lamp(Vec3(1, 2, 4)));
    return scene;
}

TEST(Render, ThePixelsCentreIsTraced) {
    SceneDescription scene = lamp_ball(2);
    scene.camera->fov = 90;
    scene.objects.clear();
    // A pixel's centre is half a pixel from the middle: a lamp of that direction alone fills pixel (1, 0).
    add(scene, SphereShape{Vec3(0.5, -2, 0.5), 0.01}, scene.materials[0].name);
    const Image image = rendered(scene).image;
    EXPECT_EQ(image.at(1, 0)[0], 1);
    EXPECT_EQ(image.at(0, 0)[0], 0);
    EXPECT_EQ(image.at(1, 1)[0], 0);
    EXPECT_EQ(image.at(0, 1)[0], 0);
}

TEST(Render, CoverageIsTheShareOfSamplesThatHit) {
    SceneDescription scene = lamp_ball(32);
    scene.render.filter = PixelFilter::box;
    scene.render.spp = 16;
    RenderOptions options;
    options.coverage = true;
    const Picture picture = rendered(scene, options);
    ASSERT_EQ(picture.coverage.size(), 32u * 32);
    int partial = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const float share = picture.coverage[static_cast<std::size_t>(y * 32 + x)];
            EXPECT_EQ(picture.image.at(x, y)[0], share);
            EXPECT_EQ(picture.image.at(x, y)[2], 4 * share);
            if (share > 0 && share < 1) ++partial;
        }
    EXPECT_EQ(picture.coverage[16 * 32 + 16], 1);
    EXPECT_EQ(picture.coverage[0], 0);
    EXPECT_GT(partial, 20);
    EXPECT_TRUE(rendered(scene).coverage.empty());
}

TEST(Render, TermsAreEmptyUnlessAskedFor) {
    for (const Image& term : rendered(lamp_ball(4)).terms) EXPECT_TRUE(term.pixels.empty());
}

TEST(Render, TheBackgroundCountsAsEmission) {
    SceneDescription scene = empty_scene(Vec3(0), Vec3(0, 1, 0), 2);
    scene.render.background = Vec3(0.5);
    RenderOptions options;
    options.terms = true;
    const Picture picture = rendered(scene, options);
    EXPECT_EQ(picture.image.pixels[0], 0.5f);
    EXPECT_EQ(picture.terms[static_cast<std::size_t>(Term::emission)].pixels, picture.image.pixels);
}

TEST(Render, CoverageIsFilteredAsTheLightIs) {
    SceneDescription scene = lamp_ball(32);
    for (const int spp : {2, 8, 64}) {
        scene.render.filter = PixelFilter::mitchell;
        scene.render.spp = spp;
        RenderOptions options;
        options.coverage = true;
        const Picture picture = rendered(scene, options);
        for (std::size_t i = 0; i < picture.coverage.size(); ++i)
            EXPECT_EQ(picture.coverage[i], std::clamp(picture.image.pixels[3 * i], 0.0f, 1.0f)) << spp;
    }
}

/// RMSE of the filter's noise with 16 samples on a ball's outline, against its own picture of many.
double noise_of(PixelFilter filter) {
    SceneDescription scene = lamp_ball(24);
    scene.render.filter = filter;
    scene.render.spp = 16;
    const Picture few = rendered(scene);
    scene.render.spp = 512;
    return compare(few.image, rendered(scene).image, 0, 1).rmse;
}

TEST(Render, TheDefaultFilterIsNoNoisierThanABox) {
    EXPECT_LE(noise_of(RenderSettings().filter), noise_of(PixelFilter::box));
    EXPECT_GE(noise_of(PixelFilter::mitchell), 1.5 * noise_of(PixelFilter::box));
}

TEST(Render, WithCoverageTheBackgroundIsLeftOut) {
    SceneDescription scene = lamp_ball(32);
    scene.render.spp = 16;
    RenderOptions options;
    options.terms = true;
    options.coverage = true;
    const Picture on_black = rendered(scene, options);
    scene.render.background = Vec3(0.5);
    const Picture on_gray = rendered(scene, options);
    EXPECT_EQ(on_gray.image.pixels, on_black.image.pixels);
    for (std::size_t t = 0; t < on_gray.terms.size(); ++t)
        EXPECT_EQ(on_gray.terms[t].pixels, on_black.terms[t].pixels);
    EXPECT_EQ(on_gray.coverage, on_black.coverage);
    EXPECT_EQ(on_gray.coverage[0], 0);
}

TEST(Render, RefusesACropOutsideThePicture) {
    const Scene scene = build_scene(lamp_ball(16));
    const Rect bad[] = {{-1, 0, 4, 4}, {0, 0, 17, 1}, {15, 15, 2, 1},
                        {0, 0, 0, 4},  {0, 0, 4, -1}, {2147483647, 0, 1, 1}};
    for (const Rect& crop : bad) {
        RenderOptions options;
        options.crop = crop;
        try {
            render(scene, options);
            ADD_FAILURE() << "accepted " << crop.x << "," << crop.y << "," << crop.width << ","
                          << crop.height;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            EXPECT_EQ(error.diagnostics().at(0).message, "the crop does not lie inside the picture");
            EXPECT_EQ(error.diagnostics().at(0).hint, "expected x, y, width, height within 16x16");
        }
    }
}

TEST(Render, CountsEveryRay) {
    SceneDescription scene = empty_scene(Vec3(0, 0, 1), Vec3(0, 0, -1), 8);
    Material m = mirror(0.5);
    m.diffuse = 1;
    m.color = Vec3(1);
    add(scene, PlaneShape{}, m);
    add_light(scene, Vec3(0, 0, 4));
    const RenderStats stats = rendered(scene).stats;
    EXPECT_EQ(stats.primary_rays, 64u);
    EXPECT_EQ(stats.reflected_rays, 64u);
    EXPECT_EQ(stats.shadow_rays, 64u);
    EXPECT_EQ(stats.refracted_rays, 0u);
    EXPECT_EQ(stats.rays(), 192u);
    EXPECT_EQ(stats.left_out_rays, 0u);
    EXPECT_GT(stats.wall_seconds, 0);
}

TEST(Render, BoundsTheShareOfTheRaysThatItLeavesOut) {
    SceneDescription scene = empty_scene(Vec3(0, 0, 1), Vec3(0, 0, -1), 8);
    add(scene, PlaneShape{}, mirror(0.25));
    scene.whitted.min_weight = 0.5;
    const Scene built = build_scene(scene);
    const RenderStats stats = render(built).stats;
    EXPECT_EQ(stats.reflected_rays, 0u);
    EXPECT_EQ(stats.left_out_rays, 64u);
    EXPECT_EQ(left_out_share(stats, built), 0.5);
    EXPECT_EQ(left_out_share(RenderStats{}, built), 0.0);
}

TEST(Render, ManySamplesApproachTheAreaThatIsCovered) {
    SceneDescription scene = lamp_ball(1);
    scene.camera->fov = 90;
    scene.render.filter = PixelFilter::box;
    scene.render.spp = 1024;
    // The ball's outline has the radius 1/√8 of a film that spans −1 … 1.
    EXPECT_NEAR(rendered(scene).image.pixels[0], pi / 8 / 4, 2e-3);
}

TEST(PictureSettings, NameWhatDecidesThePicture) {
    SceneDescription scene = lamp_ball(4);
    scene.render.seed = 7;
    scene.whitted.shadows = Shadows::opaque;
    const auto settings = picture_settings(build_scene(scene));
    const auto value = [&](const std::string& key) -> std::string {
        for (const auto& [name, text] : settings)
            if (name == key) return text;
        return "missing";
    };
    EXPECT_EQ(value("glint.version"), version());
    EXPECT_EQ(value("glint.size"), "4x4");
    EXPECT_EQ(value("glint.spp"), "1");
    EXPECT_EQ(value("glint.seed"), "7");
    EXPECT_EQ(value("glint.filter"), "box");
    EXPECT_EQ(value("glint.shadows"), "opaque");
    EXPECT_EQ(value("glint.max_depth"), "8");
    EXPECT_EQ(value("glint.clamp"), "false");
    EXPECT_EQ(value("glint.energy"), "report");
    EXPECT_EQ(value("glint.highlight_model"), "blinn");
}

TEST(TermNames, StandInTheOrderOfTheSum) {
    const char* names[] = {"ambient",    "diffuse",      "highlight", "clamp",
                           "reflection", "transmission", "emission"};
    for (int i = 0; i < term_count; ++i) EXPECT_STREQ(term_name(static_cast<Term>(i)), names[i]);
}

} // namespace
} // namespace glint::rendering
