// -D path=value.

#include "scene_support.h"

#include "formats/scene/key_path.h"

namespace glint::test {
namespace {

constexpr const char* scene_text = R"([material.glass]
index = 1.5
[material."v1.2"]
[[sphere]]
name = "ball"
center = [0, 0, 0]
radius = 1
material = "glass"
[[mesh]]
name = "cat"
file = "cat.ply"
material = "glass"
[[sphere]]
name = "1"
center = [5, 0, 0]
radius = 2
material = "glass"
[[light]]
type = "point"
position = [0, 0, 9]
intensity = 1
[[light]]
type = "ambient"
)";

SceneDescription with(std::vector<Override> overrides) {
    return parse(scene_text, std::move(overrides)).description;
}

Diagnostic only_error(std::vector<Override> overrides, std::string_view text = scene_text) {
    const auto errors = errors_of(text, std::move(overrides));
    EXPECT_EQ(errors.size(), 1u);
    return errors.empty() ? Diagnostic{} : errors.front();
}

TEST(SceneOverrides, SetKeysOfTables) {
    EXPECT_EQ(with({"whitted.max_depth=3"}).whitted.max_depth, 3);
    EXPECT_EQ(with({"render.size=[10, 20]"}).render.height, 20);
    EXPECT_EQ(with({"render.filter=\"box\""}).render.filter, PixelFilter::box);
    EXPECT_EQ(with({"whitted.clamp = true"}).whitted.clamp, true);
}

TEST(SceneOverrides, MakeTablesThatTheFileLacks) {
    const auto camera = with({"camera.eye=[1,2,3]", "camera.look_at=[0,0,0]"}).camera;
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->eye, Vec3(1, 2, 3));
    EXPECT_EQ(camera->direction, Vec3(-1, -2, -3));
}

TEST(SceneOverrides, SetKeysOfTheTop) {
    const auto scene = parse("[material.m]\ncolor = \"#808080\"\n", {"color_values=linear", "version=1"});
    EXPECT_EQ(scene.description.materials[0].color, Vec3(128 / 255.0));
}

TEST(SceneOverrides, FindTablesByName) {
    EXPECT_EQ(with({"material.glass.index=1.33"}).materials[0].index, 1.33);
    EXPECT_EQ(with({"material.v1.2.index=1.25"}).materials[1].index, 1.25);
    EXPECT_EQ(with({"material.\"v1.2\".index=1.25"}).materials[1].index, 1.25);
    EXPECT_EQ(std::get<SphereShape>(with({"sphere.ball.radius=7"}).objects[0].shape).radius, 7);
    EXPECT_EQ(std::get<MeshShape>(with({"mesh.cat.file=other.ply"}).objects[1].shape).file, "other.ply");
}

TEST(SceneOverrides, FindTablesByNumberWithinTheirTypeUnlessThatIsAName) {
    EXPECT_EQ(std::get<PointLight>(with({"light.0.intensity=500"}).lights[0].kind).intensity, 500);
    EXPECT_EQ(std::get<AmbientLight>(with({"light.1.color=[1,2,3]"}).lights[1].kind).color, Vec3(1, 2, 3));
    EXPECT_EQ(std::get<SphereShape>(with({"sphere.0.radius=7"}).objects[0].shape).radius, 7);
    EXPECT_EQ(std::get<SphereShape>(with({"sphere.1.radius=7"}).objects[2].shape).radius, 7);
}

TEST(SceneOverrides, FindEachOfVeryManyTablesByName) {
    using namespace formats;
    constexpr std::size_t count = 100000;
    const SceneSource source({}, "many.toml", {});
    Problems problems(source);
    TreeValue root;
    root.entries.push_back({"sphere", {}, {}});
    std::vector<TreeValue>& spheres = root.entries[0].value.items;
    for (std::size_t i = 0; i < count; ++i) {
        TreeValue name;
        name.kind = TreeValue::Kind::text;
        name.text = "ball " + std::to_string(i);
        spheres.emplace_back().entries.push_back({"name", {}, std::move(name)});
    }
    KeyPaths paths(root, problems);
    for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(paths.find("sphere.ball " + std::to_string(i) + ".radius", {}).table, &spheres[i]);
    // Names change as other values do.
    paths.put(paths.find("sphere.3.name", {}), read_value("nine", {}), {});
    EXPECT_EQ(paths.find("sphere.nine.radius", {}).table, &spheres[3]);
    EXPECT_EQ(paths.find("sphere.ball 3.radius", {}).table, nullptr);
}

TEST(SceneOverrides, AddKeysThatTheTableLacks) {
    EXPECT_EQ(with({"sphere.ball.priority=2"}).objects[0].priority, 2);
    EXPECT_EQ(with({"sphere.ball.transform=[{ translate = [1, 0, 0] }]"}).objects[0].transform[3].x, 1);
    EXPECT_TRUE(with({"material.glass.fresnel=true"}).materials[0].fresnel);
}

TEST(SceneOverrides, TheLaterWins) {
    EXPECT_EQ(with({"whitted.max_depth=3", "whitted.max_depth=5"}).whitted.max_depth, 5);
}

TEST(SceneOverrides, ObjectsKeepTheirOrder) {
    const auto d = with({"sphere.1.radius=7", "mesh.cat.scale=2"});
    EXPECT_TRUE(std::holds_alternative<MeshShape>(d.objects[1].shape));
    EXPECT_EQ(d.objects[2].name, "1");
}

TEST(SceneOverrides, WhatIsNotTomlIsText) {
    EXPECT_EQ(with({"render.integrator=whitted"}).render.integrator, Integrator::whitted);
    EXPECT_EQ(with({"material.glass.color=white"}).materials[0].color, Vec3(1));
    EXPECT_EQ(with({"material.glass.color=#fff"}).materials[0].color, Vec3(1));
    EXPECT_EQ(with({"mesh.cat.file=a=b c.ply"}).objects.size(), 3u);
    EXPECT_EQ(std::get<MeshShape>(with({"mesh.cat.file=../a=b c.ply"}).objects[1].shape).file,
              "../a=b c.ply");
}

TEST(SceneOverrides, MendAFileThatIsWrong) {
    EXPECT_TRUE(errors_of("[whitted]\nmax_depth = -1\n", {"whitted.max_depth=3"}).empty());
    EXPECT_TRUE(errors_of("[camera]\nlook_at = [0,0,0]\n", {"camera.eye=[0,1,0]"}).empty());
}

TEST(SceneOverrides, ErrorsNameTheOverride) {
    const auto error = only_error({"whitted.clamp=true", "sphere.ball.radius=-1"});
    EXPECT_EQ(error.location, (Location{"-D sphere.ball.radius=-1", 0, 0, {}}));
    EXPECT_EQ(error.message, "\"radius\" must be above 0 and at most 1e+12, found -1");
    EXPECT_EQ(error.excerpt, "");
    EXPECT_EQ(to_string(error),
              "-D sphere.ball.radius=-1: error: \"radius\" must be above 0 and at most 1e+12, found -1");
}

TEST(SceneOverrides, PathsThatLeadNowhereAreErrors) {
    const struct {
        const char* text;
        const char* message;
        const char* hint;
    } cases[] = {
        {"whited.max_depth=3", "unknown table \"whited\"", "did you mean \"whitted\"?"},
        {"whitted.depth=3", "unknown key \"depth\" in [whitted]", "max_depth"},
        {"colour_values=linear", "unknown key \"colour_values\"", "did you mean \"color_values\"?"},
        {"camera=3", "\"camera\" is a table, not a value", "camera.eye=…"},
        {"whitted.a.b=3", "[whitted] has no parts named \"a\"", "whitted.max_depth=…"},
        {"material.glas.index=1", "no material \"glas\"", "did you mean \"glass\"?"},
        {"sphere.bal.radius=1", "no sphere \"bal\"", "did you mean \"ball\"?"},
        {"sphere.radius=1", "which \"sphere\"?", "sphere.ball.radius=…"},
        {"light.intensity=3", "which \"light\"?", "the scene has 2, numbered from 0: light.0.intensity=…"},
        {"sphere.ball=3", "\"sphere.0\" is a table, not a value", "sphere.0."},
        {"light.0.intensity=1e400", "the number 1e400 is out of range", "1.8e308"},
        {"light.0.intensity=.5", "\".5\" begins with a point", "write 0.5"},
        {"sphere.ball.center=1,2,3", "a list without brackets", "[1, 2, 3]"},
        {"light.2.intensity=1", "no light \"2\"", "the scene has 2, numbered from 0"},
        {"light.-1.intensity=1", "no light \"-1\"", "numbered from 0"},
        {"plane.0.offset=1", "no plane \"0\"", "the scene has no plane"},
        {"transform.0.angle=1", "unknown table \"transform\"", ""},
        {"sphere.ball.blend=1", "unknown key \"blend\" in [[sphere]]", ""},
        {"light.1.intensity=1", "key \"intensity\" does not belong to [[light]] with type = \"ambient\"", ""},
        {"light.0.radiant_intensity=1", "\"radiant_intensity\" cannot go together with \"intensity\"", ""},
        {"whitted.max_depth=abc", "expected an integer for \"max_depth\", found a string", ""},
        {"whitted.max_depth=3\nclamp = true", "expected an integer for \"max_depth\", found a string", ""},
        {"sphere.ball.material=glas", "unknown material \"glas\"", "did you mean \"glass\"?"},
        {"=3", "unknown key \"\"", ""},
        {"sphere.ball.=3", "unknown key \"\" in [[sphere]]", ""},
    };
    for (const auto& c : cases) {
        SCOPED_TRACE(c.text);
        const auto error = only_error({c.text});
        EXPECT_EQ(error.location.file, "-D " + std::string(c.text));
        EXPECT_NE(error.message.find(c.message), std::string::npos) << error.message;
        EXPECT_NE(error.hint.find(c.hint), std::string::npos) << error.hint;
    }
}

TEST(SceneOverrides, WithoutACameraAnEyeLooksAtTheMiddle) {
    const auto scene = [](std::vector<std::string> overrides) {
        return parse("material.m.color = \"red\"\n[[sphere]]\ncenter = [1, 2, 3]\nradius = 1\nmaterial = "
                     "\"m\"\n",
                     std::move(overrides))
            .description;
    };
    const auto camera = scene({"camera.eye=[1,-4,3]"}).camera;
    ASSERT_TRUE(camera);
    EXPECT_LT(glm::length(camera->direction - Vec3(0, 6, 0)), 1e-12);
    EXPECT_EQ(scene({"camera.eye=[1,2,9]"}).camera->up, Vec3(0, 1, 0)) << "not along the view";

    const auto framed = scene({"camera.direction=[0,0,-1]", "camera.fov=20"});
    ASSERT_FALSE(framed.camera);
    EXPECT_EQ(fit_camera(framed).direction, Vec3(0, 0, -1));
    EXPECT_EQ(fit_camera(framed).fov, 20);
}

TEST(SceneOverrides, WithoutAnEqualsSignTheUsageIsWrong) {
    try {
        parse("", {"whitted.max_depth"});
        FAIL() << "accepted an override without a value";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(error.diagnostics()[0].message.find("-D whitted.max_depth has no value"),
                  std::string::npos);
    }
}

} // namespace
} // namespace glint::test
