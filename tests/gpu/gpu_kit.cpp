#include "gpu_kit.h"

#include "gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace glint::gpu {
namespace {

struct Device {
    std::unique_ptr<GpuRenderer> renderer;
    std::string why;

    Device() {
        try {
            renderer = std::make_unique<GpuRenderer>();
        } catch (const Error& error) {
            why = error.diagnostics().front().message;
        }
    }
};

Device& the_device() {
    static Device device;
    return device;
}

} // namespace

GpuRenderer* gpu() { return the_device().renderer.get(); }
const std::string& why_no_gpu() { return the_device().why; }

Agreement agreement(const Image& gpu, const Image& cpu) {
    std::size_t far = 0;
    double sum = 0;
    std::size_t near = 0;
    for (std::size_t i = 0; i < cpu.pixels.size(); i += 3) {
        double most = 0;
        double relative = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            if (gpu.pixels[c] == cpu.pixels[c]) continue; // infinite ones too
            const double difference = std::abs(double(gpu.pixels[c]) - double(cpu.pixels[c]));
            most = std::isfinite(difference) ? std::max(most, difference) : 1;
            relative += difference / std::max(std::abs(double(cpu.pixels[c])), 1e-3);
        }
        if (most > 1.0 / 255) {
            ++far;
        } else {
            sum += relative;
            near += 3;
        }
    }
    return {3.0 * static_cast<double>(far) / static_cast<double>(cpu.pixels.size()),
            sum / static_cast<double>(std::max<std::size_t>(near, 1))};
}

void expect_agreement(const Image& gpu, const Image& cpu, const std::string& name) {
    const Agreement found = agreement(gpu, cpu);
    EXPECT_LE(found.far, 0.001) << name;
    EXPECT_LE(found.error, 1e-5) << name;
}

void expect_agreement(const SceneDescription& description, const std::string& name) {
    const Scene scene = build_scene(description);
    gpu()->prepare(scene);
    const Picture ours = gpu()->render();
    EXPECT_TRUE(ours.complete) << name;
    expect_agreement(ours.image, render(scene).image, name);
}

SceneDescription exhibit(const std::string& name, int samples) {
    for (kit::Exhibit& exhibit : kit::gallery())
        if (exhibit.name == name) {
            exhibit.scene.render.spp = samples;
            return exhibit.scene;
        }
    throw Error(ErrorKind::internal, "no exhibit " + name);
}

SceneDescription exhibit(const std::string& name, int width, int height, int samples) {
    SceneDescription scene = exhibit(name, samples);
    scene.render.width = width;
    scene.render.height = height;
    return scene;
}

std::string refusal(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device) << error.what();
        return error.what();
    }
    return "nothing was refused";
}

} // namespace glint::gpu
