// Solids around a ray: who owns the space, what is hidden in it (docs/light-model.md, "Solids, panes and
// nesting").

#include "scene_kit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::rendering {
namespace {

using namespace kit;

Material absorbing(double index, const Vec3& sigma) {
    Material m = glass(index);
    m.absorption = sigma;
    return m;
}

/// Two balls of radius 1 that share the lens |x| < .5, the first to the left; of different σ and index 1.
SceneDescription two_balls() {
    SceneDescription scene = in_sky();
    add(scene, SphereShape{Vec3(-0.5, 0, 0), 1}, absorbing(1, Vec3(1, 0, 0)));
    add(scene, SphereShape{Vec3(0.5, 0, 0), 1}, absorbing(1, Vec3(0, 1, 0)));
    return scene;
}

Look along_x(const SceneDescription& scene) { return look(scene, Vec3(-4, 0, 0), Vec3(1, 0, 0)); }

TEST(Nesting, TheLaterInTheFileOwnsTheSharedSpace) {
    const Look seen = along_x(two_balls());
    EXPECT_NEAR(seen.light.x, std::exp(-1.0), 1e-6);
    EXPECT_NEAR(seen.light.y, std::exp(-2.0), 1e-6);
    // In, into the second, out: the first one's far side is hidden.
    EXPECT_EQ(seen.tree.nodes.size(), 4u);
}

TEST(Nesting, TheHigherPriorityOwnsTheSharedSpace) {
    SceneDescription scene = two_balls();
    scene.objects[0].priority = 1;
    const Look seen = along_x(scene);
    EXPECT_NEAR(seen.light.x, std::exp(-2.0), 1e-6);
    EXPECT_NEAR(seen.light.y, std::exp(-1.0), 1e-6);
    scene.objects[1].priority = 1;
    EXPECT_NEAR(along_x(scene).light.x, std::exp(-1.0), 1e-6);
}

TEST(Nesting, IndicesComeFromTheOwnersOnBothSides) {
    SceneDescription scene = two_balls();
    material_of_object(scene, 0).index = 1.5;
    material_of_object(scene, 1).index = 1.2;
    const Look seen = along_x(scene);
    ASSERT_EQ(seen.tree.nodes.size(), 4u);
    const float expected[][2] = {{1, 1.5f}, {1.5f, 1.2f}, {1.2f, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(seen.node(i).index_before, expected[i][0]) << i;
        EXPECT_EQ(seen.node(i).index_after, expected[i][1]) << i;
    }
    scene.objects[0].priority = 1;
    const Look other = along_x(scene);
    EXPECT_EQ(other.node(1).index_before, 1.5f);
    EXPECT_EQ(other.node(1).index_after, 1.2f);
    EXPECT_GT(other.node(1).position.x, 0.4f);
}

TEST(Nesting, HiddenSurfacesShowNothingAndCostNothing) {
    SceneDescription scene = in_sky();
    Material inner = glass(1.7, 0.5);
    inner.color = Vec3(1);
    inner.ambient = 1;
    inner.emission = Vec3(5);
    inner.reflectivity = 0.5;
    add(scene, SphereShape{Vec3(0), 0.5}, inner);
    add(scene, SphereShape{Vec3(0), 1}, glass(1.5, 0.5));
    add_ambient(scene, Vec3(1));
    add_light(scene, Vec3(-4, 0, 4), 5);
    const Look seen = along_x(scene);
    EXPECT_EQ(seen.light, vec3(0.25f));
    EXPECT_EQ(seen.tree.nodes.size(), 3u);
}

TEST(Nesting, OpaqueThingsAreNeverHidden) {
    // Wholly in the glass, and with a half of it outside; whatever the order and the priorities.
    for (const double x : {0.0, -1.0})
        for (const bool first : {true, false})
            for (const int priority : {-1, 0, 1}) {
                SceneDescription scene = in_sky();
                add(scene, SphereShape{Vec3(x, 0, 0), 0.5}, lamp(Vec3(0.25))).priority = priority;
                add(scene, SphereShape{Vec3(0), 1}, glass(1));
                if (!first) std::swap(scene.objects[0], scene.objects[1]);
                EXPECT_EQ(along_x(scene).light, vec3(0.25f)) << x << first << priority;
            }
}

TEST(Nesting, ThingsInWaterThatStandsLaterInTheFileAreSeenUnderIt) {
    SceneDescription scene = empty_scene();
    add(scene, CylinderShape{Vec3(0, 0, -3), Vec3(0, 0, 1), 4, 0.5}, lamp(Vec3(1, 0, 0)));
    add(scene, DiskShape{Vec3(3, 0, -2), Vec3(0, 0, 1), 1}, lamp(Vec3(0, 1, 0)));
    add(scene, PlaneShape{Vec3(0, 0, 1), -3}, lamp(Vec3(0, 0, 1)));
    add(scene, PlaneShape{Vec3(0, 0, 1), 0, true}, absorbing(1, Vec3(0.5)));
    const double across = std::sqrt(1.25);
    EXPECT_NEAR(look(scene, Vec3(-1.5, 0, 1), Vec3(1, 0, -0.5)).light.x, 1, 1e-6) << "above the water";
    EXPECT_NEAR(look(scene, Vec3(-1.5, 0, 1), Vec3(0.5, 0, -1)).light.x, std::exp(-0.5 * across), 1e-6);
    EXPECT_NEAR(look(scene, Vec3(3, 0, 1), Vec3(0, 0, -1)).light.y, std::exp(-1.0), 1e-6);
    EXPECT_NEAR(look(scene, Vec3(5, 0, 1), Vec3(0, 0, -1)).light.z, std::exp(-1.5), 1e-6);
}

TEST(Nesting, PanesAreNeverHidden) {
    SceneDescription scene = in_sky();
    add(scene, PlaneShape{Vec3(1, 0, 0), 0}, glass(1, 0.5));
    add(scene, SphereShape{Vec3(0), 1}, glass(1.5));
    EXPECT_EQ(along_x(scene).light, vec3(0.5f));
}

TEST(Nesting, HiddenSurfacesAreNoShadowCrossings) {
    const auto share = [](int inner_priority) {
        SceneDescription scene = empty_scene();
        add(scene, PlaneShape{}, matte());
        add(scene, SphereShape{Vec3(0, 0, 2), 0.5}, glass(1.5, 0.5)).priority = inner_priority;
        add(scene, SphereShape{Vec3(0, 0, 2), 1}, glass(1.5, 0.5));
        add_light(scene, Vec3(0, 0, 4), 16);
        return look(scene, Vec3(0.1, 0, 0.2), Vec3(-0.1, 0, -0.2)).light.x;
    };
    EXPECT_FLOAT_EQ(share(0), 0.25f);
    EXPECT_FLOAT_EQ(share(1), 0.0625f);
}

TEST(Nesting, ShadowsFromInsideKnowWhatTheyAreIn) {
    // A matte plane in the middle of a big glass ball; a glass ball of lower rank inside it takes nothing of
    // the light.
    SceneDescription scene = empty_scene();
    add(scene, SphereShape{Vec3(0, 0, 1), 0.5}, glass(1.5, 0.5));
    add(scene, PlaneShape{}, matte());
    add(scene, SphereShape{Vec3(0), 3}, glass(1.5, 0.5));
    add_light(scene, Vec3(0, 0, 2), 4);
    EXPECT_FLOAT_EQ(look(scene, Vec3(0.1, 0, 0.2), Vec3(-0.1, 0, -0.2)).light.x, 1);
    scene.whitted.shadows = Shadows::opaque;
    EXPECT_FLOAT_EQ(look(scene, Vec3(0.1, 0, 0.2), Vec3(-0.1, 0, -0.2)).light.x, 1);
    scene.objects[0].priority = 1;
    EXPECT_EQ(look(scene, Vec3(0.1, 0, 0.2), Vec3(-0.1, 0, -0.2)).light.x, 0);
}

TEST(Nesting, LightOnTheBackOfAStoredFaceComesFromOutsideItsGlass) {
    // The far side of the box, met from inside, is lit through its back: something stands before that light.
    Material m = glass(1, 0.5);
    m.color = Vec3(1);
    m.diffuse = 1;
    SceneDescription scene = empty_scene();
    scene.whitted.max_depth = 1;
    add(scene, SphereShape{Vec3(3, 0, 0), 0.5}, matte());
    MeshShape box = mesh_of(box_mesh(Vec3(0), Vec3(2)));
    box.facing = Facing::stored;
    add(scene, box, m);
    add_light(scene, Vec3(5, 0.1, 0.2));
    const Look seen = look(scene, Vec3(-4, 0.1, 0.2), Vec3(1, 0, 0));
    const LightNode& light = seen.node(1).lights.at(0);
    EXPECT_GT(light.arriving.x, 0);
    EXPECT_EQ(light.shadow, 0);
    scene.objects[0].visible = false;
    EXPECT_EQ(look(scene, Vec3(-4, 0.1, 0.2), Vec3(1, 0, 0)).node(1).lights.at(0).shadow, 1);
}

TEST(Nesting, ADrinkThatOverlapsItsGlassMeetsItDirectly) {
    // From the air through glass into the drink and back: three kinds of crossing, and no air gap between.
    SceneDescription scene = in_sky();
    add(scene, CylinderShape{Vec3(0, 0, -1), Vec3(0, 0, 1), 2, 0.95}, absorbing(1.33, Vec3(1)));
    add(scene, CylinderShape{Vec3(0, 0, -1), Vec3(0, 0, 1), 2, 0.9}, glass(1));
    add(scene, CylinderShape{Vec3(0, 0, -1.1), Vec3(0, 0, 1), 2.2, 1}, glass(1.5)).priority = -1;
    const Look seen = along_x(scene);
    ASSERT_EQ(seen.tree.nodes.size(), 7u);
    const float expected[] = {1, 1.5f, 1.33f, 1, 1.33f, 1.5f};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(seen.node(i).index_before, expected[i]) << i;
    EXPECT_NEAR(seen.light.x, std::exp(-0.1), 1e-5);
}

TEST(CameraInside, StartsInItsGlass) {
    SceneDescription scene = in_sky();
    add(scene, SphereShape{}, absorbing(1.5, Vec3(1)));
    const Look seen = look(scene, Vec3(0.5, 0, 0), Vec3(-1, 0, 0));
    EXPECT_EQ(seen.node(0).interiors, std::vector<std::uint32_t>{0});
    EXPECT_FALSE(seen.node(0).entering);
    EXPECT_EQ(seen.node(0).index_before, 1.5f);
    EXPECT_NEAR(seen.light.x, std::exp(-1.5), 1e-6);
}

TEST(CameraInside, KnowsAllTheSolidsAroundItAndTheirOwner) {
    SceneDescription scene = two_balls();
    const Look seen = look(scene, Vec3(0.1, 0, 0), Vec3(1, 0, 0));
    EXPECT_EQ(seen.node(0).interiors, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(seen.node(0).hit.object, 1u);
    EXPECT_NEAR(seen.light.y, std::exp(-1.4), 1e-6);
    EXPECT_EQ(seen.light.x, 1);
}

TEST(CameraInside, EveryKindOfSolidIsFound) {
    const PolyhedronShape box{PolyhedronKind::box, Vec3(0), Vec3(2)};
    const CylinderShape cylinder{Vec3(0, 0, -1), Vec3(0, 0, 1), 2, 1};
    const ConeShape cone{Vec3(-2, 0, 0), Vec3(1, 0, 0), 3, 2};
    const PlaneShape ground{Vec3(1, 0, 0), 1, true};
    const MeshShape mesh = mesh_of(box_mesh(Vec3(0), Vec3(2)));
    for (const Shape& shape :
         {Shape(box), Shape(cylinder), Shape(cone), Shape(ground), Shape(mesh), Shape(SphereShape{})}) {
        SceneDescription scene = in_sky();
        add(scene, shape, absorbing(1.5, Vec3(1)));
        EXPECT_NEAR(look(scene, Vec3(0), Vec3(1, 0, 0)).light.x, std::exp(-1.0), 1e-6) << shape.index();
    }
}

TEST(CameraInside, AnOpaqueRoomIsNoMedium) {
    SceneDescription scene = in_sky();
    add(scene, SphereShape{Vec3(0), 10}, lamp(Vec3(0.5)));
    add(scene, SphereShape{Vec3(3, 0, 0), 1}, glass(1.5, 0.5));
    const Look seen = look(scene, Vec3(0), Vec3(1, 0, 0));
    EXPECT_EQ(seen.light, vec3(0.125f));
    // Whatever the room's rank, what light goes through stays visible in it.
    scene.objects[0].priority = 1;
    EXPECT_EQ(look(scene, Vec3(0), Vec3(1, 0, 0)).light, vec3(0.125f));
}

TEST(Solids, AMeshOfNegativeVolumeIsTurnedOutward) {
    Mesh outward = sphere_mesh(1, 12);
    outward.normals.clear();
    Mesh inward = outward;
    for (glm::uvec3& t : inward.triangles) std::swap(t.y, t.z);
    for (const Mesh& mesh : {outward, inward}) {
        SceneDescription scene = in_sky();
        add(scene, mesh_of(mesh), absorbing(1.5, Vec3(1)));
        const Look seen = look(scene, Vec3(-3, 0.31, 0.17), Vec3(1, 0, 0));
        ASSERT_EQ(seen.tree.nodes.size(), 3u);
        EXPECT_TRUE(seen.node(0).entering);
        EXPECT_FALSE(seen.node(1).entering);
        EXPECT_LT(seen.light.x, 0.3f);
    }
}

TEST(Solids, AMirroredMeshStaysASolid) {
    SceneDescription scene = in_sky();
    add(scene, mesh_of(sphere_mesh(1, 12)), absorbing(1, Vec3(1)));
    scene.objects[0].transform[0][0] = -1;
    const Look seen = look(scene, Vec3(-3, 0.31, 0.17), Vec3(1, 0, 0));
    EXPECT_TRUE(seen.node(0).entering);
    EXPECT_NEAR(seen.light.x, std::exp(-2 * std::sqrt(1 - 0.31 * 0.31 - 0.17 * 0.17)), 0.01);
}

TEST(Solids, ASolidPlaneIsTheHalfSpaceBehindItsNormal) {
    // Water below z = 0, seen from above: the floor one unit down is dimmed and looks nearer than it is.
    SceneDescription scene = empty_scene();
    add(scene, PlaneShape{Vec3(0, 0, 2), 0, true}, absorbing(1.33, Vec3(1)));
    add(scene, PlaneShape{Vec3(0, 0, 1), -1}, lamp(Vec3(1)));
    const Look seen = look(scene, Vec3(-1, 0, 1), Vec3(1, 0, -1));
    const double below = std::asin(std::sqrt(0.5) / 1.33);
    EXPECT_NEAR(seen.node(1).position.x, std::tan(below), 1e-6);
    EXPECT_NEAR(seen.light.x, std::exp(-1 / std::cos(below)), 1e-6);
    // And from inside.
    const Look under = look(scene, Vec3(0, 0, -0.5), Vec3(0, 0, -1));
    EXPECT_NEAR(under.light.x, std::exp(-0.5), 1e-6);
}

TEST(Solids, APointCloudOfGlassIsAUnion) {
    Mesh cloud;
    cloud.positions = {{0, 0, 0}, {1, 0, 0}};
    MeshShape shape = mesh_of(cloud);
    shape.point_radius = 1;
    SceneDescription scene = in_sky();
    add(scene, shape, absorbing(1, Vec3(1)));
    EXPECT_NEAR(along_x(scene).light.x, std::exp(-3.0), 1e-6);
}

} // namespace
} // namespace glint::rendering
