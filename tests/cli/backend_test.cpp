// --backend and info --devices, with and without devices. No display is passed on to the program.

#include "cli_test.h"

#include <nlohmann/json.hpp>

namespace glint::test {
namespace {

using nlohmann::json;

class Backend : public CliTest {};

TEST_F(Backend, GpuRendersWithoutADisplay) {
    GLINT_NEEDS_DEVICE();
    const Outcome gpu = glint("good.toml --backend gpu -o gpu.png");
    EXPECT_EQ(gpu.exit, 0) << gpu.err;
    EXPECT_NE(gpu.err.find(", on "), std::string::npos) << gpu.err;
    EXPECT_EQ(glint("good.toml -o cpu.png").exit, 0);
    EXPECT_EQ(glint("diff gpu.png cpu.png --tolerance 1").exit, 0);
}

TEST_F(Backend, DebugViewsAreRenderedOnTheGpu) {
    GLINT_NEEDS_DEVICE();
    for (const std::string view : {"normal", "depth", "shadows", "diffuse"}) {
        const Outcome gpu = glint("good.toml --backend gpu --show " + view + " -o gpu.png");
        EXPECT_EQ(gpu.exit, 0) << gpu.err;
        EXPECT_NE(gpu.err.find(", on "), std::string::npos) << gpu.err;
        EXPECT_EQ(glint("good.toml --show " + view + " -o cpu.png").exit, 0);
        EXPECT_EQ(glint("diff gpu.png cpu.png --tolerance 1").exit, 0) << view;
    }
    EXPECT_EQ(glint("good.toml --backend gpu --show cost -o cost.pfm").exit, 0);
}

TEST_F(Backend, FramesOfOneAnimationShareTheCard) {
    GLINT_NEEDS_DEVICE();
    write("moving.toml", content("good.toml") + "\n[[animate]]\nkey = \"camera.fov\"\nframes = [0, 2]\n"
                                                "values = [30, 60]\n");
    const Outcome all = glint("moving.toml --backend gpu --frames 0..2 -o gpu-%d.pfm");
    ASSERT_EQ(all.exit, 0) << all.err;
    for (const std::string frame : {"0", "1", "2"}) {
        ASSERT_EQ(glint("moving.toml --backend gpu --frames " + frame + " -o alone.pfm").exit, 0);
        EXPECT_EQ(content("gpu-" + frame + ".pfm"), content("alone.pfm")) << frame;
    }
    EXPECT_NE(content("gpu-0.pfm"), content("gpu-2.pfm"));
}

TEST_F(Backend, AutoSaysItsReasonOnceForAllFrames) {
    const Outcome outcome = glint("good.toml --backend auto --frames 0..2 -o f-%d.png", without_devices());
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
    const std::size_t first = outcome.err.find("on the CPU: ");
    ASSERT_NE(first, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("on the CPU: ", first + 1), std::string::npos) << outcome.err;
}

TEST_F(Backend, GpuWithoutADeviceEndsWithSevenAndAReason) {
    const Outcome outcome = glint("good.toml --backend gpu -o a.png", without_devices());
    EXPECT_EQ(outcome.exit, 7);
    EXPECT_NE(outcome.err.find("no GPU"), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("a.png"));
}

TEST_F(Backend, OldOpenGlIsToldWithACure) {
    Setting old;
    old.environment = {"MESA_GL_VERSION_OVERRIDE=3.3"};
    if (has_device(old)) GTEST_SKIP() << "a device that does not heed Mesa's variables";
    const Outcome outcome = glint("good.toml --backend gpu -o a.png", old);
    EXPECT_EQ(outcome.exit, 7);
    if (has_device()) {
        EXPECT_NE(outcome.err.find("it has no OpenGL 4.3"), std::string::npos) << outcome.err;
    }
    EXPECT_NE(outcome.err.find("--backend cpu needs none"), std::string::npos) << outcome.err;
}

TEST_F(Backend, AutoTakesTheCpuAndSaysWhyInOneLine) {
    const Outcome outcome = glint("good.toml --backend auto -o a.png", without_devices());
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("on the CPU: ", 0), 0u) << outcome.err;
    EXPECT_EQ(glint("good.toml -o b.png").exit, 0);
    EXPECT_EQ(content("a.png"), content("b.png"));
}

TEST_F(Backend, DevicesAreListedWithoutAFile) {
    const Outcome none = glint("info --devices", without_devices());
    EXPECT_EQ(none.exit, 0);
    EXPECT_NE(none.out.find("no devices for --backend gpu: "), std::string::npos) << none.out;
    EXPECT_EQ(glint("info --devices good.toml").exit, 2);
    EXPECT_EQ(glint("info").exit, 2);
}

TEST_F(Backend, DevicesAreListedForPrograms) {
    const Outcome none = glint("info --devices --json", without_devices());
    EXPECT_EQ(none.exit, 0);
    const json nothing = json::parse(none.out);
    EXPECT_EQ(nothing["devices"], json::array());
    EXPECT_NE(nothing["fault"], "");

    GLINT_NEEDS_DEVICE();
    const std::string text = glint("info --devices").out;
    const json found = json::parse(glint("info --devices --json").out);
    EXPECT_FALSE(found.contains("fault"));
    bool any = false;
    for (std::size_t i = 0; i < found["devices"].size(); ++i) {
        const json& device = found["devices"][i];
        EXPECT_EQ(device["number"], i);
        const std::string line = std::to_string(i) + ": " + device["name"].get<std::string>() + "\n";
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
        EXPECT_EQ(device["usable"], !device.contains("fault"));
        if (!device["usable"]) continue;
        any = true;
        EXPECT_NE(text.find(device["driver"].get<std::string>()), std::string::npos) << text;
        EXPECT_GE(device["largest_buffer"], 1 << 24);
        EXPECT_GE(device["buffers"], 8);
        EXPECT_GE(device["largest_group"], 64);
        EXPECT_TRUE(device["software"].is_boolean());
    }
    EXPECT_TRUE(any);
}

TEST_F(Backend, ARefusedShaderIsToldWithTheDriversLog) {
    Setting old;
    old.environment = {"MESA_GL_VERSION_OVERRIDE=4.5", "MESA_GLSL_VERSION_OVERRIDE=330"};
    if (!has_device(old)) GTEST_SKIP() << "no device: " << glint("info --devices", old).out;
    const Outcome outcome = glint("good.toml --backend gpu -o a.png", old);
    if (outcome.exit == 0) GTEST_SKIP() << "a device that does not heed Mesa's variables";
    EXPECT_EQ(outcome.exit, 7);
    const std::size_t log = outcome.err.find("refuses the shader:\n");
    ASSERT_NE(log, std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("error", log), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("a.png"));
}

} // namespace
} // namespace glint::test
