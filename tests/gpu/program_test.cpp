// Shaders and buffers that a driver refuses say where and why.

#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu_kit.h"

#include <gtest/gtest.h>

namespace glint::gpu {
namespace {

TEST(GpuProgram, LogsNameFilesInTheFormsOfAllDrivers) {
    EXPECT_EQ(readable_log("1:12(3): error: x"), "math/shared.h:12(3): error: x\n");
    EXPECT_EQ(readable_log("2(7) : error C1: x"), "math/elementary.shared.h:7 : error C1: x\n");
    EXPECT_EQ(readable_log("ERROR: 1:9: 'a' : x"), "ERROR: math/shared.h:9: 'a' : x\n");
    EXPECT_EQ(readable_log("nothing of the kind\n99:1: x\n"), "nothing of the kind\n99:1: x\n");
}

TEST(GpuProgram, ARefusedShaderIsNamedByFileAndLine) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    const GpuScope scope(context);
    std::string source = shader_source({});
    const std::string sound = "real spot_falloff(";
    ASSERT_NE(source.find(sound), std::string::npos);
    source.replace(source.find(sound), sound.size(), "reel spot_falloff(");
    try {
        const GpuProgram program(context, source);
        FAIL() << "was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device);
        EXPECT_NE(std::string(error.what()).find("shading/whitted.shared.h:"), std::string::npos)
            << error.what();
    }
}

TEST(GpuProgram, ABufferBeyondTheDevicesLimitIsRefusedWithTheSizes) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    const GpuScope scope(context);
    const auto bytes = static_cast<std::size_t>(context.device().max_buffer) + 1;
    try {
        const GpuBuffer buffer(context, "the triangles", nullptr, bytes);
        FAIL() << "was taken";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("the triangles take " + std::to_string(bytes) + " bytes"), std::string::npos)
            << text;
        EXPECT_NE(text.find("holds " + std::to_string(bytes - 1)), std::string::npos) << text;
    }
}

TEST(GpuProgram, DriversHaveNothingToComplainOf) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    const GpuScope scope(context);
    const GpuBuffer buffer(context, "test", nullptr, 1000);
    const int value = 7;
    buffer.write(4, &value, sizeof value);
    int back = 0;
    buffer.read(4, &back, sizeof back);
    EXPECT_EQ(back, 7);
    context.check("testing");
    EXPECT_TRUE(context.complaints().empty()) << context.complaints().front();
}

} // namespace
} // namespace glint::gpu
