// An explanation is the picture, taken apart: its sums are the picture's bits, its formulas hold.

#include "gallery.h"
#include "scene_kit.h"

#include "glint/explain.h"
#include "glint/explanation_files.h"
#include "glint/scene.h"

#include <gtest/gtest.h>

namespace glint::rendering {
namespace {

using namespace kit;

vec3 pixel_of(const Image& image, int x, int y) {
    const float* p = image.at(x, y);
    return {p[0], p[1], p[2]};
}

class ExplanationOf : public testing::TestWithParam<Exhibit> {
  protected:
    static SceneDescription sized(int width, int height, int spp) {
        SceneDescription scene = GetParam().scene;
        scene.render.width = width;
        scene.render.height = height;
        scene.render.spp = spp;
        return scene;
    }
};

INSTANTIATE_TEST_SUITE_P(Gallery, ExplanationOf, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

TEST_P(ExplanationOf, EveryPixelSumsToThePictureBitForBit) {
    const Scene scene = build_scene(sized(160, 120, 1));
    RenderOptions options;
    options.terms = true;
    const Picture picture = render(scene, options);
    Explainer explainer(scene);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            const Explanation e = explainer.pixel(x, y);
            ASSERT_EQ(e.color, pixel_of(picture.image, x, y)) << "pixel " << x << "," << y;
            for (std::size_t i = 0; i < e.terms.size(); ++i)
                ASSERT_EQ(e.terms[i], pixel_of(picture.terms[i], x, y))
                    << term_name(static_cast<Term>(i)) << " of pixel " << x << "," << y;
        }
}

TEST_P(ExplanationOf, SamplesMakeThePixelHoweverManyThereAre) {
    for (const int spp : {2, 5, 16, 23}) {
        SceneDescription description = sized(16, 12, spp);
        description.render.filter = PixelFilter::mitchell; // has samples of negative weight
        const Scene scene = build_scene(description);
        const Picture picture = render(scene);
        Explainer explainer(scene);
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 16; ++x) {
                const Explanation e = explainer.pixel(x, y);
                ASSERT_EQ(e.samples.size(), static_cast<std::size_t>(spp));
                ASSERT_EQ(e.color, pixel_of(picture.image, x, y)) << "pixel " << x << "," << y;
            }
    }
}

TEST(ExplainedPixel, MustLieInThePicture) {
    const Scene scene = build_scene(empty_scene());
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {16, 0}, {0, 16}})
        EXPECT_THROW(explain(scene, x, y), Error) << x << "," << y;
}

TEST(ExplainedPixel, ItsMakingCanBeCancelled) {
    SceneDescription description = empty_scene();
    description.render.spp = 16384;
    const Scene scene = build_scene(description);
    CancelFlag cancel{true};
    Explainer explainer(scene, &cancel);
    try {
        explainer.pixel(3, 4);
        FAIL() << "it went on";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
    cancel = false;
    EXPECT_EQ(explainer.pixel(3, 4).color, explain(scene, 3, 4).color);
}

TEST(ExplainedPixels, AreTheSameOnAnyNumberOfThreads) {
    SceneDescription description = empty_scene(Vec3(0, -4, 1), Vec3(0, 4, -1));
    description.render.spp = 3;
    add(description, SphereShape{Vec3(0), 1}, glass(1.5));
    add(description, PlaneShape{}, mirror(0.5));
    add_light(description, Vec3(2, -3, 4), 20);
    const Scene scene = build_scene(description);
    std::vector<PixelCoord> pixels;
    for (int i = 0; i < 40; ++i) pixels.push_back({i % 16, i * 7 % 16});
    for (const int threads : {1, 2, 3, 7}) {
        const std::vector<Explanation> explained = explain_pixels(scene, pixels, {}, threads);
        ASSERT_EQ(explained.size(), pixels.size());
        for (std::size_t i = 0; i < pixels.size(); ++i)
            EXPECT_EQ(explanation_json(explained[i]),
                      explanation_json(explain(scene, pixels[i].x, pixels[i].y)))
                << "pixel " << i << ", " << threads << " threads";
    }
    EXPECT_THROW(explain_pixels(scene, std::vector<PixelCoord>{{0, 0}, {16, 0}}), Error);
}

TEST(Labels, CountAsKeyPathsDo) {
    SceneDescription scene = empty_scene();
    scene.objects.clear();
    scene.lights.clear();
    add(scene, SphereShape{Vec3(0), 1}, Material{});
    add(scene, PlaneShape{}, Material{});
    add(scene, SphereShape{Vec3(5), 1}, Material{});
    scene.objects[0].name = "ball";
    scene.lights.push_back({AmbientLight{}, {}});
    scene.lights.push_back({SpotLight{}, {}});
    scene.lights.push_back({PointLight{}, {}, "key"});
    const std::vector<std::uint32_t> numbers = object_numbers(scene);
    EXPECT_EQ(numbers, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(object_label(scene.objects[0], numbers[0]), "sphere \"ball\"");
    EXPECT_EQ(object_label(scene.objects[1], numbers[1]), "plane.0");
    EXPECT_EQ(object_label(scene.objects[2], numbers[2]), "sphere.1");
    EXPECT_EQ(light_label(scene, 0), "ambient light.0");
    EXPECT_EQ(light_label(scene, 1), "spot light.1");
    EXPECT_EQ(light_label(scene, 2), "point light \"key\"");
}

} // namespace
} // namespace glint::rendering
