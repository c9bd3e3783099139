// Every fault of meaning is found, with its place, its cause and its cure.

#include "scene_kit.h"

#include "scene/validate.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace glint::scene {
namespace {

using namespace kit;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// One of everything, each thing with a line of its own.
SceneDescription sound() {
    SceneDescription scene = empty_scene();
    scene.camera->where.line = 2;
    Material m = matte();
    m.name = "clay";
    m.where.line = 3;
    add(scene, PlaneShape{}, m);
    add(scene, SphereShape{}, "clay");
    add(scene, CylinderShape{}, "clay");
    add(scene, TriangleShape{{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, "clay");
    add(scene, PolyhedronShape{}, "clay");
    add(scene, mesh_of(box_mesh(Vec3(0), Vec3(1))), "clay").name = "box";
    add(scene, InstanceShape{"box"}, std::string());
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        scene.objects[i].where.line = 10 + static_cast<int>(i);
    scene.lights = {{AmbientLight{}, {}}, {PointLight{}, {}}, {DirectionalLight{}, {}}, {SpotLight{}, {}}};
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].where.line = 20 + static_cast<int>(i);
    return scene;
}

using Change = std::function<void(SceneDescription&)>;

template <class T>
T& shape(SceneDescription& scene, std::size_t object) {
    return std::get<T>(scene.objects[object].shape);
}
template <class T>
T& light(SceneDescription& scene, std::size_t i) {
    return std::get<T>(scene.lights[i].kind);
}

/// A fault: what breaks a sound scene, the line and the message that must come of it.
struct Fault {
    std::string message;
    int line;
    Change change;
};

void expect_found(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
        SceneDescription scene = sound();
        fault.change(scene);
        const std::vector<Diagnostic> found = find_errors(scene);
        ASSERT_EQ(found.size(), 1u) << fault.message << ", line " << fault.line;
        EXPECT_EQ(found[0].message, fault.message);
        EXPECT_EQ(found[0].location.line, fault.line) << fault.message;
        EXPECT_EQ(found[0].severity, Severity::error);
        EXPECT_FALSE(found[0].hint.empty()) << fault.message;
    }
}

void expect_sound(const Change& change) {
    SceneDescription scene = sound();
    change(scene);
    const std::vector<Diagnostic> found = find_errors(scene);
    EXPECT_TRUE(found.empty()) << found.at(0).message;
}

TEST(Validate, ASoundSceneHasNoFault) { EXPECT_TRUE(find_errors(sound()).empty()); }

TEST(Validate, FindsFaultsOfSettings) {
    using S = SceneDescription;
    const std::string size = "\"size\" must be between 1 and 65536, found ";
    const std::string spp = "\"spp\" must be between 1 and 1048576, found ";
    const std::string depth = "\"max_depth\" must be between 0 and 1000, found ";
    expect_found({
        {size + "0", 0, [](S& s) { s.render.width = 0; }},
        {size + "-1", 0, [](S& s) { s.render.height = -1; }},
        {size + "65537", 0, [](S& s) { s.render.width = 65537; }},
        {"\"size\" is above 2^30 pixels", 0, [](S& s) { s.render.width = s.render.height = 32769; }},
        {spp + "0", 0, [](S& s) { s.render.spp = 0; }},
        {spp + "1048577", 0, [](S& s) { s.render.spp = (1 << 20) + 1; }},
        {"unknown integrator number 9", 0, [](S& s) { s.render.integrator = Integrator(9); }},
        {"\"background\" must be at least 0, found -1", 0, [](S& s) { s.render.background.y = -1; }},
        {depth + "-1", 0, [](S& s) { s.whitted.max_depth = -1; }},
        {depth + "1001", 0, [](S& s) { s.whitted.max_depth = 1001; }},
        {"\"index\" must be above 0, found 0", 0, [](S& s) { s.whitted.index = 0; }},
    });
}

TEST(Validate, FindsFaultsOfCameras) {
    using S = SceneDescription;
    expect_found({
        {"\"eye\" must be finite, found nan", 2, [](S& s) { s.camera->eye.x = nan; }},
        {"\"eye\" must be between -1e+12 and 1e+12, found 1.1e+12", 2,
         [](S& s) { s.camera->eye.z = 1.1e12; }},
        {"\"up\" is parallel to the view", 2, [](S& s) { s.camera->up = Vec3(0, -3, 0); }},
        {"\"direction\" must not be zero", 2, [](S& s) { s.camera->direction = Vec3(0); }},
        {"\"fov\" must be above 0 and below 180, found 180", 2, [](S& s) { s.camera->fov = 180; }},
        {"\"fov\" must be above 0 and below 180, found 0", 2, [](S& s) { s.camera->fov = 0; }},
        {"\"fov\" must be finite, found nan", 2, [](S& s) { s.camera->fov = nan; }},
    });
}

TEST(Validate, FindsFaultsOfMaterials) {
    using S = SceneDescription;
    const auto m = [](S& s) -> Material& { return s.materials[0]; };
    const auto negative = [](const char* key) {
        return '"' + std::string(key) + "\" must be at least 0, found -1";
    };
    expect_found({
        {negative("color"), 3, [&](S& s) { m(s).color.z = -1; }},
        {"\"color\" must be finite, found nan", 3, [&](S& s) { m(s).color.z = nan; }},
        {"\"color\" must be finite, found inf", 3, [&](S& s) { m(s).color.z = infinity; }},
        {"\"emission\" must be between 0 and 3.4028234663852886e+38, found 1e+39", 3,
         [&](S& s) { m(s).emission.x = 1e39; }},
        {negative("absorption"), 3, [&](S& s) { m(s).absorption.y = -1; }},
        {negative("ambient"), 3, [&](S& s) { m(s).ambient = -1; }},
        {negative("diffuse"), 3, [&](S& s) { m(s).diffuse = -1; }},
        {negative("highlight"), 3, [&](S& s) { m(s).highlight = -1; }},
        {negative("shininess"), 3, [&](S& s) { m(s).shininess = -1; }},
        {negative("reflectivity"), 3, [&](S& s) { m(s).reflectivity = -1; }},
        {"\"transparency\" must be between 0 and 1, found 1.01", 3, [&](S& s) { m(s).transparency = 1.01; }},
        {"\"transparency\" must be finite, found nan", 3, [&](S& s) { m(s).transparency = nan; }},
        {"\"index\" must be above 0, found -1", 3, [&](S& s) { m(s).index = -1; }},
        {"\"index\" must be between 1.1754943508222875e-38 and 1e+12, found 1e-60", 3,
         [&](S& s) { m(s).index = 1e-60; }},
    });
    expect_sound([&](S& s) { m(s).reflectivity = 2.5; });
}

TEST(Validate, BalancedEnergyNeedsReflectionAndTransmissionWithinOne) {
    const auto change = [](double reflectivity) {
        return [=](SceneDescription& s) {
            s.whitted.energy = Energy::balanced;
            s.materials[0].transparency = 0.7;
            s.materials[0].reflectivity = reflectivity;
        };
    };
    expect_sound(change(0.3));
    expect_found({{"material \"clay\" has reflectivity + transparency = 1.01", 3, change(0.31)}});
}

TEST(Validate, FindsFaultsOfShapes) {
    using S = SceneDescription;
    const std::string length = " must be above 0 and at most 1e+12, found ";
    expect_found({
        {"\"normal\" must not be zero", 10, [](S& s) { shape<PlaneShape>(s, 0).normal = Vec3(0); }},
        {"\"offset\" must be finite, found inf", 10, [](S& s) { shape<PlaneShape>(s, 0).offset = infinity; }},
        {"\"center\" must be finite, found nan", 11, [](S& s) { shape<SphereShape>(s, 1).center.x = nan; }},
        {"\"radius\"" + length + "0", 11, [](S& s) { shape<SphereShape>(s, 1).radius = 0; }},
        {"\"base\" must be between -1e+12 and 1e+12, found -2e+12", 12,
         [](S& s) { shape<CylinderShape>(s, 2).base.x = -2e12; }},
        {"\"axis\" must not be zero", 12, [](S& s) { shape<CylinderShape>(s, 2).axis = Vec3(0); }},
        {"\"height\"" + length + "-1", 12, [](S& s) { shape<CylinderShape>(s, 2).height = -1; }},
        {"\"radius\" must be finite, found nan", 12, [](S& s) { shape<CylinderShape>(s, 2).radius = nan; }},
        {"\"vertices\" must be finite, found inf", 13,
         [](S& s) { shape<TriangleShape>(s, 3).vertices[1].y = infinity; }},
        {"the triangle is degenerate: its vertices lie on one line", 13,
         [](S& s) { shape<TriangleShape>(s, 3).vertices[2] = Vec3(2, 0, 0); }},
        {"\"size\"" + length + "0", 14, [](S& s) { shape<PolyhedronShape>(s, 4).size.z = 0; }},
        {"\"sides\" must be between 3 and 65536, found 2", 14,
         [](S& s) { shape<PolyhedronShape>(s, 4).sides = 2; }},
        {"the mesh is not loaded", 15, [](S& s) { shape<MeshShape>(s, 5).data = nullptr; }},
        {"\"scale\" must not be 0", 15, [](S& s) { shape<MeshShape>(s, 5).scale.y = 0; }},
        {"\"point_radius\"" + length + "-1", 15, [](S& s) { shape<MeshShape>(s, 5).point_radius = -1; }},
        {"the instance names no mesh of the scene", 16,
         [](S& s) {
             shape<InstanceShape>(s, 6).mesh = "bix";
             s.objects[6].material = "clay";
         }},
    });
}

TEST(Validate, FindsFaultsOfMeshes) {
    const auto with_mesh = [](const std::function<void(Mesh&)>& change) {
        return [=](SceneDescription& s) {
            Mesh mesh = *shape<MeshShape>(s, 5).data;
            change(mesh);
            shape<MeshShape>(s, 5).data = std::make_shared<const Mesh>(mesh);
        };
    };
    const float bad = std::numeric_limits<float>::infinity();
    expect_found({
        {"a vertex index of the mesh is out of range", 15,
         with_mesh([](Mesh& m) { m.triangles[3].y = static_cast<glm::uint>(m.positions.size()); })},
        {"the mesh has not one normal and one colour a vertex", 15,
         with_mesh([](Mesh& m) { m.normals.emplace_back(0, 0, 1); })},
        {"the mesh has not one normal and one colour a vertex", 15,
         with_mesh([](Mesh& m) { m.colors.resize(m.positions.size() + 1); })},
        {"a vertex of the mesh is not finite", 15, with_mesh([=](Mesh& m) { m.positions[2].z = bad; })},
        {"a vertex of the mesh is not finite", 15, with_mesh([=](Mesh& m) {
             m.triangles.clear();
             m.positions[2].z = bad;
         })},
    });
    expect_sound(with_mesh([=](Mesh& m) { m.positions.emplace_back(bad); }));
}

TEST(Validate, FindsUnknownMaterialsAndNamesTheNearest) {
    SceneDescription scene = sound();
    scene.objects[1].material = "clya";
    const std::vector<Diagnostic> found = find_errors(scene);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].message, "unknown material \"clya\"");
    EXPECT_EQ(found[0].hint, "did you mean \"clay\"?");
    EXPECT_EQ(found[0].location.line, 11);
}

TEST(Validate, FindsTransformsThatAreNotAffineAndRegular) {
    using S = SceneDescription;
    const std::string singular = "\"transform\" as a whole is not regular: it scales beyond all measure";
    const std::string projective = "\"transform\" is not affine: its last row must be 0, 0, 0, 1";
    expect_found({
        {singular, 11, [](S& s) { s.objects[1].transform[0] = glm::dvec4(0); }},
        {singular, 11,
         [](S& s) {
             s.objects[1].transform = Mat4(0.1, 0.4, 0.7, 0, 0.2, 0.5, 0.8, 0, 0.3, 0.6, 0.9, 0, 0, 0, 0, 1);
         }},
        {projective, 11, [](S& s) { s.objects[1].transform[0][3] = 0.1; }},
        {projective, 11, [](S& s) { s.objects[1].transform[3][3] = 2; }},
        {"\"transform\" must be finite, found nan", 11, [](S& s) { s.objects[1].transform[1][1] = nan; }},
    });
    expect_sound([](S& s) { s.objects[1].transform[0][0] = -1; });
}

TEST(Validate, FindsFaultsOfLights) {
    using S = SceneDescription;
    expect_found({
        {"\"color\" must be at least 0, found -1", 20, [](S& s) { light<AmbientLight>(s, 0).color.x = -1; }},
        {"\"position\" must be finite, found nan", 21,
         [](S& s) { light<PointLight>(s, 1).position.x = nan; }},
        {"\"intensity\" must be at least 0, found -1", 21,
         [](S& s) { light<PointLight>(s, 1).intensity = -1; }},
        {"the light is too strong", 21,
         [](S& s) {
             light<PointLight>(s, 1).intensity = 1e20;
             light<PointLight>(s, 1).color.x = 1e20;
         }},
        {"\"direction\" must not be zero", 22,
         [](S& s) { light<DirectionalLight>(s, 2).direction = Vec3(0); }},
        {"\"irradiance\" must be at least 0, found -1", 22,
         [](S& s) { light<DirectionalLight>(s, 2).irradiance = -1; }},
        {"\"direction\" must be finite, found nan", 23,
         [](S& s) { light<SpotLight>(s, 3).direction = Vec3(nan); }},
        {"\"angle\" must be above 0 and at most 90, found 0", 23,
         [](S& s) { light<SpotLight>(s, 3).angle = 0; }},
        {"\"angle\" must be above 0 and at most 90, found 91", 23,
         [](S& s) { light<SpotLight>(s, 3).angle = 91; }},
        {"\"blend\" must be between 0 and 1, found 1.1", 23,
         [](S& s) { light<SpotLight>(s, 3).blend = 1.1; }},
    });
    expect_sound([](S& s) {
        light<SpotLight>(s, 3).angle = 90;
        light<SpotLight>(s, 3).blend = 1;
    });
}

TEST(Validate, BuildSceneReportsAllErrorsTogether) {
    SceneDescription scene = sound();
    scene.render.spp = 0;
    shape<SphereShape>(scene, 1).radius = -1;
    light<SpotLight>(scene, 3).angle = 100;
    try {
        build_scene(scene);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        ASSERT_EQ(error.diagnostics().size(), 3u);
        EXPECT_EQ(error.diagnostics()[1].location.line, 11);
        EXPECT_NE(std::string(error.what()).find("\"radius\" must be above 0 and at most 1e+12, found -1"),
                  std::string::npos);
    }
}

} // namespace
} // namespace glint::scene
