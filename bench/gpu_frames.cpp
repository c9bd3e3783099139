// Rendering and comparing whole pictures.

#include "gpu_frames.h"

#include "glint/image.h"
#include "glint/scene_files.h"
#include "gpu_rays.h"
#include "math/bounds.h"
#include "rounds.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace glint::bench {

FrameResult measure_frame_of(GpuRenderer& renderer, const std::string& name, SceneDescription scene,
                             const FrameSize& size, int rounds) {
    std::cerr << "  " << name << '\n';
    FrameResult result;
    result.scene = name;
    scene.render.width = size.width;
    scene.render.height = size.height;
    scene.render.spp = 1;
    const Scene scene_data = build_scene(scene);
    result.triangles = scene_data.stats().triangles;
    try {
        renderer.prepare(scene_data);
        const Picture first =
            renderer.render(); // warm-up: the driver compiles, and the renderer adapts its dispatch size
        result.rays = first.stats.rays();
        result.far = compare(first.image, render(scene_data).image, 1.0 / 255, 1).share;
        std::vector<double> device, whole;
        for (int round = 0; round < rounds; ++round) {
            const RenderStats stats = renderer.render().stats;
            device.push_back(stats.device_seconds);
            whole.push_back(stats.wall_seconds);
        }
        result.device_seconds = median(device);
        result.whole_seconds = median(whole);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::device) throw;
        result.fault = error.diagnostics().front().message;
    }
    return result;
}

std::vector<FrameResult> measure_folder(GpuRenderer& renderer, const std::string& folder,
                                        const FrameSize& size, int rounds) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<FrameResult> results;
    for (const fs::path& file : files) {
        try {
            results.push_back(measure_frame_of(renderer, file.stem().string(),
                                               load_scene(file.string()).description, size, rounds));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            std::cerr << "  left out: " << error.diagnostics().front().message << '\n';
        }
    }
    return results;
}

SceneDescription field_of(const Model& model, double triangles) {
    const double each = static_cast<double>(model.mesh->triangles.size());
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / each))));
    const double apart = model.diagonal;
    SceneDescription scene = scene_of(model, 64);
    for (int i = 1; i < side * side; ++i) {
        Object object;
        object.name = "copy " + std::to_string(i);
        object.shape = InstanceShape{"mesh"};
        object.transform[3][0] = apart * (i % side);
        object.transform[3][1] = apart * (i / side);
        scene.objects.push_back(object);
    }
    scene.camera.reset(); // so that the scene is framed
    const double middle = 0.5 * apart * (side - 1);
    PointLight light;
    light.position = Vec3(middle, middle, apart * side);
    light.intensity = apart * apart * side * side;
    scene.lights = {{light, {}}};
    return scene;
}

} // namespace glint::bench
