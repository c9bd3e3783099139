// [[animate]]: what moves, how, and what is wrong with it.

#include "document_support.h"

namespace glint::test {
namespace {

constexpr const char* still = R"([camera]
eye = [0, -10, 2]
look_at = [0, 0, 0]
[material.red]
color = "crimson"
index = 1.5
[[sphere]]
name = "ball"
center = [0, 0, 0]
radius = 1
material = "red"
transform = [{ translate = [1, 0, 0] }, { rotate = [0, 0, 1], angle = 0 }]
[[light]]
type = "point"
position = [3, -4, 5]
)";

std::string animated(const std::string& key, const std::string& frames, const std::string& values,
                     const std::string& rest = {}) {
    return std::string(still) + "[[animate]]\nkey = \"" + key + "\"\nframes = " + frames +
           "\nvalues = " + values + "\n" + rest;
}

SceneDescription moved(const std::string& text, double frame, std::vector<Override> overrides = {}) {
    return scene_at(parse(text, std::move(overrides)), frame);
}

/// A frame is the still scene with these overrides.
void expect_as(const std::string& text, double frame, const std::vector<Override>& overrides) {
    EXPECT_EQ(scene_text(moved(text, frame)), meaning(still, overrides)) << text;
}

TEST(Animation, WithoutACameraOneCameraShowsAllFrames) {
    const auto scene = parse_scene(R"(material.m.color = "red"
[[sphere]]
name = "s"
center = [0, 0, 0]
radius = 1
material = "m"
[[animate]]
key = "sphere.s.center"
frames = [0, 10]
values = [[0, 0, 0], [5, 0, 0]]
)",
                                   "moving.toml");
    SceneDescription both = scene.description;
    both.framing.moments = nullptr;
    both.objects.push_back(both.objects[0]);
    std::get<SphereShape>(both.objects[1].shape).center = Vec3(5, 0, 0);
    const CameraDescription camera = fit_camera(both);
    EXPECT_EQ(fit_camera(scene.description).eye, camera.eye);
    for (const double frame : {0.0, 5.0, 10.0}) EXPECT_EQ(fit_camera(scene_at(scene, frame)).eye, camera.eye);
}

TEST(Animate, MovesEveryKindOfKey) {
    expect_as(animated("camera.eye", "[0, 10]", "[[0, -10, 2], [10, -10, 4]]"), 5,
              {"camera.eye=[5, -10, 3]"});
    expect_as(animated("sphere.ball.radius", "[0, 10]", "[1, 3]"), 2.5, {"sphere.0.radius=1.5"});
    expect_as(animated("light.0.intensity", "[0, 4]", "[0, 8]"), 3, {"light.0.intensity=6"});
    expect_as(animated("material.red.color", "[0, 2]", "[\"black\", [1, 0.5, 0]]"), 1,
              {"material.red.color=[0.5, 0.25, 0]"});
    expect_as(animated("sphere.ball.transform.1.angle", "[0, 8]", "[0, 360]"), 2,
              {"sphere.ball.transform.1.angle=90"});
    expect_as(
        animated(
            "sphere.ball.transform", "[0, 2]",
            "[[{ scale = 1 }, { rotate = [0, 0, 1], angle = 0 }], [{ scale = [3, 1, 1] }, { rotate = [0, 0, "
            "1], angle = 90 }]]"),
        1, {"sphere.ball.transform=[{ scale = [2, 1, 1] }, { rotate = [0, 0, 1], angle = 45 }]"});
    expect_as(animated("whitted.max_depth", "[0, 4]", "[0, 8]"), 2.3, {"whitted.max_depth=5"});
    expect_as(animated("whitted.clamp", "[0, 4]", "[false, true]"), 4, {"whitted.clamp=true"});
    expect_as(animated("whitted.shadows", "[0, 4]", "[\"transmissive\", \"opaque\"]"), 3.9, {});
    expect_as(animated("render.background", "[0, 4]", "[\"black\", \"white\"]", "interpolation = \"step\"\n"),
              5, {"render.background=white"});
}

TEST(Animate, LeavesTheSceneAsItStandsUntilAFrameIsAskedFor) {
    const LoadedScene scene = parse(animated("sphere.ball.radius", "[0, 10]", "[2, 3]"));
    EXPECT_EQ(scene_text(scene.description), meaning(still));
    EXPECT_EQ(scene.animation.keys, std::vector<std::string>{"sphere.ball.radius"});
    EXPECT_EQ(scene.animation.first, 0);
    EXPECT_EQ(scene.animation.last, 10);
    EXPECT_TRUE(parse(still).animation.keys.empty());
    EXPECT_EQ(scene_text(moved(still, 7)), meaning(still));
}

TEST(Animate, AnimationTellsTheFramesThereAre) {
    const auto animation = parse("[animation]\nframes = [10, 25]\nfps = 12.5\n").animation;
    EXPECT_EQ(animation.first, 10);
    EXPECT_EQ(animation.last, 25);
    EXPECT_EQ(animation.fps, 12.5);
}

TEST(Animate, OverridesHaveTheLastWord) {
    const std::string text = animated("sphere.ball.radius", "[0, 10]", "[2, 3]");
    EXPECT_EQ(scene_text(moved(text, 5, {"sphere.ball.radius=9"})), meaning(still, {"sphere.ball.radius=9"}));
    EXPECT_EQ(scene_text(moved(text, 5, {"animate.0.frames=[0, 20]", "animate.0.values=[0.5, 2.5]"})),
              meaning(still, {}));
}

TEST(Animate, KeepsTheMeshesOfAllFramesTheSame) {
    const TemporaryFolder folder;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
        "0\n0 1 1\n3 0 1 2\n";
    folder.write("a.ply", ply);
    folder.write("b.ply", ply);
    const std::string path = folder.write(
        "s.toml", "[material.m]\n[[mesh]]\nname = \"a\"\nfile = \"a.ply\"\nmaterial = \"m\"\n"
                  "[[mesh]]\nname = \"b\"\nfile = \"a.ply\"\nmaterial = \"m\"\n"
                  "[[animate]]\nkey = \"mesh.b.file\"\nframes = [0, 5]\nvalues = [\"a.ply\", \"b.ply\"]\n");
    const LoadedScene scene = load_scene(path);
    EXPECT_EQ(scene.files.size(), 3u) << "those of all frames";
    const SceneDescription early = scene_at(scene, 0), late = scene_at(scene, 5);
    const auto mesh = [](const SceneDescription& d, std::size_t i) {
        return std::get<MeshShape>(d.objects[i].shape).data;
    };
    EXPECT_EQ(mesh(early, 0), mesh(scene.description, 0));
    EXPECT_EQ(mesh(late, 0), mesh(early, 0));
    EXPECT_EQ(mesh(early, 1), mesh(early, 0));
    EXPECT_NE(mesh(late, 1), mesh(late, 0));
}

TEST(Animate, WhatIsWrongIsSaidWhereItIs) {
    const struct {
        std::string text;
        const char* message;
        const char* hint;
        int line;
    } cases[] = {
        {animated("camera.eyes", "[0]", "[1]"), "unknown key \"eyes\" in [camera]", "did you mean \"eye\"?",
         17},
        {animated("sphere.bal.radius", "[0]", "[1]"), "no sphere \"bal\"", "did you mean \"ball\"?", 17},
        {animated("camra.eye", "[0]", "[1]"), "unknown table \"camra\"", "did you mean \"camera\"?", 17},
        {animated("version", "[0]", "[1]"), "\"version\" does not move", "", 17},
        {animated("light.0.type", "[0]", "[\"spot\"]"), "\"light.0.type\" does not move", "", 17},
        {animated("animate.0.loop", "[0]", "[true]"), "\"animate.0.loop\" does not move", "", 17},
        {animated("sphere.0.radius", "[0, 5, 5]", "[1, 2, 3]"), "\"frames\" must ascend, found 5 after 5",
         "sort", 18},
        {animated("sphere.0.radius", "[]", "[]"), "\"frames\" must not be empty", "", 18},
        {animated("sphere.0.radius", "[0, 5]", "[1]"), "1 value for 2 frames", "one value is needed", 19},
        {animated("sphere.0.radius", "[0, 5]", "[1, -2]"), "\"radius\" must be above 0", "", 19},
        {animated("sphere.0.radius", "[0, 5]", "[1, \"x\"]"), "expected a number for \"radius\"", "", 19},
        {animated("sphere.0.center", "[0]", "[[1, 2]]"), "expected a list of 3 numbers", "", 19},
        {animated("material.red.color", "[0]", "[\"crimsn\"]"), "unknown colour \"crimsn\"", "crimson", 19},
        {animated("sphere.0.visible", "[0]", "[true]", "interpolation = \"smooth\"\n"),
         "\"sphere.0.visible\" has no values in between", "step", 20},
        {animated("sphere.0.radius", "[0]", "[1]", "interpolation = \"smoth\"\n"), "unknown interpolation",
         "smooth", 20},
        {animated("sphere.0.transform", "[0, 1]", "[[{ scale = 1 }], [{ translate = [1, 0, 0] }]]"),
         "the way from one form of \"transform\" to another is not known", "step", 19},
        {animated("sphere.0.radius", "[0]", "[1]", "framse = 3\n"), "unknown key \"framse\" in [[animate]]",
         "frames", 20},
        {std::string(still) + "[[animate]]\nkey = \"camera.fov\"\n[animation]\nfps = 1\n",
         "missing required key \"frames\"", "", 16},
        {"[animation]\nframes = [5, 2]\n", "the last of \"frames\" comes before the first", "", 2},
        {"[animation]\nfps = 0\n", "\"fps\" must be above 0", "", 2},
    };
    for (const auto& c : cases) {
        const auto errors = errors_of(c.text);
        ASSERT_FALSE(errors.empty()) << c.text;
        EXPECT_NE(errors.front().message.find(c.message), std::string::npos) << errors.front().message;
        EXPECT_NE(errors.front().hint.find(c.hint), std::string::npos) << errors.front().hint;
        EXPECT_EQ(errors.front().location.line, c.line) << errors.front().message;
    }
}

TEST(Animate, AFrameTakesNoLongerWhereKeyframesAreMany) {
    constexpr int count = 100000;
    std::string frames = "[", values = "[";
    for (int i = 0; i < count; ++i) {
        frames += std::to_string(i) + ", ";
        values += std::to_string(1 + i % 7) + ", ";
    }
    const auto scene = parse(animated("sphere.ball.radius", frames + "]", values + "]"));
    for (int frame = 0; frame < count; frame += 50)
        ASSERT_EQ(std::get<SphereShape>(scene_at(scene, frame).objects[0].shape).radius, 1 + frame % 7);
}

TEST(Animate, AFaultOfOneFrameNamesTheFrame) {
    const std::string text = animated("camera.eye", "[0, 10]", "[[0, -10, 2], [0, 10, -2]]");
    EXPECT_NO_THROW(moved(text, 4));
    try {
        moved(text, 5);
        FAIL() << "the eye is where it looks";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("frame 5: \"look_at\" is where the \"eye\" is"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Animate, DocumentsEditKeyframes) {
    SceneDocument edited = document(animated("sphere.0.radius", "[0, 5]", "[1, 2] # big", "loop = true\n"));
    edited.set("animate.0.values", "[1, 3]");
    EXPECT_EQ(edited.text(), animated("sphere.0.radius", "[0, 5]", "[1, 3] # big", "loop = true\n"));
    EXPECT_THROW(edited.set("animate.0.values", "[1]"), Error);
}

} // namespace
} // namespace glint::test
