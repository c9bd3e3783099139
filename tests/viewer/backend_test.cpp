// Rendering on the GPU in the window. Mesa's software renderer stands in: same shaders, same calls.

#include "../cli/process.h"
#include "driver.h"

#include "glint/picture_files.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

namespace glint::test {
namespace {

/// No pixel of it is black.
const std::string scene = R"(version = 1
[camera]
eye = [0, -6, 2]
look_at = [0, 0, 1]
fov = 40
[render]
size = [200, 150]
spp = 3
background = [0.2, 0.4, 0.8]
[material.floor]
color = [0.5, 0.5, 0.4]
[material.mirror]
color = [0.3, 0.2, 0.2]
reflectivity = 0.6
[[plane]]
normal = [0, 0, 1]
material = "floor"
[[sphere]]
name = "ball"
center = [0, 0, 1]
radius = 1
material = "mirror"
[[light]]
type = "ambient"
color = [0.3, 0.3, 0.3]
[[light]]
type = "point"
position = [-3, -4, 6]
intensity = 40
)";

class WindowOnTheGpu : public Screen {
  protected:
    void open_scene(const std::string& text, const std::vector<std::string>& options = {}) {
        write("scene.toml", text);
        std::vector<std::string> arguments{"--window", "1000x640", "--size", "200x150", "--ui-debug"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        open("scene.toml", arguments);
    }

    static std::string with(const std::string& what, const std::string& instead) {
        std::string text = scene;
        const std::size_t at = text.find(what);
        if (at == std::string::npos) throw std::logic_error("the scene has no " + what);
        return text.replace(at, what.size(), instead);
    }

    /// Opens a list and clicks on a line once its position is stable: lists move while they open.
    void choose(const std::string& list, const std::string& line) const {
        click(list);
        const std::string widget = list + ":" + line;
        ASSERT_TRUE(wait_for_widget(widget));
        Spot last;
        int equal = 0;
        ASSERT_TRUE(wait_until([&] {
            if (!has(widget)) return false;
            const Spot now = spot(widget);
            equal = now.x == last.x && now.y == last.y ? equal + 1 : 0;
            last = now;
            return equal >= 15;
        })) << widget;
        click(widget);
    }

    bool is_drawn_by_gpu() const {
        const nlohmann::json by = state("drawn_by");
        return by.is_string() && by != "CPU";
    }

    /// The picture that `glint` renders of the scene, by backend.
    Image rendered(const std::string& backend) const {
        const std::string file = path(backend + ".exr");
        const Outcome outcome =
            run_glint({path("scene.toml"), "--backend", backend, "-o", file, "-q", "--size", "200x150"}, {});
        EXPECT_EQ(outcome.exit, 0) << outcome.err;
        return read_picture(file).image;
    }

    void expect_no_opengl_message() {
        EXPECT_EQ(state("opengl.messages"), 0);
        EXPECT_GE(seconds_to_close(), 0);
        EXPECT_EQ(viewer().ended(), 0) << log();
        EXPECT_EQ(log().find("OpenGL"), std::string::npos) << log();
    }

    /// Resident memory in MiB.
    double memory() {
        std::ifstream in("/proc/" + std::to_string(viewer().pid()) + "/statm");
        double all = 0;
        double resident = 0;
        in >> all >> resident;
        return resident * 4096 / (1 << 20);
    }
};

TEST_F(WindowOnTheGpu, DrawsWhatTheCommandLineRendersThere) {
    open_scene(scene, {"--backend", "gpu"});
    const std::string hash = finished_picture();
    EXPECT_EQ(state("backend"), "gpu");
    EXPECT_TRUE(is_drawn_by_gpu()) << state("why_cpu");
    EXPECT_EQ(hash, picture_hash(rendered("gpu")));
    const Comparison to_cpu = compare(rendered("gpu"), rendered("cpu"), 1.0 / 255, 1);
    EXPECT_LE(to_cpu.share, 0.001);

    // The camera moves and comes back.
    press("Left");
    const std::string turned = finished_picture();
    EXPECT_NE(turned, hash);
    EXPECT_TRUE(is_drawn_by_gpu());
    press("Home");
    EXPECT_EQ(finished_picture(), hash);

    // The saved picture and the screen show the same.
    press("ctrl+p");
    ASSERT_TRUE(wait_until([&] { return state("saved").is_string(); })) << log();
    EXPECT_EQ(wrong_on_screen(read_picture(state("saved").get<std::string>()).image), 0);
    expect_no_opengl_message();
}

TEST_F(WindowOnTheGpu, AnExplanationSaysHowFarTheCardIsFromIt) {
    open_scene(scene, {"--backend", "gpu"});
    finished_picture();
    click(spot("picture", 0.5, 0.6));
    ASSERT_TRUE(wait_until([&] {
        const nlohmann::json devices = state("pixel.devices");
        return devices.is_string() && devices.get<std::string>().find("off by at most") != std::string::npos;
    })) << map().dump(1);
    const int x = static_cast<int>(state("pixel.x").get<double>());
    const int y = static_cast<int>(state("pixel.y").get<double>());
    const Image card = rendered("gpu");
    const std::string devices = state("pixel.devices");
    // The reported colour is that of the GPU's pixel.
    for (int c = 0; c < 3; ++c)
        EXPECT_NE(devices.find(fmt::format("{:.6g}", card.at(x, y)[c])), std::string::npos) << devices;
    press("g");
    EXPECT_TRUE(wait_for_state("pixel.devices", "")) << "the CPU draws what the CPU explains";
    expect_no_opengl_message();
}

TEST_F(WindowOnTheGpu, DrawsOtherViewsToo) {
    open_scene(scene, {"--backend", "gpu"});
    finished_picture();
    click("tab:picture");
    ASSERT_TRUE(wait_for_widget("backend"));
    const std::string light = finished_picture();
    choose("show", "depth");
    ASSERT_TRUE(wait_for_state("show", "depth"));
    const std::string depth = finished_picture();
    EXPECT_NE(depth, light);
    EXPECT_TRUE(is_drawn_by_gpu());
    EXPECT_FALSE(map()["state"].contains("why_cpu"));
    press("f");
    ASSERT_TRUE(wait_for_state("show", "final"));
    EXPECT_EQ(finished_picture(), light);
    EXPECT_TRUE(is_drawn_by_gpu());
    choose("backend", "CPU");
    ASSERT_TRUE(wait_for_state("backend", "cpu")) << map().dump(1);
    ASSERT_TRUE(wait_for_state("drawn_by", "CPU"));
    EXPECT_EQ(finished_picture(), picture_hash(rendered("cpu")));
    expect_no_opengl_message();
}

TEST_F(WindowOnTheGpu, TermsOfTheLightStayOnTheDevice) {
    open_scene(with("reflectivity = 0.6", "reflectivity = 0.4\ntransparency = 0.3\nhighlight = 0.8\n"
                                          "emission = [0.05, 0.1, 0.02]"),
               {"--backend", "gpu"});
    finished_picture();
    EXPECT_EQ(state("on_device"), true);
    for (const std::string term :
         {"ambient", "diffuse", "highlight", "clamp", "reflection", "transmission", "emission", "shadows"}) {
        press("v");
        ASSERT_TRUE(wait_for_state("show", term));
        finished_picture();
        EXPECT_TRUE(is_drawn_by_gpu()) << term;
        // What was clamped, and numbers that are no light, become colours in memory.
        EXPECT_EQ(state("on_device"), term != "clamp" && term != "shadows") << term;
        const std::string file = path(term + ".png");
        const Outcome outcome =
            run_glint({path("scene.toml"), "--show", term, "-o", file, "-q", "--size", "200x150"}, {});
        ASSERT_EQ(outcome.exit, 0) << outcome.err;
        EXPECT_EQ(wrong_on_screen(read_picture(file).image), 0) << term;
    }
    expect_no_opengl_message();
}

TEST_F(WindowOnTheGpu, AFaultIsToldAndTheCpuDraws) {
    // A ray inside more transparent solids than the shader supports.
    std::string balls = with("[[light]]", "[material.air]\ntransparency = 0.9\nindex = 1.1\n[[light]]");
    for (int i = 0; i < 9; ++i)
        balls += "[[sphere]]\ncenter = [0, 0, 1]\nradius = " + std::to_string(0.9 - 0.05 * i) +
                 "\nmaterial = \"air\"\n";
    balls.replace(balls.find("reflectivity = 0.6"), 18, "transparency = 0.9");
    open_scene(balls, {"--backend", "gpu"});
    EXPECT_EQ(finished_picture(), picture_hash(rendered("cpu")));
    EXPECT_EQ(state("backend"), "gpu");
    EXPECT_EQ(state("drawn_by"), "CPU");
    EXPECT_NE(state("why_cpu").get<std::string>().find("more than eight transparent solids"),
              std::string::npos);
    write("scene.toml", scene);
    ASSERT_TRUE(wait_until([&] { return is_drawn_by_gpu(); })) << "the next scene is tried there again";
    EXPECT_EQ(finished_picture(), picture_hash(rendered("gpu")));
    expect_no_opengl_message();
}

TEST_F(WindowOnTheGpu, SwitchingTwoHundredTimesNeitherFlashesNorLeaks) {
    open_scene(with("spp = 3", "spp = 4096"), {"--backend", "gpu"});
    const auto wait_for_gpu = [&] {
        return wait_until(
            [&] { return is_drawn_by_gpu() && state("samples").is_number() && state("samples") >= 1; });
    };
    const auto held = [&] {
        const nlohmann::json all = map()["state"];
        return std::pair(all["opengl.textures"].get<double>(), all["opengl.buffers"].get<double>());
    };
    // Both backends have rendered and hold their memory.
    ASSERT_TRUE(wait_for_gpu()) << map().dump(1);
    press("g");
    ASSERT_TRUE(wait_for_state("drawn_by", "CPU"));
    press("g");
    ASSERT_TRUE(wait_for_gpu());
    const Image calm = screenshot();
    const auto objects = held();
    const double before = memory();

    const nlohmann::json area = map()["widgets"]["picture"];
    // Below the notice about the backend.
    const auto side = [&](std::size_t i) { return static_cast<int>(area[i].get<double>()); };
    double worst = 0;
    for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 10; ++i) press("g");
        const Image shown = screenshot();
        int flashes = 0;
        for (int y = side(1); y < side(1) + side(3) * 2 / 3; ++y)
            for (int x = side(0); x < side(0) + side(2); ++x) {
                double far = 0;
                for (int c = 0; c < 3; ++c)
                    far = std::max<double>(far, std::abs(shown.at(x, y)[c] - calm.at(x, y)[c]));
                flashes += far > 0.25 * 255;
            }
        worst = std::max(worst, flashes / (side(2) * (side(3) * 2.0 / 3)));
    }
    // Edges differ: antialiased in one, not yet in the other.
    EXPECT_LT(worst, 0.02);
    ASSERT_TRUE(wait_for_gpu());
    EXPECT_LE(held().first, objects.first);
    EXPECT_LE(held().second, objects.second);
    const double growth = memory() - before;
    RecordProperty("MiB", std::to_string(growth));
    EXPECT_LT(growth, 24);
    expect_no_opengl_message();
}

TEST_F(WindowOnTheGpu, WithoutACardAutoTakesTheCpu) {
    open_scene(scene);
    EXPECT_EQ(finished_picture(), picture_hash(rendered("cpu")));
    EXPECT_EQ(state("backend"), "cpu");
    EXPECT_EQ(state("drawn_by"), "CPU");
    expect_no_opengl_message();
}

} // namespace
} // namespace glint::test
