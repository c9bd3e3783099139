// SceneDocument: values change where they stand, everything else keeps its bytes.

#include "document_support.h"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

std::string set_in(const std::string& text, std::string_view path, std::string_view value) {
    SceneDocument edited = document(text);
    edited.set(path, value);
    return edited.text();
}

TEST(SceneDocument, ItsChangesAreOverridesThatSayTheSame) {
    const std::string text = "[whitted]\nmax_depth = 3\n[material.red]\ncolor = [1, 0, 0]\n";
    SceneDocument edited = document(text);
    EXPECT_TRUE(edited.changes().empty());
    edited.set("material.red.index", 1.25);
    edited.set("whitted.max_depth", 5);
    edited.set("render.filter", "tent");
    edited.set("whitted.max_depth", 7);
    SceneDocument again = document(text);
    again.set_all(edited.changes());
    EXPECT_EQ(again.text(), edited.text());
    EXPECT_EQ(edited.changes().size(), 3u);
    edited.set("whitted.max_depth", 3);
    EXPECT_EQ(edited.changes().size(), 2u) << "what is as the file has it is no change";
}

// ── Replacing and inserting ────────────────────────────────────────────────────────────────────────────────

TEST(SceneDocument, ReplacesTheCharactersOfAValueAlone) {
    const std::string text = "[whitted] # how\n  max_depth=3# deep\n\tclamp  =  false\r\n";
    EXPECT_EQ(set_in(text, "whitted.max_depth", "12"),
              "[whitted] # how\n  max_depth=12# deep\n\tclamp  =  false\r\n");
    EXPECT_EQ(set_in(text, "whitted.clamp", "true"),
              "[whitted] # how\n  max_depth=3# deep\n\tclamp  =  true\r\n");
}

TEST(SceneDocument, InsertsAKeyBehindTheOthersOfItsTable) {
    EXPECT_EQ(set_in("[whitted]\n  clamp = true # c\n# end\n[render]\nspp = 1\n", "whitted.max_depth", "2"),
              "[whitted]\n  clamp = true # c\n  max_depth = 2\n# end\n[render]\nspp = 1\n");
    EXPECT_EQ(set_in("[whitted]\r\n[render]\r\n", "whitted.max_depth", "2"),
              "[whitted]\r\nmax_depth = 2\r\n[render]\r\n");
    EXPECT_EQ(set_in("[whitted]", "whitted.max_depth", "2"), "[whitted]\nmax_depth = 2");
}

TEST(SceneDocument, AddsTablesThatAreMissing) {
    EXPECT_EQ(set_in("", "render.spp", "9"), "[render]\nspp = 9\n");
    EXPECT_EQ(set_in("[whitted]\nclamp = true", "render.spp", "9"),
              "[whitted]\nclamp = true\n\n[render]\nspp = 9\n");
}

TEST(SceneDocument, InsertsKeysOfTheTopBeforeTheFirstTable) {
    EXPECT_EQ(set_in("# title\n\n[render]\n", "color_values", "linear"),
              "# title\ncolor_values = \"linear\"\n\n[render]\n");
    EXPECT_EQ(set_in("version = 1 # v\n[render]\n", "color_values", "linear"),
              "version = 1 # v\ncolor_values = \"linear\"\n[render]\n");
}

TEST(SceneDocument, KeepsTheWritingOfDottedAndInlineTables) {
    EXPECT_EQ(set_in("whitted.clamp = true # c\n", "whitted.max_depth", "2"),
              "whitted.clamp = true # c\nwhitted.max_depth = 2\n");
    EXPECT_EQ(set_in("whitted = { clamp = true }\n", "whitted.max_depth", "2"),
              "whitted = { clamp = true, max_depth = 2 }\n");
    EXPECT_EQ(set_in("whitted = {}", "whitted.max_depth", "2"), "whitted = { max_depth = 2 }");
    EXPECT_EQ(set_in("material = { red.index = 2, blue = {} }\n", "material.red.diffuse", "0.5"),
              "material = { red.index = 2, red.diffuse = 0.5, blue = {} }\n");
}

TEST(SceneDocument, KeepsAByteOrderMark) {
    EXPECT_EQ(set_in("\xef\xbb\xbf[whitted]\nmax_depth = 3\n", "whitted.max_depth", "4"),
              "\xef\xbb\xbf[whitted]\nmax_depth = 4\n");
}

TEST(SceneDocument, WritesTextBetweenQuotesAndLeavesCommentsOfTheValueAway) {
    const std::string text = "[render]\nfilter = 'box'\n";
    EXPECT_EQ(set_in(text, "render.filter", "tent"), "[render]\nfilter = \"tent\"\n");
    EXPECT_EQ(set_in(text, "render.spp", " 4  # much "), "[render]\nfilter = 'box'\nspp = 4\n");
}

TEST(SceneDocument, ReachesEntriesOfATransform) {
    SceneDocument edited = document(odd_scene);
    edited.set("sphere.ball.transform.1.angle", 45.5);
    EXPECT_EQ(edited.value("sphere.0.transform.1.angle"), "45.5");
    EXPECT_EQ(edited.value("sphere.0.transform.0.translate"), "[1, 0, 0]");
    EXPECT_EQ(edited.value("sphere.0.transform.2.angle"), std::nullopt);
}

TEST(SceneDocument, TellsTheNumbersOfAValue) {
    const SceneDocument read = document(odd_scene);
    EXPECT_EQ(read.numbers("sphere.ball.transform.0.translate"), (std::vector<double>{1, 0, 0}));
    EXPECT_EQ(read.numbers("sphere.ball.radius").size(), 1u);
    EXPECT_TRUE(read.numbers("sphere.ball.material").empty());
    EXPECT_TRUE(read.numbers("sphere.ball.transform").empty());
    EXPECT_TRUE(read.numbers("sphere.ball.transform.9.translate").empty());
}

TEST(SceneDocument, MakesListsLongerAndKeepsTheirComments) {
    const std::string before = "[material.m]\n[[sphere]]\nname = \"a\"\ncenter = [0, 0, 0]\nradius = 1\n"
                               "material = \"m\"\n";
    const auto longer = [&](const std::string& list) {
        SceneDocument edited = document(before + list);
        const auto text = edited.longer_list("sphere.a.transform", "{ translate = [1, 2, 3] }");
        if (!text) return std::string("none");
        edited.set("sphere.a.transform", *text);
        edited.set("sphere.a.transform.1.translate", Vec3(4, 5, 6));
        return edited.text().substr(before.size());
    };
    EXPECT_EQ(longer("transform = [{ scale = 2 }] # big\n"),
              "transform = [{ scale = 2 }, { translate = [4, 5, 6] }] # big\n");
    EXPECT_EQ(longer("transform = [\n  { scale = 2 }, # big\n]\n"),
              "transform = [\n  { scale = 2 }, { translate = [4, 5, 6] }, # big\n]\n");
    EXPECT_EQ(longer("[[sphere.transform]]\nscale = 2\n"), "none");
    SceneDocument bare = document(before);
    EXPECT_EQ(bare.longer_list("sphere.a.transform", "{ scale = 2 }"), "[{ scale = 2 }]");
}

// ── Undo and going back ────────────────────────────────────────────────────────────────────────────────────

TEST(SceneDocument, WhatIsSetBackGetsTheCharactersOfTheFile) {
    SceneDocument edited = document(odd_scene);
    edited.set("light.0.intensity", 7.5);
    edited.set("light.0.intensity", 8);
    EXPECT_TRUE(edited.changed());
    edited.set("light.0.intensity", 40.0);
    EXPECT_EQ(edited.text(), odd_scene);
    EXPECT_FALSE(edited.changed());
}

TEST(SceneDocument, CopiesAreUndo) {
    SceneDocument edited = document(odd_scene);
    const SceneDocument before = edited;
    edited.set("whitted.shadows", "opaque");
    EXPECT_NE(edited.text(), odd_scene);
    edited = before;
    EXPECT_EQ(edited.text(), odd_scene);
}

// ── Refusing ───────────────────────────────────────────────────────────────────────────────────────────────

TEST(SceneDocument, RefusesWhatAnOverrideWouldAndChangesNothing) {
    for (const char* wrong : {"whitted.max_depth=-1", "whitted.max_depth=4.0", "whited.max_depth=1",
                              "sphere.ball.blend=1", "material.red.reflectivty=1", "light.7.intensity=1",
                              "sphere.ball.material=gold", "camera.eye=[0,0]", "camera.direction=[0,1,0]",
                              "sphere.ball.transform.5.angle=3", "whitted.max_depth=[", "camera=3"}) {
        SceneDocument edited = document(odd_scene);
        std::string as_override, as_edit;
        try {
            meaning(odd_scene, {wrong});
        } catch (const Error& error) {
            as_override = error.what();
        }
        const std::string text = wrong;
        const std::size_t equals = text.find('=');
        try {
            edited.set(text.substr(0, equals), text.substr(equals + 1));
        } catch (const Error& error) {
            as_edit = error.what();
        }
        EXPECT_NE(as_override, "") << wrong;
        EXPECT_EQ(as_edit, as_override);
        EXPECT_EQ(edited.text(), odd_scene);
    }
}

TEST(SceneDocument, SetsTogetherWhatAloneIsWrong) {
    SceneDocument edited = document("[[light]]\ntype = \"ambient\"\n");
    EXPECT_THROW(edited.set("light.0.type", "point"), Error);
    edited.set_all({"light.0.type=point", "light.0.position=[1, 2, 3]"});
    EXPECT_EQ(edited.text(), "[[light]]\ntype = \"point\"\nposition = [1, 2, 3]\n");
}

TEST(SceneDocument, RefusesTextThatIsNoToml) { EXPECT_THROW(document("[camera\n"), Error); }

// ── The camera ─────────────────────────────────────────────────────────────────────────────────────────────

TEST(SceneDocument, SetsACamera) {
    CameraDescription camera;
    camera.eye = {1, 2, 3};
    camera.direction = {0.1, 0.2, -0.3};
    camera.fov = 33.3;
    camera.fov_axis = FovAxis::larger;
    for (const char* text : {"", "[camera]\ndirection=[1,0,0]\neye=[0,0,0]\n", odd_scene}) {
        SceneDocument edited = document(text);
        edited.set_camera(camera);
        const auto read = parse(edited.text()).description.camera.value();
        EXPECT_EQ(read.eye, camera.eye);
        EXPECT_LT(glm::length(read.direction - camera.direction), 1e-15);
        EXPECT_EQ(read.fov, camera.fov);
        EXPECT_EQ(read.fov_axis, camera.fov_axis);
        const std::string once = edited.text();
        edited.set_camera(read);
        EXPECT_EQ(edited.text(), once);
    }
}

// ── Files ──────────────────────────────────────────────────────────────────────────────────────────────────

constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n";

TEST(SceneDocument, SavesIntoTheFileAndKeepsWhatOthersChangedThere) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.toml", "[whitted]\nmax_depth = 3\n");
    SceneDocument edited = SceneDocument::open(path);
    edited.set("whitted.max_depth", 5);
    edited.set("render.spp", 2);
    folder.write("a.toml", "# note\n[render]\nseed = 9\n[whitted]\nmax_depth = 4 # four\n");
    edited.save();
    const std::string expected = "# note\n[render]\nseed = 9\nspp = 2\n[whitted]\nmax_depth = 5 # four\n";
    EXPECT_EQ(contents(path), expected);
    EXPECT_EQ(edited.text(), expected);
    EXPECT_FALSE(edited.changed());
}

TEST(SceneDocument, SavesNothingWhereAnEditHasNoPlaceAnyMore) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.toml", "[material.red]\nindex = 2\n");
    SceneDocument edited = SceneDocument::open(path);
    edited.set("material.red.index", 3);
    folder.write("a.toml", "[material.blue]\n");
    EXPECT_THROW(edited.save(), Error);
    EXPECT_EQ(contents(path), "[material.blue]\n");
    EXPECT_TRUE(edited.changed());
}

TEST(SceneDocument, SavedElsewhereFindsItsMeshes) {
    const TemporaryFolder folder;
    const std::string path = folder.write(
        "a/scene.toml", "[material.m]\n[[mesh]]\nfile = \"parts/t.ply\" # mesh\nmaterial = \"m\"\n");
    folder.write("a/parts/t.ply", triangle_ply);
    fs::create_directories(folder.at("b"));
    SceneDocument edited = SceneDocument::open(path);
    edited.save_as(folder.at("b/copy.toml"));
    EXPECT_EQ(contents(folder.at("b/copy.toml")),
              "[material.m]\n[[mesh]]\nfile = \"../a/parts/t.ply\" # mesh\nmaterial = \"m\"\n");
    LoadOptions options;
    options.allow_outside = true;
    EXPECT_EQ(load_scene(edited.name(), options).files.size(), 2u);
}

TEST(SceneDocument, AStagedMeshBecomesASceneFile) {
    const TemporaryFolder folder;
    const std::string mesh = folder.write("t.ply", triangle_ply);
    LoadOptions options;
    options.up = Axis::z;
    SceneDocument staged = SceneDocument::open(mesh, options);
    EXPECT_EQ(staged.name(), folder.at("t.toml"));
    EXPECT_TRUE(staged.changed());
    staged.save();
    EXPECT_FALSE(staged.changed());
    const LoadedScene saved = load_scene(folder.at("t.toml"));
    SceneDescription expected = load_scene(mesh, options).description;
    expected.camera = fit_camera(expected);
    for (Object& object : expected.objects)
        if (auto* shape = std::get_if<MeshShape>(&object.shape)) shape->file = "t.ply";
    EXPECT_EQ(scene_text(saved.description), scene_text(expected));
    ASSERT_TRUE(std::get<MeshShape>(saved.description.objects[0].shape).data);

    SceneDocument again = SceneDocument::open(mesh, options);
    EXPECT_THROW(again.save(), Error) << "no file is overwritten";
}

TEST(LoadedScene, NamesTheFilesThatItRead) {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("scene.toml", "[material.m]\n[[mesh]]\nfile = \"m/t.ply\"\nmaterial = "
                                   "\"m\"\n[[mesh]]\nfile = \"./m/t.ply\"\nmaterial = "
                                   "\"m\"\n");
    const std::string mesh = folder.write("m/t.ply", triangle_ply);
    EXPECT_EQ(load_scene(path).files, (std::vector<std::string>{path, mesh}));
    EXPECT_EQ(load_scene(mesh).files, std::vector<std::string>{mesh});
}

} // namespace
} // namespace glint::test
