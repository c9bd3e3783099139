// What a user does with the window, by script.

#include "../cli/process.h"
#include "driver.h"

#include "glint/picture_files.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace glint::test {
namespace {

/// Two balls, one a mirror, on a floor under one lamp.
constexpr const char* two_balls = R"(version = 1
# A comment that stays.
[camera]
eye = [0, -6, 2]
look_at = [0, 0, 1]
fov = 40
[render]
size = [400, 300]
spp = 1
[material.floor]
color = [0.4, 0.4, 0.5]
[material.mirror]
color = [0.2, 0.2, 0.2]
reflectivity = 0.6   # as the report has it
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
material = "mirror"
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

class Window : public Screen {
  protected:
    void SetUp() override {
        Screen::SetUp();
        if (!IsSkipped()) write("scene.toml", two_balls);
    }

    void open_scene(const std::vector<std::string>& options = {}) {
        std::vector<std::string> arguments{"--window", "1100x700", "--size", "400x300"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        open("scene.toml", arguments);
    }

    void turn_to(const std::string& tab) {
        click("tab:" + tab);
        ASSERT_TRUE(wait_for_state("tab", tab));
    }

    bool is_within_window(const std::string& widget, double width, double height) const {
        if (!has(widget)) return false;
        const Spot from = spot(widget, 0, 0);
        const Spot to = spot(widget, 1, 1);
        return from.x >= 0 && from.y >= 0 && to.x <= width && to.y <= height;
    }

    /// The scene's text with one thing in it changed.
    static std::string with(const std::string& what, const std::string& instead) {
        std::string text = two_balls;
        const std::size_t at = text.find(what);
        if (at == std::string::npos) throw std::logic_error("the scene has no " + what);
        return text.replace(at, what.size(), instead);
    }
};

/// The fraction of pixels in an area that differ between two screenshots.
double changed_share(const Image& a, const Image& b, const nlohmann::json& area) {
    int changed = 0;
    int all = 0;
    const auto side = [&](std::size_t i) { return static_cast<int>(area[i].get<double>()); };
    for (int y = side(1); y < side(1) + side(3); ++y)
        for (int x = side(0); x < side(0) + side(2); ++x, ++all)
            changed += std::memcmp(a.at(x, y), b.at(x, y), 3 * sizeof(float)) != 0;
    return static_cast<double>(changed) / all;
}

TEST_F(Window, ShowsThePictureThatTheCommandLineRenders) {
    open_scene();
    finished_picture();
    press("ctrl+p");
    ASSERT_TRUE(wait_until([&] { return state("saved").is_string(); })) << log();
    const std::string ours = state("saved");
    const Outcome outcome = run_glint({path("scene.toml"), "-o", path("theirs.png"), "-q"}, {});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_EQ(picture_hash(read_picture(ours).image), picture_hash(read_picture(path("theirs.png")).image));

    // And the screen shows that picture.
    EXPECT_EQ(wrong_on_screen(read_picture(ours).image), 0);
    EXPECT_GE(seconds_to_close(), 0);
}

TEST_F(Window, DraggingOrbitsAndHomeComesBack) {
    open_scene();
    const std::string before = finished_picture();
    const nlohmann::json eye = state("camera.eye");
    drag(spot("picture"), spot("picture", 0.7, 0.4));
    EXPECT_NE(finished_picture(), before);
    EXPECT_NE(state("camera.eye"), eye);
    press("Home");
    ASSERT_TRUE(wait_for_state("camera.eye", eye));
    EXPECT_EQ(finished_picture(), before);
}

TEST_F(Window, EveryWayToMoveTheCameraMovesIt) {
    open_scene();
    std::string last = finished_picture();
    const auto moved = [&](const char* how) {
        const std::string hash = finished_picture();
        EXPECT_NE(hash, last) << how;
        last = hash;
    };
    drag(spot("picture"), spot("picture", 0.6, 0.5), "shift");
    moved("shift and drag");
    drag(spot("picture"), spot("picture", 0.6, 0.6), "", "3");
    moved("right drag");
    drag(spot("picture"), spot("picture", 0.5, 0.4), "ctrl");
    moved("control and drag");
    wheel(spot("picture"), 2);
    moved("wheel");
    for (const char* key :
         {"Left", "Up", "shift+Right", "shift+Down", "plus", "minus", "bracketleft", "w", "e"}) {
        press(key);
        moved(key);
    }
}

TEST_F(Window, ASliderChangesThePictureAndNothingElse) {
    open_scene();
    const std::string before = finished_picture();
    turn_to("scene");
    if (!has("material.red.diffuse")) click("section:material.red");
    ASSERT_TRUE(wait_for_widget("material.red.diffuse"));
    const Image first = screenshot();
    drag(spot("material.red.diffuse", 0.8), spot("material.red.diffuse", 0.1));
    EXPECT_NE(finished_picture(), before);
    const Image second = screenshot();
    const double share = changed_share(first, second, map()["widgets"]["picture"]);
    EXPECT_GT(share, 0.01) << "the red ball";
    EXPECT_LT(share, 0.5) << "and what mirrors it";

    press("ctrl+z");
    EXPECT_EQ(finished_picture(), before) << "undone";
}

TEST_F(Window, SavingTheSceneChangesOnlyWhatWasEdited) {
    open_scene();
    finished_picture();
    if (!has("material.mirror.reflectivity")) click("section:material.mirror");
    ASSERT_TRUE(wait_for_widget("material.mirror.reflectivity"));
    click(spot("material.mirror.reflectivity", 0.25));
    ASSERT_TRUE(wait_for_state("changed", true));
    press("ctrl+s");
    ASSERT_TRUE(wait_for_state("changed", false)) << log();
    const std::string text = content("scene.toml");
    ASSERT_NE(text, two_balls);
    // All lines are the same but for the value.
    std::istringstream now_lines(text);
    std::istringstream then_lines(two_balls);
    std::string now_line;
    int differ = 0;
    for (std::string then; std::getline(then_lines, then);) {
        ASSERT_TRUE(std::getline(now_lines, now_line));
        if (now_line == then) continue;
        ++differ;
        EXPECT_EQ(now_line.rfind("reflectivity = 0.", 0), 0u) << now_line;
        EXPECT_NE(now_line.find("   # as the report has it"), std::string::npos) << now_line;
    }
    EXPECT_EQ(differ, 1);
}

TEST_F(Window, WhatIsUndoneAfterSavingCanBeSavedAgain) {
    open_scene();
    const std::string before = finished_picture();
    turn_to("scene");
    if (!has("material.red.diffuse")) click("section:material.red");
    ASSERT_TRUE(wait_for_widget("material.red.diffuse"));
    drag(spot("material.red.diffuse", 0.8), spot("material.red.diffuse", 0.1));
    ASSERT_TRUE(wait_for_state("changed", true));
    press("ctrl+s");
    ASSERT_TRUE(wait_for_state("changed", false));
    EXPECT_NE(content("scene.toml"), two_balls);
    press("ctrl+z");
    ASSERT_TRUE(wait_for_state("changed", true)) << "the file is another now";
    EXPECT_EQ(finished_picture(), before);
    press("ctrl+s");
    ASSERT_TRUE(wait_for_state("changed", false));
    EXPECT_EQ(content("scene.toml"), two_balls);
    EXPECT_EQ(finished_picture(), before);
}

TEST_F(Window, AClickShowsTheRayTreeOfThePixel) {
    open_scene();
    finished_picture();
    const Image before = screenshot();
    // The mirror ball, where it reflects the floor: a reflected ray and two shadow rays.
    click(spot("picture", 0.36, 0.5));
    ASSERT_TRUE(wait_for_widget("ray:0")) << log();
    EXPECT_EQ(state("tab"), "pixel");
    EXPECT_TRUE(has("ray:0:light:0"));
    ASSERT_TRUE(wait_for_widget("ray:1")) << "the mirror ray";
    EXPECT_TRUE(wait_until([&] { return state("rays_drawn").get<double>() >= 1; }));
    const Image after = screenshot();
    EXPECT_GT(changed_share(before, after, map()["widgets"]["picture"]), 0) << "its rays in the picture";

    // The pixel that the panel names is the one clicked.
    const Spot clicked = spot("picture", 0.36, 0.5);
    const nlohmann::json area = map()["widgets"]["picture"];
    const int x =
        static_cast<int>((std::round(clicked.x) - area[0].get<double>()) / area[2].get<double>() * 400);
    EXPECT_NEAR(state("pixel.x").get<double>(), x, 1);

    press("Escape");
    EXPECT_TRUE(wait_until([&] { return !has("ray:0"); }));
}

TEST_F(Window, AClickMarksTheMaterialAndOpensItInTheScenePanel) {
    open_scene();
    finished_picture();
    click("picture");
    ASSERT_TRUE(wait_for_state("tab", "pixel"));
    ASSERT_TRUE(wait_until([&] {
        const nlohmann::json material = state("pixel.material");
        return material.is_string() && material != "";
    }));
    const std::string material = state("pixel.material");
    click("tab:scene");
    EXPECT_TRUE(wait_for_widget("material." + material + ".diffuse"));
}

TEST_F(Window, TheKernelIsChosenAndChangesNoPicture) {
    open_scene();
    const std::string before = finished_picture();
    click("tab:picture");
    ASSERT_TRUE(wait_for_widget("kernel"));
    click("kernel");
    ASSERT_TRUE(wait_for_widget("kernel:scalar"));
    click("kernel:scalar");
    ASSERT_TRUE(wait_for_state("kernel", "scalar"));
    EXPECT_EQ(finished_picture(), before);
}

TEST_F(Window, ASavedFileIsShownAtOnceAndTheCameraKept) {
    open_scene();
    const std::string before = finished_picture();
    press("Left");
    const std::string turned = finished_picture();
    ASSERT_NE(turned, before);
    const nlohmann::json eye = state("camera.eye");
    write("scene.toml", with("color = [0.8, 0.1, 0.1]", "color = [0.1, 0.8, 0.1]"));
    ASSERT_TRUE(wait_until([&] { return state("picture_hash") != turned; }));
    EXPECT_NE(finished_picture(), turned);
    EXPECT_EQ(state("camera.eye"), eye);
}

TEST_F(Window, ABrokenFileIsToldWhileTheLastGoodSceneIsShown) {
    open_scene();
    const std::string before = finished_picture();
    write("scene.toml", with("material = \"red\"", "material = \"rad\""));
    ASSERT_TRUE(wait_for_widget("errors"));
    EXPECT_NE(state("error").get<std::string>().find("rad"), std::string::npos) << state("error");
    EXPECT_EQ(finished_picture(), before);
    // The camera still moves.
    press("Left");
    EXPECT_NE(finished_picture(), before);
    write("scene.toml", two_balls);
    EXPECT_TRUE(wait_until([&] { return !has("errors"); }));
}

TEST_F(Window, TheWipeShowsTwoSettingsBesideEachOther) {
    open_scene();
    finished_picture();
    const Image plain = screenshot();
    press("k");
    ASSERT_TRUE(wait_for_state("kept", true));
    if (!has("material.red.diffuse")) click("section:material.red");
    ASSERT_TRUE(wait_for_widget("material.red.diffuse"));
    click(spot("material.red.diffuse", 0.02));
    finished_picture();
    press("c");
    ASSERT_TRUE(wait_for_state("compare", "wipe"));
    ASSERT_TRUE(wait_for_widget("wipe"));
    finished_picture();
    const nlohmann::json area = map()["widgets"]["picture"];
    nlohmann::json left = area;
    left[2] = area[2].get<double>() * 0.4;
    nlohmann::json right = area;
    right[0] = area[0].get<double>() + area[2].get<double>() * 0.6;
    right[2] = left[2];
    // Below the label in the corner.
    left[1] = right[1] = area[1].get<double>() + 40;
    left[3] = right[3] = area[3].get<double>() - 40;
    const Image wiped = screenshot();
    EXPECT_EQ(changed_share(plain, wiped, left), 0) << "A, as it was";
    EXPECT_GT(changed_share(plain, wiped, right), 0.01) << "B";

    // The line can be dragged: to the right end, and all is A again.
    drag(spot("wipe"), spot("picture", 0.98, 0.5));
    ASSERT_TRUE(wait_until([&] { return state("wipe").get<double>() > 0.9; }));
    EXPECT_EQ(changed_share(plain, screenshot(), left), 0);

    press("c");
    EXPECT_TRUE(wait_for_state("compare", "side by side"));
    press("c");
    EXPECT_TRUE(wait_for_state("compare", "off"));
}

TEST_F(Window, QuantitiesAreChosenAndShown) {
    open_scene();
    const std::string before = finished_picture();
    turn_to("picture");
    for (const char* quantity : {"diffuse", "shadows", "normal", "depth", "cost"}) {
        click("show");
        ASSERT_TRUE(wait_for_widget(std::string("show:") + quantity)) << quantity;
        click(std::string("show:") + quantity);
        ASSERT_TRUE(wait_for_state("show", quantity));
        EXPECT_NE(finished_picture(), before) << quantity;
    }
    press("f");
    ASSERT_TRUE(wait_for_state("show", "final"));
    EXPECT_EQ(finished_picture(), before);
}

TEST_F(Window, AnAnimationPlaysAndCanBeSteppedThrough) {
    write("scene.toml", std::string(two_balls) + R"([[animate]]
key = "sphere.right.center"
frames = [0, 20]
values = [[1, 0, 1], [1, 0, 3]]
)");
    open_scene();
    const std::string before = finished_picture();
    ASSERT_TRUE(wait_for_widget("timeline"));
    press("period");
    ASSERT_TRUE(wait_for_state("frame", 1.0));
    EXPECT_NE(finished_picture(), before);
    press("comma");
    ASSERT_TRUE(wait_for_state("frame", 0.0));
    EXPECT_EQ(finished_picture(), before);
    press("space");
    ASSERT_TRUE(wait_for_state("playing", true));
    EXPECT_TRUE(wait_until([&] { return state("frame").get<double>() > 2; }));
    press("space");
    EXPECT_TRUE(wait_for_state("playing", false));
}

TEST_F(Window, TheQuestionMarkListsTheKeys) {
    open_scene();
    finished_picture();
    press("question");
    EXPECT_TRUE(wait_for_widget("help"));
    press("Escape");
    EXPECT_TRUE(wait_until([&] { return !has("help"); }));
}

TEST_F(Window, TheListOfKeysStaysWithinAWindowWithLargeTexts) {
    open_scene({"--scale", "2", "--window", "1390x860"});
    finished_picture();
    press("question");
    EXPECT_TRUE(wait_until([&] { return is_within_window("help", 1390, 860); })) << map().dump(1);
}

TEST_F(Window, TheListOfKeysScrollsWhereThereIsNoRoom) {
    open_scene({"--scale", "2", "--window", "640x400"});
    finished_picture();
    press("question");
    EXPECT_TRUE(wait_until([&] { return is_within_window("help", 640, 400); })) << map().dump(1);
}

TEST_F(Window, TheTurntableTurnsUntilItIsStopped) {
    open_scene();
    finished_picture();
    const nlohmann::json eye = state("camera.eye");
    press("t");
    ASSERT_TRUE(wait_until([&] { return state("camera.eye") != eye; }));
    const nlohmann::json later = state("camera.eye");
    ASSERT_TRUE(wait_until([&] { return state("camera.eye") != later; }));
    press("t");
    finished_picture();
    const nlohmann::json end = state("camera.eye");
    finished_picture();
    EXPECT_EQ(state("camera.eye"), end);
}

TEST_F(Window, ClosesAtOnceWhileItRenders) {
    write("scene.toml", with("spp = 1", "spp = 1024"));
    open("scene.toml", {"--window", "1300x860"});
    ASSERT_TRUE(wait_for_state("status", "ready"));
    const double seconds = seconds_to_close();
    EXPECT_GE(seconds, 0);
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_EQ(viewer().ended(), 0) << log();
}

TEST_F(Window, StatisticsArePrintedAtTheEnd) {
    open_scene({"--ui-stats"});
    finished_picture();
    drag(spot("picture"), spot("picture", 0.8, 0.5));
    EXPECT_GE(seconds_to_close(), 0);
    EXPECT_NE(log().find("frames"), std::string::npos) << log();
    EXPECT_NE(log().find("median"), std::string::npos) << log();
}

} // namespace
} // namespace glint::test
