// glint-bench-picture-rays: traces only the rays of a picture. It collects all rays of all samples from the
// explanations of the pixels and traces them, without shading, in the batches that the renderer makes of
// them.

#include "rounds.h"

#include "glint/scene_files.h"
#include "render/camera_sampler.h"
#include "render/estimators/whitted.h"
#include "render/ray_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace glint::bench {

using trace::World;
namespace {

/// Side of the pixel blocks that are traced together.
constexpr int block = 16;

struct Batch {
    bool any = false; ///< any hit counts (shadow rays)
    std::vector<glint::Ray> rays;
};

/// The batches of one block: the rays of each depth, and the shadow rays to each light.
class Square {
  public:
    explicit Square(const scene::SceneData& scene) : scene_(scene) {}

    void add(const rendering::RayTree& tree) {
        for (const rendering::RayNode& node : tree.nodes) {
            glint::Ray ray;
            ray.origin = node.origin;
            ray.direction = node.direction;
            batches_[{node.depth, -1}].rays.push_back(ray);
            for (std::size_t i = 0; i < node.lights.size(); ++i)
                if (node.lights[i].asked) add(node.depth, static_cast<int>(i), node.lights[i]);
        }
    }
    void move_to(std::vector<Batch>& all) {
        for (auto& [key, batch] : batches_) all.push_back(std::move(batch));
        batches_.clear();
    }

  private:
    void add(int depth, int light, const rendering::LightNode& node) {
        glint::Ray ray;
        ray.origin = node.shadow_origin;
        ray.direction = node.shadow_direction;
        if (scene_.lights[static_cast<std::size_t>(light)].kind != light_directional) ray.tmax = 1.0f;
        Batch& batch = batches_[{depth, light}];
        batch.any = true;
        batch.rays.push_back(ray);
    }

    const scene::SceneData& scene_;
    std::map<std::pair<int, int>, Batch> batches_; ///< by depth and light
};

std::vector<Batch> batches_of(const scene::SceneData& scene) {
    const RenderSettings& settings = scene.description.render;
    const rendering::CameraSampler sampler(scene.description);
    rendering::Whitted tracer(scene);
    Square square(scene);
    std::vector<Batch> all;
    for (int y = 0; y < settings.height; y += block)
        for (int x = 0; x < settings.width; x += block) {
            for (std::uint32_t i = 0; i < block * block; ++i) {
                const int px = x + rendering::morton_x(i);
                const int py = y + rendering::morton_y(i);
                if (px >= settings.width || py >= settings.height) continue;
                const rendering::CameraSample sample = sampler.centre({px, py});
                rendering::RayTree tree;
                tracer.trace(sample, &tree);
                square.add(tree);
            }
            square.move_to(all);
        }
    return all;
}

/// Number of rays that fit into the cache together.
constexpr std::size_t warm_rays = 8192;

/// Traces batches after reading their rays once, as the renderer has just written them.
class Tracing {
  public:
    explicit Tracing(const World& world) : world_(world) {}

    double seconds_of(std::span<const Batch> batches) {
        for (const Batch& batch : batches) {
            hits_.resize(std::max(hits_.size(), batch.rays.size()));
            blocked_.resize(hits_.size());
            for (const glint::Ray& ray : batch.rays) sum_ += ray.origin.x + ray.direction.x;
        }
        const double start = thread_seconds();
        for (const Batch& batch : batches) trace(batch);
        return thread_seconds() - start;
    }
    float sum() const { return sum_; }

  private:
    void trace(const Batch& batch) {
        const std::size_t count = batch.rays.size();
        if (batch.any)
            world_.occluded(batch.rays, {blocked_.data(), count}, glint::RayHint::coherent, scratch_);
        else
            world_.closest(batch.rays, {hits_.data(), count}, glint::RayHint::coherent, scratch_);
    }

    const World& world_;
    World::Scratch scratch_;
    std::vector<trace::Hit> hits_;
    std::vector<std::uint8_t> blocked_;
    float sum_ = 0; ///< keeps the compiler from removing the reads
};

double seconds_of(const World& world, std::span<const Batch> batches) {
    Tracing tracing(world);
    double seconds = 0;
    while (!batches.empty()) {
        std::size_t some = 0;
        for (std::size_t rays = 0; some < batches.size() && rays < warm_rays; ++some)
            rays += batches[some].rays.size();
        seconds += tracing.seconds_of(batches.first(some));
        batches = batches.subspan(some);
    }
    if (std::isinf(tracing.sum())) throw std::runtime_error("the picture sends infinite rays");
    return seconds;
}

void run(const std::string& file, int rounds) {
    BuildSceneOptions options;
    options.threads = 1;
    const Scene scene = build_scene(load_scene(file).description, options);
    if (scene.render_settings().spp != 1) throw std::invalid_argument("the scene needs spp = 1 in [render]");
    const std::vector<Batch> batches = batches_of(scene.data());
    std::size_t rays = 0;
    for (const Batch& batch : batches) rays += batch.rays.size();
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) seconds.push_back(seconds_of(scene.data().world, batches));
    fmt::print("{} rays, {:.4f} CPU s\n", rays, median(seconds));
}

} // namespace
} // namespace glint::bench

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.empty() || arguments.size() > 2 || arguments[0].starts_with('-')) {
        std::cerr
            << "usage: glint-bench-picture-rays SCENE [ROUNDS]   (one sample a pixel; the median of 5)\n";
        return !arguments.empty() && (arguments[0] == "--help" || arguments[0] == "-h") ? 0 : 2;
    }
    try {
        glint::bench::run(arguments[0], arguments.size() == 2 ? std::max(1, std::stoi(arguments[1])) : 5);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "glint-bench-picture-rays: " << error.what() << '\n';
        return 3;
    }
}
