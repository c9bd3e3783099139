// Surfaces of two objects in one place: what is seen there, from both sides and from anywhere
// (docs/light-model.md, "Surfaces in one place").

#include "scene_kit.h"

#include "glint/image.h"
#include "math/random.shared.h"
#include "render/estimators/whitted.h"
#include "render/estimators/whitted_wavefront.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::rendering {
namespace {

using namespace kit;

struct Part {
    const char* name;
    Shape shape;
    bool solid = false;
};

/// Shapes with a flat part in z = 0 that covers |x|, |y| < 0.6: sheets, solids above it and solids below it.
std::vector<Part> sheets() {
    const Vec3 a(-1, -1, 0);
    const TriangleShape triangle{{Vec3(-3, -2, 0), Vec3(3, -2, 0), Vec3(0, 4, 0)}};
    return {{"plane", PlaneShape{}},
            {"disk", DiskShape{}},
            {"rectangle", RectangleShape{a, Vec3(2, 0, 0), Vec3(0, 2, 0)}},
            {"triangle", triangle}};
}
std::vector<Part> solids(double side) {
    const Vec3 middle(0.1, 0, 0.1 * side), size(2, 2, 0.2);
    return {{"box", PolyhedronShape{PolyhedronKind::box, middle, size}, true},
            {"cylinder", CylinderShape{Vec3(0), Vec3(0, 0, side), 0.2, 1}, true},
            {"mesh", mesh_of(box_mesh(middle, size)), true},
            {"instance", InstanceShape{side > 0 ? "up" : "down"}, true}};
}

std::vector<Part> operator+(std::vector<Part> a, const std::vector<Part>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Adds the meshes of the instances.
void add_meshes(SceneDescription& scene) {
    scene.materials.push_back(black());
    scene.materials.back().name = "none";
    for (const double side : {1.0, -1.0}) {
        Object& mesh = add(scene, mesh_of(box_mesh(Vec3(0, 0, 0.1 * side), Vec3(2, 2, 0.2))), "none");
        mesh.name = side > 0 ? "up" : "down";
        mesh.visible = false;
    }
}

/// Objects of a scene in the order given, all of them placed alike.
SceneDescription scene_of(const std::vector<std::pair<Part, Material>>& objects, unsigned place = 0) {
    SceneDescription scene = empty_scene(Vec3(100));
    add_meshes(scene);
    Mat4 transform(1);
    if (place > 0) {
        transform = rotation(place);
        transform[3] = dvec4(0.3 * place, -1.7, 2.9, 1);
    }
    for (const auto& [part, material] : objects) add(scene, part.shape, material).transform = transform;
    return scene;
}

/// A number in −1 … 1 for each ray and dimension.
double drawn(std::uint32_t ray, std::uint32_t dimension) {
    return 2.0 * static_cast<double>(sample_pair(12345, ray, dimension).x) - 1.0;
}

/// Rays to points of |x|, |y| < 0.3 at a height, from a side, up to 75° aslant.
std::vector<CameraSample> rays_to(double height, double side, double distance,
                                  const SceneDescription& scene) {
    const Mat4& transform = scene.objects.back().transform;
    std::vector<CameraSample> rays;
    for (std::uint32_t i = 0; i < 50; ++i) {
        const Vec3 target(0.3 * drawn(i, 0), 0.3 * drawn(i, 1), height);
        const double angle = pi * drawn(i, 2), slope = 75 * pi / 180 * drawn(i, 3);
        const Vec3 from(std::sin(slope) * std::cos(angle), std::sin(slope) * std::sin(angle),
                        std::cos(slope) * side);
        const Vec3 origin = target + from * (distance / std::abs(from.z));
        rays.push_back(camera_ray(vec3(Vec3(transform * dvec4(origin, 1))),
                                  vec3(glm::normalize(Vec3(dmat3(transform) * -from)))));
    }
    return rays;
}

/// Fails where a ray shows anything else, by recursion or in a wavefront.
void expect_light(const SceneDescription& description, const std::vector<CameraSample>& rays, double expected,
                  const std::string& what) {
    const Scene scene = build_scene(description);
    EXPECT_TRUE(scene.data().any_contact) << what;
    std::vector<Channels> single(rays.size()), wave(rays.size());
    Whitted(scene.data()).estimate(rays, single);
    WhittedWavefront(scene.data(), description.whitted).estimate(rays, wave);
    std::size_t wrong = 0, different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        wrong += std::abs(single[i].radiance.x - expected) > 1e-5 * expected ? 1 : 0;
        different += single[i].radiance != wave[i].radiance ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0u) << what << ": " << single[0].radiance.x << " for " << expected;
    EXPECT_EQ(different, 0u) << what;
}

std::string title(const Part& a, const Part& b, unsigned place) {
    return std::string(a.name) + " then " + b.name + ", place " + std::to_string(place);
}

TEST(Contact, OfOpaqueSurfacesTheLaterIsSeenFromBothSides) {
    const std::vector<Part> parts = sheets() + solids(1) + solids(-1);
    for (const Part& a : parts)
        for (const Part& b : parts)
            for (const unsigned place : {0u, 7u}) {
                const SceneDescription scene = scene_of({{a, lamp(Vec3(1))}, {b, lamp(Vec3(2))}}, place);
                for (const double side : {1.0, -1.0})
                    expect_light(scene, rays_to(0, side, 0.1, scene), 2, title(a, b, place));
            }
}

TEST(Contact, AHigherPriorityComesBeforeTheLaterPlace) {
    SceneDescription scene = scene_of({{sheets()[2], lamp(Vec3(1))}, {sheets()[0], lamp(Vec3(2))}});
    scene.objects[2].priority = 1;
    expect_light(scene, rays_to(0, 1, 1, scene), 1, "a rug of higher priority");
}

TEST(Contact, WhatIsUnderGlassIsSeenWithoutAGap) {
    // A gap would reflect slanting rays totally; a gap that rays leap would show what is below.
    for (const Part& under : sheets() + solids(-1))
        for (const Part& over : solids(1))
            for (const bool glass_first : {true, false})
                for (const unsigned place : {0u, 3u}) {
                    std::vector<std::pair<Part, Material>> objects{{under, lamp(Vec3(2))},
                                                                   {over, glass(1.5, 0.5)}};
                    if (glass_first) std::swap(objects[0], objects[1]);
                    const SceneDescription scene = scene_of(objects, place);
                    expect_light(scene, rays_to(0.2, 1, 0.5, scene), 1, title(under, over, place));
                    if (!under.solid)
                        expect_light(scene, rays_to(0, -1, 0.5, scene), 2, title(under, over, place));
                }
}

TEST(Contact, WhatIsUnderGlassIsLitThroughIt) {
    for (const Part& under : sheets() + solids(-1))
        for (const Part& over : solids(1))
            for (const unsigned place : {0u, 3u}) {
                SceneDescription scene = scene_of({{under, matte()}, {over, glass(1.5, 0.5)}}, place);
                const dmat3 turned(scene.objects.back().transform);
                scene.lights.push_back({DirectionalLight{turned * Vec3(0.1, 0.2, -1)}, {}});
                const double cosine = 1 / std::sqrt(1.05);
                expect_light(scene, rays_to(0.2, 1, 0.5, scene), 0.25 * cosine, title(under, over, place));
            }
}

TEST(Contact, OfGlassOnGlassOneSurfaceIsCrossed) {
    // Into the one, across both, out of the other: as if they overlapped by a hair.
    for (const Part& under : solids(-1))
        for (const Part& over : solids(1))
            for (const bool swapped : {true, false}) {
                std::vector<std::pair<Part, Material>> objects{{under, glass(1.3, 0.5)},
                                                               {over, glass(1.5, 0.25)}};
                if (swapped) std::swap(objects[0], objects[1]);
                SceneDescription scene = scene_of(objects, 3);
                scene.render.background = Vec3(1);
                const double expected = 0.5 * 0.25 * (swapped ? 0.5 : 0.25);
                expect_light(scene, rays_to(0.2, 1, 0.5, scene), expected, title(under, over, 3));
                expect_light(scene, rays_to(-0.2, -1, 0.5, scene), expected, title(under, over, 3));
            }
}

TEST(Contact, ShadowsCrossOneSurfaceOfGlassOnGlass) {
    const auto share = [](double gap) {
        SceneDescription scene = empty_scene();
        add(scene, PlaneShape{Vec3(0, 0, 1), -2}, matte());
        for (const double z : {0.5, -0.5 - gap})
            add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0, 0, z), Vec3(1)}, glass(1.5, 0.5));
        add_light(scene, Vec3(0, 0, 3), 25);
        return look(scene, Vec3(-2, 0, -1.5), Vec3(2, 0, -0.5)).light.x;
    };
    EXPECT_FLOAT_EQ(share(0), 0.125f);
    EXPECT_FLOAT_EQ(share(0.1), 0.0625f);
}

TEST(Contact, EveryPaneCounts) {
    // Two panes, and a pane on a block of glass, which is left through a further surface.
    for (const Part& pane : sheets())
        for (const bool pane_first : {true, false}) {
            SceneDescription scene = scene_of({{pane, glass(1, 0.5)}, {sheets()[1], glass(1, 0.25)}}, 3);
            scene.render.background = Vec3(1);
            for (const double side : {1.0, -1.0})
                expect_light(scene, rays_to(0, side, 1, scene), 0.125, pane.name);
            std::vector<std::pair<Part, Material>> objects{{pane, glass(1, 0.25)},
                                                           {solids(-1)[0], glass(1.5, 0.5)}};
            if (pane_first) std::swap(objects[0], objects[1]);
            scene = scene_of(objects, 3);
            scene.render.background = Vec3(1);
            expect_light(scene, rays_to(0, 1, 0.5, scene), 0.0625, pane.name);
            expect_light(scene, rays_to(-0.2, -1, 0.5, scene), 0.0625, pane.name);
        }
}

TEST(Contact, APaneInAnOpaqueFaceIsNotSeen) {
    for (const Part& face : sheets() + solids(-1))
        for (const bool pane_first : {true, false}) {
            std::vector<std::pair<Part, Material>> objects{{face, lamp(Vec3(2))},
                                                           {sheets()[2], glass(1, 0.5)}};
            if (pane_first) std::swap(objects[0], objects[1]);
            const SceneDescription scene = scene_of(objects, 3);
            expect_light(scene, rays_to(0, 1, 1, scene), 2, face.name);
        }
}

TEST(Contact, GlassBallsAndLyingGlassCylindersTouchTheGround) {
    const Shape shapes[] = {SphereShape{Vec3(0, 0, 1), 1},
                            CylinderShape{Vec3(-1, 0, 1), Vec3(1, 0, 0), 2, 1}};
    for (const Shape& shape : shapes)
        for (const unsigned place : {0u, 3u, 5u})
            for (const bool glass_first : {true, false}) {
                std::vector<std::pair<Part, Material>> objects{{{"plane", PlaneShape{}}, lamp(Vec3(1))},
                                                               {{"round", shape}, glass(1.5)}};
                if (glass_first) std::swap(objects[0], objects[1]);
                const SceneDescription description = scene_of(objects, place);
                const Scene scene = build_scene(description);
                // Down the middle, to where the two part by 1e-9 to 1e-3.
                std::vector<CameraSample> rays;
                const Mat4& transform = description.objects.back().transform;
                for (std::uint32_t i = 0; i < 400; ++i) {
                    const double off = std::pow(10.0, -2.9 + 1.5 * drawn(i, 0));
                    const Vec3 origin(off * drawn(i, 1), off * drawn(i, 2), 4);
                    rays.push_back(camera_ray(vec3(Vec3(transform * dvec4(origin, 1))),
                                              vec3(dmat3(transform) * Vec3(0, 0, -1))));
                }
                std::vector<Channels> seen(rays.size());
                Whitted(scene.data()).estimate(rays, seen);
                for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(seen[i].radiance.x, 1) << place << i;
            }
}

TEST(Contact, TheSameObjectTwiceIsSeenOnce) {
    const std::vector<Part> parts = solids(1) + std::vector<Part>{{"ball", SphereShape{Vec3(0, 0, 0.1), 1}},
                                                                  {"scan", mesh_of(sphere_mesh(1, 24))}};
    for (const Part& part : parts)
        for (const unsigned place : {0u, 3u}) {
            SceneDescription scene = scene_of({{part, glass(1.5, 0.25)}, {part, glass(1.2, 0.5)}}, place);
            scene.render.background = Vec3(1);
            expect_light(scene, rays_to(0.2, 1, 2, scene), 0.25, part.name);
        }
}

TEST(Contact, ADrinkAsWideAsItsGlassMeetsIt) {
    // The air in the tumbler and the tea have one side, and the tea stands on the tumbler's ground.
    SceneDescription scene = in_sky();
    add(scene, CylinderShape{Vec3(0, 0, 0), Vec3(0, 0, 1), 2, 1}, glass(1.5, 0.5));
    add(scene, CylinderShape{Vec3(0, 0, 0.2), Vec3(0, 0, 1), 1.8, 0.9}, glass(1, 0.5));
    add(scene, CylinderShape{Vec3(0, 0, 0.2), Vec3(0, 0, 1), 1, 0.9}, glass(1.33, 0.5));
    for (const double z : {0.3, 0.61, 0.93}) {
        const Look seen = look(scene, Vec3(-4, 0.1, z), Vec3(1, 0, 0));
        EXPECT_FLOAT_EQ(seen.light.x, 0.0625f);
        EXPECT_EQ(seen.node(1).index_before, 1.5f);
        EXPECT_EQ(seen.node(1).index_after, 1.33f);
    }
}

TEST(Contact, EveryKernelGivesTheSameBits) {
    SceneDescription scene = empty_scene(Vec3(2.3, -5, 3), Vec3(-2.3, 5, -2.2), 48);
    scene.render.background = Vec3(0.5, 0.6, 0.8);
    add_meshes(scene);
    Material floor = matte(0.7);
    floor.reflectivity = 0.2;
    add(scene, PlaneShape{}, floor);
    Material clear = glass(1.5, 0.9);
    clear.fresnel = true;
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(0, 0, 1), Vec3(2)}, clear);
    add(scene, InstanceShape{"up"}, clear).transform[3] = dvec4(0, 0, 2, 1);
    add(scene, RectangleShape{Vec3(1, -2, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, matte(0.3));
    add_light(scene, Vec3(-3, -4, 6), 40);
    RenderOptions options;
    options.kernel.kernel = Kernel::scalar;
    const std::string expected = picture_hash(rendered(scene, options).image);
    EXPECT_EQ(picture_hash(rendered(scene).image), expected);
    options.kernel.kernel = Kernel::single;
    EXPECT_EQ(picture_hash(rendered(scene, options).image), expected);
}

TEST(Contact, IsNowhereWhereNothingCoincides) {
    const PolyhedronShape box{PolyhedronKind::box, Vec3(0, 0, 0.5), Vec3(1)};
    const auto meet = [&](const Shape& other, const Material& material) {
        SceneDescription scene = empty_scene();
        add(scene, box, material);
        add(scene, other, matte());
        return build_scene(scene).data().any_contact;
    };
    for (const Material& material : {matte(), glass(1.5)}) {
        EXPECT_TRUE(meet(PlaneShape{}, material));
        EXPECT_FALSE(meet(PlaneShape{Vec3(0, 0, 1), -1e-5}, material)) << "a gap";
        EXPECT_FALSE(meet(PlaneShape{Vec3(0, 0, 1), 1e-5}, material)) << "an overlap";
        EXPECT_FALSE(meet(PolyhedronShape{PolyhedronKind::box, Vec3(1, 1, 0.5), Vec3(1)}, material))
            << "edges";
        EXPECT_FALSE(meet(RectangleShape{Vec3(0.5, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, material))
            << "edges";
    }
    EXPECT_TRUE(meet(SphereShape{Vec3(0, 0, 2), 1}, glass(1.5)));
    EXPECT_FALSE(meet(SphereShape{Vec3(0, 0, 2), 1}, matte())) << "opaque things that touch in a point";
}

TEST(Contact, FollowsMaterialsThatChange) {
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{}, matte());
    add(scene, SphereShape{Vec3(0, 0, 1), 1}, matte());
    BuildSceneOptions options;
    options.find_solids = true;
    const Scene opaque = build_scene(scene, options);
    EXPECT_FALSE(opaque.data().any_contact);
    scene.materials.back().transparency = 1;
    EXPECT_TRUE(update_scene(opaque, scene).data().any_contact);
}

} // namespace
} // namespace glint::rendering
