// The `glint explain` command line of a pixel. tests/viewer runs such lines.

#include "session/explain_command.h"

#include "../kit/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace glint::viewer {
namespace {

namespace fs = std::filesystem;

const std::string moving_ball = R"([camera]
eye = [0, -6, 0]
look_at = [0, 0, 0]
[material.red]
color = [1, 0, 0]
[[sphere]]
name = "ball"
center = [0, 0, 0]
radius = 1
material = "red"
[[animate]]
key = "sphere.ball.center"
frames = [0, 10]
values = [[0, 0, 0], [0, 0, 1]]
)";

class ExplainCommandTest : public testing::Test {
  protected:
    ExplainCommandTest() { folder_.write("a ball's.toml", moving_ball); }

    std::string file() const { return folder_.at("a ball's.toml"); }

    /// The file as the window shows it, at a frame or without animation.
    ShownFile shown(const std::vector<Override>& changes = {}, std::optional<double> frame = {}) const {
        ShownFile shown{file(), {}, SceneDocument::open(file()), {"sphere.ball.center"}, frame, {}};
        shown.document->set_all(changes);
        const LoadedScene loaded = parse_scene(shown.document->text(), file());
        shown.description = frame ? scene_at(loaded, *frame) : loaded.description;
        return shown;
    }
    static PixelQuestion question(const ShownFile& shown) {
        return {ViewSlot::main, *shown.description.camera, 80, 60, 40, 30};
    }
    static ExplainCommand checked(const ShownFile& shown) {
        ExplainCommand command = explain_command(shown, question(shown));
        check(command, shown);
        return command;
    }

    test::TemporaryFolder folder_;
};

TEST(Quoted, OnlyWhereAShellWouldTakeItApart) {
    EXPECT_EQ(quoted("scenes/drink.toml"), "scenes/drink.toml");
    EXPECT_EQ(quoted("a b"), "'a b'");
    EXPECT_EQ(quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(quoted("camera.eye=[1, 2, 3]"), "'camera.eye=[1, 2, 3]'");
    EXPECT_EQ(quoted(""), "''");
    EXPECT_EQ(quoted("$HOME"), "'$HOME'");
}

TEST_F(ExplainCommandTest, NamesNoMoreThanThePixelWhereNothingIsChanged) {
    const ExplainCommand command = checked(shown());
    EXPECT_EQ(command.line, "glint explain " + quoted(file()) + " --size 80x60 --pixel 40,30");
    EXPECT_EQ(command.limitation, "");
}

TEST_F(ExplainCommandTest, CarriesChangesTheCameraAndOptions) {
    ShownFile file = shown({"material.red.color=[0, 1, 0]"});
    file.load.allow_outside = true;
    PixelQuestion asked = question(file);
    asked.camera.eye = Vec3(0.5, -6, 0);
    ExplainCommand command = explain_command(file, asked);
    check(command, file);
    EXPECT_EQ(command.limitation, "");
    for (const char* part : {" -D 'material.red.color=[0, 1, 0]'", " -D 'camera.eye=[0.5, -6, 0]'",
                             " -D 'camera.look_at=[0.5, 0, 0]'", " -D camera.fov=45", " --allow-outside"})
        EXPECT_NE(command.line.find(part), std::string::npos) << part << " in " << command.line;
    EXPECT_EQ(command.line.find("direction"), std::string::npos);
}

TEST_F(ExplainCommandTest, CarriesTheFrameButNotWhatMovesThere) {
    const ExplainCommand command =
        checked(shown({"sphere.ball.center=[9, 9, 9]", "sphere.ball.radius=2"}, 5));
    EXPECT_EQ(command.limitation, "");
    EXPECT_NE(command.line.find(" --frame 5"), std::string::npos) << command.line;
    EXPECT_NE(command.line.find(" -D sphere.ball.radius=2"), std::string::npos) << command.line;
    EXPECT_EQ(command.line.find("center"), std::string::npos) << command.line;
    EXPECT_NE(checked(shown({}, 5.5)).limitation.find("between two frames"), std::string::npos);
}

TEST_F(ExplainCommandTest, SaysWhenTheFileIsAnother) {
    const ShownFile before = shown({"sphere.ball.radius=2"});
    std::ofstream(file()) << moving_ball.substr(0, moving_ball.find("[[animate]]"))
                          << "[[light]]\ntype = \"ambient\"\n";
    EXPECT_NE(checked(before).limitation, "");
    fs::remove(file());
    EXPECT_NE(checked(before).limitation, "");
}

TEST_F(ExplainCommandTest, OfABareMeshNotEverythingCanBeCarried) {
    ShownFile file = shown({"material.red.color=[0, 1, 0]"});
    file.file = "shape.ply";
    file.load.up = Axis::y;
    file.load.overrides = {"render.spp=2"};
    EXPECT_NE(explain_command(file, question(file)).limitation.find("material.red.color"), std::string::npos);
    file.document = SceneDocument("[material.clay]\ncolor = [1, 1, 1]\n", "shape.toml");
    file.document->set("material.clay.color", Vec3(0, 1, 0));
    const ExplainCommand command = explain_command(file, question(file));
    EXPECT_EQ(command.limitation, "");
    for (const char* part :
         {" --up y", " -D render.spp=2", " -D 'material.clay.color=[0, 1, 0]'", "camera.eye"})
        EXPECT_NE(command.line.find(part), std::string::npos) << part << " in " << command.line;
}

} // namespace
} // namespace glint::viewer
