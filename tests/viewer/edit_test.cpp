// Edits in the Scene panel and the resulting scene files.

#include "driver.h"

#include "glint/image.h"
#include "glint/mesh_files.h"

#include <algorithm>
#include <sstream>

namespace glint::test {
namespace {

constexpr const char* things = R"(version = 1
# A comment that stays.
[camera]
eye = [0, -9, 3]
look_at = [0, 0, 0.5]
fov = 40
[render]
size = [400, 300]
spp = 1
[material.red]
color = [0.8, 0.1, 0.1]
[[mesh]]
name = "wedge"
file = "wedge.ply"
material = "red"   # as the ball
[[instance]]
name = "again"
mesh = "wedge"
transform = [{ rotate = [0, 0, 1], angle = 30 }, # turned first
  { scale = 0.5 }, # then made small
]
[[triangle]]
name = "sheet"
vertices = [[-3, 0, 0], [-2, 0, 0], [-2, 0, 1]]
material = "red"
[[sphere]]
name = "ball"
center = [2, 0, 0]
radius = 0.5
material = "red"
[[light]]
type = "point"
position = [-3, -4, 6]
radiant_intensity = 120   # measured
)";

class Editing : public Screen {
  protected:
    void open_things(const std::string& more = "") {
        Mesh wedge;
        wedge.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        write_ply(path("wedge.ply"), wedge);
        text_ = things + more;
        write("scene.toml", text_);
        open("scene.toml", {"--window", "1100x1160", "--size", "400x300"});
        picture_ = finished_picture();
    }

    /// Opens the section of a table of the scene, so that the key's row can be seen.
    void unfold(const std::string& table, const std::string& key) {
        if (!has(table + "." + key)) click("section:" + table);
        ASSERT_TRUE(wait_for_widget(table + "." + key)) << map().dump(1);
    }

    /// Drags a number, or the first of three, and waits for another picture.
    void pull(const std::string& widget, double from = 0.15, double to = 0.9) {
        drag(spot(widget, from), spot(widget, to));
        const std::string now = finished_picture();
        EXPECT_NE(now, picture_) << widget;
        picture_ = now;
    }

    /// Saves, and returns the changed lines, removed ones with a "-".
    std::vector<std::string> saved_lines() {
        press("ctrl+s");
        EXPECT_TRUE(wait_for_state("changed", false)) << log();
        const std::vector<std::string> before = lines(text_);
        const std::vector<std::string> after = lines(content("scene.toml"));
        std::vector<std::string> changed;
        for (const std::string& line : before)
            if (std::find(after.begin(), after.end(), line) == after.end()) changed.push_back("-" + line);
        for (const std::string& line : after)
            if (std::find(before.begin(), before.end(), line) == before.end()) changed.push_back(line);
        text_ = content("scene.toml");
        return changed;
    }

    static std::vector<std::string> lines(const std::string& text) {
        std::vector<std::string> all;
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) all.push_back(line);
        return all;
    }

    std::string text_;
    std::string picture_;
};

TEST_F(Editing, ALightKeepsTheNameThatTheFileHasForItsIntensity) {
    open_things();
    unfold("light.0", "radiant_intensity");
    EXPECT_FALSE(has("light.0.intensity"));
    pull("light.0.radiant_intensity", 0.5, 0.2);
    EXPECT_FALSE(has("errors")) << state("error");
    const std::vector<std::string> changed = saved_lines();
    ASSERT_EQ(changed.size(), 2u);
    EXPECT_TRUE(changed[1].starts_with("radiant_intensity = ")) << changed[1];
    EXPECT_TRUE(changed[1].ends_with("   # measured")) << changed[1];
}

TEST_F(Editing, AMeshIsMovedByANewEntryOfItsTransform) {
    open_things();
    unfold("mesh.wedge", "transform.0.translate");
    pull("mesh.wedge.transform.0.translate");
    std::vector<std::string> changed = saved_lines();
    ASSERT_EQ(changed.size(), 1u);
    EXPECT_TRUE(changed[0].starts_with("transform = [{ translate = [")) << changed[0];
    // Once more, now that the file has it.
    pull("mesh.wedge.transform.0.translate", 0.3, 0.1);
    changed = saved_lines();
    ASSERT_EQ(changed.size(), 2u);
    EXPECT_TRUE(changed[1].starts_with("transform = [{ translate = [")) << changed[1];
    EXPECT_EQ(std::count(text_.begin(), text_.end(), '{'), 3) << text_;
}

TEST_F(Editing, AnInstanceIsMovedBehindWhatItsTransformDoes) {
    open_things();
    unfold("instance.again", "transform.0.angle");
    pull("instance.again.transform.0.angle");
    pull("instance.again.transform.1.scale", 0.3, 0.6);
    ASSERT_TRUE(wait_for_widget("instance.again.transform.2.translate"));
    pull("instance.again.transform.2.translate");
    const std::vector<std::string> changed = saved_lines();
    ASSERT_EQ(changed.size(), 4u);
    EXPECT_TRUE(changed[2].starts_with("transform = [{ rotate = [0, 0, 1], angle = ")) << changed[2];
    EXPECT_TRUE(changed[2].ends_with(" }, # turned first")) << changed[2];
    EXPECT_TRUE(changed[3].starts_with("  { scale = ")) << changed[3];
    EXPECT_NE(changed[3].find(" }, { translate = ["), std::string::npos) << changed[3];
    EXPECT_TRUE(changed[3].ends_with(" }, # then made small")) << changed[3];
    press("ctrl+z");
    EXPECT_TRUE(wait_for_state("changed", true));
    EXPECT_TRUE(wait_until([&] { return state("picture_hash") != picture_; }));
}

TEST_F(Editing, TrianglesAndMeshesHaveRowsOfTheirOwn) {
    open_things();
    unfold("triangle.sheet", "vertices.0");
    EXPECT_FALSE(has("triangle.sheet.priority")) << "it owns no space";
    pull("triangle.sheet.vertices.0");
    click("section:triangle.sheet");
    unfold("mesh.wedge", "facing");
    pull("mesh.wedge.scale", 0.3, 0.6);
    click("mesh.wedge.facing");
    ASSERT_TRUE(wait_for_widget("mesh.wedge.facing:stored"));
    click("mesh.wedge.facing:stored");
    finished_picture();
    click(spot("mesh.wedge.priority", 0.9));
    finished_picture();
    const std::vector<std::string> changed = saved_lines();
    ASSERT_EQ(changed.size(), 5u);
    EXPECT_TRUE(changed[1].starts_with("scale = ")) << changed[1];
    EXPECT_EQ(changed[2], "facing = \"stored\"");
    EXPECT_TRUE(changed[3].starts_with("priority = ")) << changed[3];
    EXPECT_TRUE(changed[4].starts_with("vertices = [[")) << changed[4];
    EXPECT_TRUE(changed[4].ends_with(", 0, 0], [-2, 0, 0], [-2, 0, 1]]")) << changed[4];
}

TEST_F(Editing, WhatIsAnimatedCannotBeChangedInAFrame) {
    open_things(
        "[[animate]]\nkey = \"sphere.0.center\"\nframes = [0, 20]\nvalues = [[2, 0, 0], [2, 0, 2]]\n");
    press("period");
    ASSERT_TRUE(wait_for_state("frame", 1.0));
    picture_ = finished_picture();
    unfold("sphere.ball", "center");
    drag(spot("sphere.ball.center", 0.15), spot("sphere.ball.center", 0.9));
    EXPECT_EQ(finished_picture(), picture_);
    EXPECT_EQ(state("changed"), false);
    pull("sphere.ball.radius", 0.3, 0.6);
    EXPECT_EQ(state("changed"), true);
}

} // namespace
} // namespace glint::test
