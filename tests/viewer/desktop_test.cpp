// Drag and drop of files, and the clipboard.

#include "desktop.h"
#include "driver.h"

#include "glint/image.h"

#include <filesystem>

namespace glint::test {
namespace {

constexpr const char* ball = R"([camera]
eye = [0, -6, 2]
look_at = [0, 0, 1]
[render]
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

class Desktop : public Screen {
  protected:
    void SetUp() override {
        Screen::SetUp();
        if (!IsSkipped()) write("ball.toml", ball);
    }
};

TEST_F(Desktop, ADroppedFileIsOpened) {
    open("", {"--window", "700x500"});
    ASSERT_TRUE(wait_for_state("status", "empty"));
    ASSERT_TRUE(drop_file(display(), path("ball.toml")));
    ASSERT_TRUE(wait_for_state("status", "ready")) << map().dump(1);
    const std::string first = finished_picture();
    // Another takes its place; one that is not there leaves it.
    std::string text = ball;
    write("green.toml", text.replace(text.find("0.8, 0.1"), 8, "0.1, 0.8"));
    ASSERT_TRUE(drop_file(display(), path("green.toml")));
    ASSERT_TRUE(wait_until([&] { return state("picture_hash") != first; }));
    const std::string second = finished_picture();
    ASSERT_TRUE(drop_file(display(), path("missing.toml")));
    ASSERT_TRUE(wait_for_widget("errors"));
    EXPECT_EQ(finished_picture(), second);
}

TEST_F(Desktop, TheCameraIsCopiedAsTheTableOfASceneFile) {
    open("ball.toml", {"--window", "700x500"});
    const std::string before = finished_picture();
    press("Left");
    const std::string turned = finished_picture();
    ASSERT_NE(turned, before);
    press("ctrl+c");
    std::string copied;
    ASSERT_TRUE(wait_until([&] { return !(copied = clipboard(display())).empty(); }));
    ASSERT_TRUE(copied.starts_with("[camera]\n")) << copied;
    // Pasted over the file's own, it shows what the window showed.
    const std::string text = ball;
    ASSERT_GE(seconds_to_close(), 0);
    std::filesystem::remove(path("map"));
    write("ball.toml", copied + "\n" + text.substr(text.find("[render]")));
    open("ball.toml", {"--window", "700x500"});
    EXPECT_EQ(finished_picture(), turned);
}

} // namespace
} // namespace glint::test
