// The pixel that the window explains, and the command line that explains the same.

#include "../cli/process.h"
#include "driver.h"

#include <fmt/format.h>

#include <filesystem>

namespace glint::test {
namespace {

constexpr const char* red_balls = R"(version = 1
[camera]
eye = [0, -6, 2]
look_at = [0, 0, 1]
fov = 40
[render]
size = [400, 300]
spp = 2
[material.floor]
color = [0.4, 0.4, 0.5]
[material.red]
color = [0.8, 0.1, 0.1]
diffuse = 0.9
highlight = 0.5
[[plane]]
normal = [0, 0, 1]
material = "floor"
[[sphere]]
name = "left"
center = [-1, 0, 1]
radius = 1
material = "red"
[[sphere]]
name = "right"
center = [1, 0, 1]
radius = 1
material = "red"
[[light]]
type = "point"
position = [-3, -4, 6]
intensity = 40
)";

class PixelInTheWindow : public Screen {
  protected:
    void open_scene(const std::string& text, const std::vector<std::string>& options = {},
                    const std::string& name = "scene.toml") {
        write(name, text);
        std::vector<std::string> arguments{"--window", "1100x700", "--size", "400x300"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        open(name, arguments);
        finished_picture();
    }

    /// Its colour, once the explanation is complete.
    std::string color() const {
        finished_picture();
        std::string text;
        EXPECT_TRUE(wait_until([&] {
            const nlohmann::json all = map()["state"];
            text = all.value("pixel.color", "");
            return !text.empty() && !all.value("explaining", true) && all.contains("pixel.command");
        })) << map().dump(1);
        return text;
    }

    void edit_the_red() {
        click("tab:scene");
        ASSERT_TRUE(wait_for_widget("section:material.red"));
        if (!has("material.red.diffuse")) click("section:material.red");
        ASSERT_TRUE(wait_for_widget("material.red.diffuse"));
        drag(spot("material.red.diffuse", 0.8), spot("material.red.diffuse", 0.2));
        click("tab:pixel");
        ASSERT_TRUE(wait_for_state("tab", "pixel"));
    }

    /// Runs the command of *Copy command* in a shell.
    void expect_the_command_prints(const std::string& wanted) const {
        const std::string line = state("pixel.command");
        const std::string folder = std::filesystem::path(GLINT_PROGRAM).parent_path().string();
        Setting elsewhere;
        elsewhere.folder = "/";
        const Outcome outcome = run_program(
            {"/bin/sh", "-c", "PATH='" + folder + "':\"$PATH\"; " + line + " --format json"}, elsewhere);
        ASSERT_EQ(outcome.exit, 0) << line << "\n" << outcome.err;
        const nlohmann::json color = nlohmann::json::parse(outcome.out)["color"];
        const auto number = [&](std::size_t i) { return static_cast<double>(color[i].get<float>()); };
        EXPECT_EQ(fmt::format("{:.9g} {:.9g} {:.9g}", number(0), number(1), number(2)), wanted) << line;
    }
};

TEST_F(PixelInTheWindow, IsExplainedAgainWhenTheSceneChanges) {
    open_scene(red_balls);
    click(spot("picture", 0.63, 0.4));
    const std::string before = color();
    edit_the_red();
    const std::string edited = color();
    EXPECT_NE(edited, before);
    expect_the_command_prints(edited);
    press("ctrl+z");
    ASSERT_TRUE(wait_for_state("changed", false));
    EXPECT_EQ(color(), before);
    std::string other = red_balls;
    other.replace(other.find("intensity = 40"), 14, "intensity = 20");
    write("scene.toml", other);
    EXPECT_TRUE(wait_until([&] { return state("pixel.color") != before; })) << "another file";
    expect_the_command_prints(color());
}

TEST_F(PixelInTheWindow, StaysAsItWasSeenWhileTheCameraMovesAndSaysSo) {
    open_scene(red_balls);
    click(spot("picture", 0.63, 0.4));
    const std::string before = color();
    EXPECT_EQ(state("pixel.elsewhere"), false);
    press("Left");
    ASSERT_TRUE(wait_for_state("pixel.elsewhere", true));
    EXPECT_EQ(color(), before);
    expect_the_command_prints(before);
    ASSERT_TRUE(wait_for_widget("button:explain_here"));
    click("button:explain_here");
    ASSERT_TRUE(wait_for_state("pixel.elsewhere", false));
    EXPECT_NE(color(), before);
    expect_the_command_prints(color());
}

TEST_F(PixelInTheWindow, ItsCommandCarriesEverything) {
    open_scene(red_balls, {"-D", "material.floor.color=[0.5, 0.3, 0.2]", "-D", "render.spp=3"},
               "it's a scene.toml");
    drag(spot("picture"), spot("picture", 0.6, 0.45));
    wheel(spot("picture"), 1);
    finished_picture();
    click(spot("picture", 0.6, 0.5));
    color();
    edit_the_red();
    expect_the_command_prints(color());
}

TEST_F(PixelInTheWindow, ItsCommandCarriesTheFrame) {
    open_scene(std::string(red_balls) + R"([[animate]]
key = "sphere.right.center"
frames = [0, 20]
values = [[1, 0, 1], [1, 0, 3]]
)");
    click(spot("picture", 0.63, 0.4));
    const std::string before = color();
    press("period");
    ASSERT_TRUE(wait_for_state("frame", 1.0));
    const std::string later = color();
    EXPECT_NE(later, before);
    expect_the_command_prints(later);
    press("space");
    ASSERT_TRUE(wait_until([&] { return state("frame").get<double>() > 2; }));
    press("space");
    ASSERT_TRUE(wait_for_state("playing", false));
    expect_the_command_prints(color());
}

TEST_F(PixelInTheWindow, BelongsToThePictureUnderTheMouse) {
    open_scene(red_balls);
    press("k");
    ASSERT_TRUE(wait_for_state("kept", true));
    click(spot("picture", 0.35, 0.4));
    const std::string as_kept = color();
    EXPECT_EQ(state("pixel.picture"), "B");
    edit_the_red();
    const std::string as_changed = color();
    EXPECT_NE(as_changed, as_kept);
    press("c");
    ASSERT_TRUE(wait_for_widget("wipe"));
    finished_picture();
    click(spot("picture", 0.35, 0.4));
    ASSERT_TRUE(wait_for_state("pixel.picture", "A"));
    EXPECT_EQ(color(), as_kept);
    expect_the_command_prints(as_kept);
    click(spot("picture", 0.63, 0.4));
    ASSERT_TRUE(wait_for_state("pixel.picture", "B"));
    expect_the_command_prints(color());

    // Side by side the left picture takes clicks and drags too.
    press("c");
    ASSERT_TRUE(wait_for_widget("reference"));
    click(spot("reference", 0.35, 0.4));
    ASSERT_TRUE(wait_for_state("pixel.picture", "A"));
    expect_the_command_prints(color());
    const nlohmann::json eye = state("camera.eye");
    drag(spot("reference"), spot("reference", 0.7, 0.5));
    EXPECT_NE(state("camera.eye"), eye);
    press("c");
    ASSERT_TRUE(wait_for_state("compare", "off"));
    EXPECT_TRUE(wait_until([&] { return !map()["state"].contains("pixel.x"); })) << "A is gone";
}

TEST_F(PixelInTheWindow, TakesNoTimeFromClosing) {
    std::string many = red_balls;
    many.replace(many.find("spp = 2"), 7, "spp = 4096");
    write("scene.toml", many);
    open("scene.toml", {"--window", "1100x700", "-D", "material.red.transparency=0.7", "-D",
                        "material.red.reflectivity=0.3", "-D", "whitted.max_depth=12"});
    ASSERT_TRUE(wait_for_state("status", "ready"));
    ASSERT_TRUE(wait_for_widget("picture"));
    click(spot("picture", 0.63, 0.5));
    EXPECT_GE(seconds_to_close(), 0);
    EXPECT_EQ(viewer().ended(), 0) << log();
}

} // namespace
} // namespace glint::test
