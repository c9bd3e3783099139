#pragma once
// What tests of the GPU share: one renderer, for drivers take long to compile, and how far two pictures are
// apart.

#include "glint/gpu.h"

#include <functional>
#include <string>

namespace glint::gpu {

/// The renderer of this process, or null where no device can be used; then `why_no_gpu` has the reason.
GpuRenderer* gpu();
const std::string& why_no_gpu();

/// Ends a test where there is no device, and says so.
#define GLINT_NEEDS_GPU()                                                                                    \
    if (glint::gpu::gpu() == nullptr) GTEST_SKIP() << "no GPU: " << glint::gpu::why_no_gpu()

/// How a picture of the GPU agrees with the CPU's.
struct Agreement {
    double far = 0;   ///< share of the pixels that are off by more than 1/255 in a channel
    double error = 0; ///< over the others the mean of |a − b| / max(|b|, 1e-3)
};
Agreement agreement(const Image& gpu, const Image& cpu);

/// Fails where two pictures agree less than the backend promises.
void expect_agreement(const Image& gpu, const Image& cpu, const std::string& name);
/// Fails where the scene's pictures agree less than the backend promises.
void expect_agreement(const SceneDescription& description, const std::string& name);

/// A scene of the tests' gallery, by name.
SceneDescription exhibit(const std::string& name, int samples = 1);
SceneDescription exhibit(const std::string& name, int width, int height, int samples);

/// What the device says against some work; it must be an Error(device).
std::string refusal(const std::function<void()>& work);

} // namespace glint::gpu
