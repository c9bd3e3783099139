// Contexts of OpenGL that cannot be entered, as those of a lost device.

#include "gpu_kit.h"

#include "gpu/context.h"
#include "gpu/device_state.h"
#include "gpu/picture.h"
#include "gpu/rays.h"
#include "scene/scene_data.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <thread>

namespace glint::gpu {
namespace {

/// Does something on a thread of its own, on which no context is current.
void elsewhere(const std::function<void()>& work) { std::thread(work).join(); }

TEST(GpuContexts, OneThreadAtATimeHasThem) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    EXPECT_FALSE(context.is_current());
    const GpuScope scope(context);
    EXPECT_TRUE(context.is_current());
    elsewhere([&] {
        EXPECT_FALSE(context.is_current());
        EXPECT_FALSE(context.try_enter());
        EXPECT_NE(refusal([&] { context.enter(); }).find("cannot be used from this thread"),
                  std::string::npos);
    });
}

TEST(GpuContexts, WhatEndsWhereTheyCannotBeEnteredIsLeftToThem) {
    GLINT_NEEDS_GPU();
    const Scene scene = build_scene(exhibit("mirrors"));
    const GpuContext context(-1);
    auto rays = std::make_unique<GpuRays>(context, scene.data(), false);
    auto device_state = std::make_unique<GpuDeviceState>(-1, GpuLimits{});
    {
        const GpuScope scope(device_state->context());
        device_state->prepare(scene);
        device_state->program(false, false);
        auto pool = std::make_unique<GpuPicturePool>(device_state->context());
        pool->take(8, 8)->was_drawn();
        elsewhere([&] { pool.reset(); });
        device_state->context().check("ending a pool elsewhere");
    }
    {
        const GpuScope scope(context);
        elsewhere([&] { rays.reset(); });
        context.check("ending rays elsewhere");
    }
    // Its own context goes with it, and is current here until another takes its place.
    device_state->context().enter();
    elsewhere([&] { device_state.reset(); });
    const GpuScope scope(context);
    context.check("ending a device state elsewhere");
}

} // namespace
} // namespace glint::gpu
