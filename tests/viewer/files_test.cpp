// Opening files in the window.

#include "../cli/process.h"
#include "driver.h"

#include "glint/image.h"
#include "glint/mesh_files.h"

#include <cmath>
#include <csignal>

namespace glint::test {
namespace {

constexpr const char* bare_ball = R"([render]
size = [200, 150]
spp = 1
[material.red]
color = [0.8, 0.1, 0.1]
[[sphere]]
center = [0, 0, 1]
radius = 1
material = "red"
[[light]]
type = "ambient"
color = [0.5, 0.5, 0.5]
)";

class Files : public Screen {
  protected:
    /// A hilly grid of squares, two triangles each, as binary PLY.
    void write_grid(const std::string& name, unsigned across, unsigned down) const {
        Mesh mesh;
        for (unsigned y = 0; y <= down; ++y)
            for (unsigned x = 0; x <= across; ++x) {
                const auto fx = static_cast<float>(x);
                const auto fy = static_cast<float>(y);
                mesh.positions.emplace_back(fx, fy, 20 * std::sin(fx * 0.05f) * std::cos(fy * 0.07f));
            }
        for (unsigned y = 0; y < down; ++y)
            for (unsigned x = 0; x < across; ++x) {
                const unsigned corner = y * (across + 1) + x;
                mesh.triangles.emplace_back(corner, corner + 1, corner + across + 1);
                mesh.triangles.emplace_back(corner + 1, corner + across + 2, corner + across + 1);
            }
        write_ply(path(name), mesh);
    }
};

TEST_F(Files, ClosesAtOnceWhileItLoadsAMillionTriangles) {
    write_grid("grid.ply", 1000, 500);
    open("grid.ply");
    const double seconds = seconds_to_close();
    EXPECT_GE(seconds, 0);
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_EQ(viewer().ended(), 0) << log();
}

TEST_F(Files, ALongWayInIsShownAndCanBeCancelled) {
    write_grid("grid.ply", 3000, 1500);
    write("scene.toml", bare_ball);
    open("scene.toml", {"--window", "900x600"});
    const std::string before = finished_picture();
    write("scene.toml", std::string(bare_ball) + "[[mesh]]\nfile = \"grid.ply\"\nmaterial = \"red\"\n");
    ASSERT_TRUE(wait_for_widget("button:cancel")) << map().dump(1);
    EXPECT_EQ(state("status"), "loading");
    click("button:cancel");
    ASSERT_TRUE(wait_for_state("status", "ready"));
    EXPECT_FALSE(has("errors")) << state("error");
    EXPECT_EQ(finished_picture(), before) << "the scene as it was";
    // The file is read again when it changes again.
    std::string text = bare_ball;
    write("scene.toml", text.replace(text.find("0.8, 0.1"), 8, "0.1, 0.8"));
    EXPECT_TRUE(wait_until([&] { return state("picture_hash") != before; }));
}

TEST_F(Files, ASignalWhileOneIsSavedLeavesNoTemporaryFile) {
    if (sanitized) GTEST_SKIP() << "a sanitizer must be loaded first";
    write("scene.toml", bare_ball);
    open("scene.toml", {}, {std::string("LD_PRELOAD=") + GLINT_SIGNAL_IN_FSYNC});
    finished_picture();
    press("F12");
    EXPECT_EQ(viewer().wait(30), 128 + SIGTERM) << log();
    EXPECT_EQ(count(".glint-"), 0);
    EXPECT_EQ(count("scene-window"), 0);
}

TEST_F(Files, WaitsForAFileWhenGivenNone) {
    open("");
    ASSERT_TRUE(wait_for_state("status", "empty"));
    EXPECT_GE(seconds_to_close(), 0);
    EXPECT_EQ(viewer().ended(), 0) << log();
}

TEST_F(Files, OffersExamples) {
    open("");
    ASSERT_TRUE(wait_for_widget("button:examples"));
    click("button:examples");
    ASSERT_TRUE(wait_for_widget("file:castle.toml"));
    click("file:castle.toml");
    ASSERT_TRUE(wait_for_state("status", "ready"));
    EXPECT_FALSE(has("open"));
    press("ctrl+o");
    EXPECT_TRUE(wait_for_widget("open"));
}

TEST_F(Files, AFileThatWasNeverShownIsAnErrorAtTheEnd) {
    write("bad.toml", "[sphere");
    open("bad.toml");
    ASSERT_TRUE(wait_for_widget("errors"));
    EXPECT_GE(seconds_to_close(), 0);
    EXPECT_EQ(viewer().ended(), 3);
    EXPECT_NE(log().find("bad.toml:1"), std::string::npos) << log();
}

} // namespace
} // namespace glint::test
