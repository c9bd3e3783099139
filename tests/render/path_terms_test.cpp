// Terms of path tracing, and that nothing but scene and seed changes a bit of its pictures.

#include "gallery.h"
#include "one_picture.h"
#include "path_kit.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glint::rendering {
namespace {

using namespace kit;

// ── Terms ──

vec3 pixel_of(const Image& image, std::size_t i) {
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

TEST(Path, TermsAddUpToThePictureToTheBit) {
    for (const Integrator integrator : {Integrator::path, Integrator::direct})
        for (const int spp : {1, 5}) {
            SceneDescription scene = room();
            scene.render.integrator = integrator;
            scene.render.spp = spp;
            RenderOptions options;
            options.terms = true;
            const Picture picture = rendered(scene, options);
            const Image alone = rendered(scene).image;
            double indirect = 0;
            for (std::size_t i = 0; i < picture.image.pixels.size(); i += 3) {
                vec3 sum = pixel_of(picture.terms[0], i);
                for (std::size_t t = 1; t < picture.terms.size(); ++t)
                    sum = sum + pixel_of(picture.terms[t], i);
                EXPECT_EQ(sum, pixel_of(picture.image, i));
                EXPECT_EQ(sum, pixel_of(alone, i));
                indirect += dot(pixel_of(picture.terms[3], i), vec3(1));
            }
            EXPECT_EQ(indirect > 0, integrator == Integrator::path);
        }
}

TEST(Path, TermsTellHowLightComesToTheFirstHit) {
    // Seen straight from above: a floor, lit by a lamp, and by a mirror beside it that shows the floor.
    SceneDescription scene = path_scene(Vec3(0, 0, 1), Vec3(0, 0, -1));
    scene.render.width = scene.render.height = 1;
    scene.camera->fov = 1e-3;
    scene.render.spp = 4096;
    add(scene, PlaneShape{}, matte(0.5));
    add(scene, DiskShape{Vec3(0, 0, 2), Vec3(0, 0, 1), 1}, lamp(Vec3(1)));
    RenderOptions options;
    options.terms = true;
    const auto term = [&](PathTerm which) {
        return rendered(scene, options).terms[static_cast<std::size_t>(which)].at(0, 0)[0];
    };
    EXPECT_NEAR(term(PathTerm::direct_diffuse), 0.1, 2e-4);
    EXPECT_EQ(term(PathTerm::direct_specular), 0);
    EXPECT_EQ(term(PathTerm::emission), 0);
    Material& ground = material_of_object(scene, 0);
    ground.diffuse = 0;
    ground.reflectivity = 0.5;
    EXPECT_EQ(term(PathTerm::direct_specular), 0.5f);
    EXPECT_EQ(term(PathTerm::direct_diffuse), 0);
    ground.reflectivity = 0;
    ground.emission = Vec3(2);
    EXPECT_EQ(term(PathTerm::emission), 2);
}

TEST(Path, TermsOfOtherIntegratorsAreRefused) {
    SceneDescription scene = room();
    RenderOptions options;
    const auto message = [&](Integrator integrator, Aov show) {
        scene.render.integrator = integrator;
        options.show = show;
        try {
            rendered(scene, options);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(message(Integrator::path, Aov::direct_diffuse), "none");
    EXPECT_EQ(message(Integrator::path, Aov::depth), "none");
    EXPECT_NE(message(Integrator::path, Aov::ambient).find("path has no term ambient"), std::string::npos);
    EXPECT_NE(message(Integrator::whitted, Aov::direct_diffuse).find("no term"), std::string::npos);
    EXPECT_NE(message(Integrator::path_simple, Aov::emission).find("path-simple"), std::string::npos);
}

// ── One picture ──

TEST(Path, ThreadsKernelsTilesAndCropsChangeNoBit) {
    for (const Integrator integrator : {Integrator::path, Integrator::path_simple, Integrator::direct}) {
        SceneDescription scene = room();
        scene.render.integrator = integrator;
        scene.render.spp = 2;
        expect_one_picture(scene);
    }
}

TEST(Path, AllScenesOfTheGalleryAreTracedAlikeByAllKernels) {
    for (const Exhibit& exhibit : gallery()) {
        SceneDescription scene = exhibit.scene;
        scene.render.integrator = Integrator::path;
        RenderOptions scalar;
        scalar.kernel.kernel = Kernel::scalar;
        EXPECT_EQ(picture_hash(rendered(scene).image), picture_hash(rendered(scene, scalar).image))
            << exhibit.name;
    }
}

} // namespace
} // namespace glint::rendering
