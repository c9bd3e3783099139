// The integrator ambient-occlusion against closed forms.

#include "gallery.h"
#include "one_picture.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::rendering {
namespace {

using namespace kit;

constexpr int samples = 4096;

/// Looks straight down at a white ground; a pixel or a few, many samples.
SceneDescription ground(int size = 1) {
    SceneDescription scene = empty_scene(Vec3(0, 0, 0.25), Vec3(0, 0, -1), size, 1e-3);
    scene.camera->up = Vec3(0, 1, 0);
    scene.render.integrator = Integrator::ambient_occlusion;
    scene.render.spp = samples;
    scene.render.filter = PixelFilter::box;
    add(scene, PlaneShape{Vec3(0, 0, 1), 0}, matte());
    return scene;
}

float openness(const SceneDescription& scene) { return rendered(scene).image.at(0, 0)[0]; }

TEST(AmbientOcclusion, APlaneAloneIsOpen) { EXPECT_EQ(openness(ground()), 1.0f); }

TEST(AmbientOcclusion, ASphereAboveHidesTheSquareOfItsSine) {
    for (const double height : {2.5, 4.0, 10.0}) {
        SceneDescription scene = ground();
        add(scene, SphereShape{Vec3(0, 0, height), 2}, matte());
        scene.ambient_occlusion.distance = 100;
        const double sine = 2 / height;
        EXPECT_NEAR(openness(scene), 1 - sine * sine, 0.002) << height;
    }
}

/// A ceiling is nearer than the distance d within the cone cos θ > h / d, which holds 1 − (h / d)² of the
/// cosine-weighted hemisphere.
TEST(AmbientOcclusion, OnlyWhatIsNearerThanTheDistanceHides) {
    for (const double distance : {1.0, 3.5, 4.0, 6.0, 30.0}) {
        SceneDescription scene = ground();
        add(scene, PlaneShape{Vec3(0, 0, -1), -3}, matte());
        scene.ambient_occlusion.distance = distance;
        const double cosine = std::min(1.0, 3 / distance);
        EXPECT_NEAR(openness(scene), cosine * cosine, 0.002) << distance;
    }
}

TEST(AmbientOcclusion, TheDistanceIsATenthOfTheDiagonalUnlessGiven) {
    SceneDescription scene = ground();
    const PolyhedronShape slab{
        .kind = PolyhedronKind::box, .center = Vec3(0, 0, 5.5), .size = Vec3(30, 30, 5)};
    add(scene, slab, matte());
    const double diagonal = std::sqrt(30.0 * 30 + 30 * 30 + 5 * 5);
    const double cosine = 3 / (0.1 * diagonal);
    EXPECT_NEAR(openness(scene), cosine * cosine, 0.002);
    // Planes are not finite: alone, they hide at any distance.
    SceneDescription planes = ground();
    add(planes, PlaneShape{Vec3(0, 0, -1), -1000}, matte());
    EXPECT_EQ(openness(planes), 0.0f);
}

TEST(AmbientOcclusion, LightsAndMaterialsDoNotMatterUnlessColored) {
    SceneDescription scene = ground();
    add(scene, SphereShape{Vec3(0, 0, 4), 2}, glass(1.5));
    Material paint = mirror(0.5);
    paint.color = Vec3(0.25, 0.5, 1);
    material_of_object(scene, 0) = paint;
    scene.objects[0].material = paint.name;
    scene.ambient_occlusion.distance = 100;
    const float open = openness(scene);
    EXPECT_NEAR(open, 0.75, 0.002);
    add_light(scene, Vec3(1, 0, 1), 5);
    EXPECT_EQ(openness(scene), open);
    scene.ambient_occlusion.colored = true;
    const Image image = rendered(scene).image;
    EXPECT_NEAR(image.at(0, 0)[0], 0.25f * open, 1e-6);
    EXPECT_NEAR(image.at(0, 0)[1], 0.5f * open, 1e-6);
    EXPECT_NEAR(image.at(0, 0)[2], open, 1e-6);
}

TEST(AmbientOcclusion, TheBackgroundShowsWhereNothingIs) {
    SceneDescription scene = empty_scene();
    scene.render.integrator = Integrator::ambient_occlusion;
    scene.render.background = Vec3(0.25, 0.5, 0.75);
    EXPECT_EQ(rendered(scene).image.at(3, 4)[1], 0.5f);
}

TEST(AmbientOcclusion, ThreadsKernelsTilesAndCropsChangeNoBit) {
    for (const Exhibit& exhibit : gallery()) {
        SceneDescription scene = exhibit.scene;
        scene.render.integrator = Integrator::ambient_occlusion;
        SCOPED_TRACE(exhibit.name);
        expect_one_picture(scene);
    }
}

TEST(AmbientOcclusion, HasNoTerms) {
    RenderOptions options;
    options.terms = true;
    try {
        rendered(ground(), options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("ambient-occlusion"), std::string::npos) << error.what();
    }
    EXPECT_EQ(openness(ground()), 1.0f);
}

} // namespace
} // namespace glint::rendering
