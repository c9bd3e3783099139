// --backend and info --devices, with and without devices. No display is passed on to the program.

#include "workplace.h"

namespace glint::test {
namespace {

class Backend : public Workplace {
  public:
    /// No driver is found: as on a machine that has none.
    static Setting without_devices() {
        Setting setting;
        setting.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=none"};
        return setting;
    }
    bool has_device() const {
        return glint("info --devices").out.find("usable          yes") != std::string::npos;
    }
};

TEST_F(Backend, GpuRendersWithoutADisplay) {
    if (!has_device()) GTEST_SKIP() << "no device: " << glint("info --devices").out;
    const Outcome gpu = glint("good.toml --backend gpu -o gpu.png");
    EXPECT_EQ(gpu.exit, 0) << gpu.err;
    EXPECT_NE(gpu.err.find(", on "), std::string::npos) << gpu.err;
    EXPECT_EQ(glint("good.toml -o cpu.png").exit, 0);
    EXPECT_EQ(glint("diff gpu.png cpu.png --tolerance 1").exit, 0);
}

TEST_F(Backend, DebugViewsAreRenderedOnTheGpu) {
    if (!has_device()) GTEST_SKIP() << "no device: " << glint("info --devices").out;
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
    if (!has_device()) GTEST_SKIP() << "no device: " << glint("info --devices").out;
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
    if (glint("info --devices", old).out.find("usable          yes") != std::string::npos)
        GTEST_SKIP() << "a device that does not heed Mesa's variables";
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

} // namespace
} // namespace glint::test
