// Tracing sets of rays on the device and comparing them with the CPU.

#include "gpu_rays.h"

#include "agreement.h"
#include "gpu/rays.h"
#include "rays.h"
#include "rounds.h"

#include <cmath>

namespace glint::bench {

using gpu::GpuHit;
using gpu::GpuRays;

namespace {

/// Traversal steps of all traced rays.
struct Steps {
    std::uint64_t nodes = 0;
    std::uint64_t shapes = 0;
};

std::vector<GpuHit> trace(GpuRays& device, std::span<const Ray> rays, bool any, Steps* steps) {
    std::vector<gpu::GpuRay> sent;
    sent.reserve(rays.size());
    for (const Ray& ray : rays) sent.push_back({origin_of(ray), direction_of(ray), ray.tmax});
    std::vector<GpuHit> hits = device.trace(sent, any);
    if (steps != nullptr)
        for (const GpuHit& hit : hits) {
            steps->nodes += hit.nodes;
            steps->shapes += hit.shapes;
        }
    return hits;
}

/// The device as a peer.
Peer gpu_peer(GpuRays& device, Steps* steps = nullptr) {
    Peer peer;
    peer.name = "GPU";
    peer.closest = [&device, steps](std::span<const Ray> rays, std::span<Hit> hits, RayHint) {
        const std::vector<GpuHit> found = trace(device, rays, false, steps);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            hits[i] = Hit{};
            if (found[i].object != invalid_index)
                hits[i] = {found[i].t, found[i].u, found[i].v, found[i].prim};
        }
    };
    peer.occluded = [&device, steps](std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint) {
        const std::vector<GpuHit> found = trace(device, rays, true, steps);
        for (std::size_t i = 0; i < blocked.size(); ++i) blocked[i] = found[i].object != invalid_index;
    };
    return peer;
}

GpuSetResult measure_set(const Job& job, GpuRays& timed, GpuRays& counted, const Peer& cpu, int rounds) {
    GpuSetResult result{job.name, job.rays, 0, 0, 0, 0};
    const Peer peer = gpu_peer(timed);
    result.differences = different_answers(answers_of(job, peer), answers_of(job, cpu));
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) {
        const double before = timed.seconds();
        answers_of(job, peer);
        seconds.push_back(timed.seconds() - before);
    }
    result.seconds = median(seconds);
    Steps steps;
    answers_of(job, gpu_peer(counted, &steps));
    result.nodes = static_cast<double>(steps.nodes) / static_cast<double>(job.rays);
    result.triangles = static_cast<double>(steps.shapes) / static_cast<double>(job.rays);
    return result;
}

GpuSetResult measure_frame(GpuRenderer& renderer, const Model& model, int size, int rounds) {
    const Scene scene = build_scene(scene_of(model, size));
    renderer.prepare(scene);
    const Picture picture = renderer.render();
    GpuSetResult result{"frame", picture.stats.rays(), 0, 0, 0, 0};
    const Comparison found = compare(picture.image, render(scene).image, 1.0 / 255, 1);
    result.differences = static_cast<std::uint64_t>(std::lround(found.share * size * size));
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) seconds.push_back(renderer.render().stats.device_seconds);
    result.seconds = median(seconds);
    return result;
}

} // namespace

SceneDescription scene_of(const Model& model, int size) {
    SceneDescription scene;
    Material material;
    material.name = "mesh";
    material.reflectivity = 0.3;
    scene.materials.push_back(material);
    MeshShape shape;
    shape.data = model.mesh;
    Object object;
    object.name = "mesh";
    object.material = material.name;
    object.shape = shape;
    scene.objects.push_back(object);
    PointLight light;
    light.position = Vec3(model.light);
    light.intensity = double(model.diagonal) * model.diagonal;
    scene.lights.push_back({light, {}});
    CameraDescription camera;
    camera.eye = Vec3(model.camera.eye);
    camera.direction = Vec3(model.camera.forward);
    camera.up = Vec3(model.camera.up);
    camera.fov = 2 * std::atan(double(model.camera.half)) * 180 / 3.14159265358979323846;
    scene.camera = camera;
    scene.whitted.max_depth = 1;
    scene.render.width = size;
    scene.render.height = size;
    scene.render.spp = 1;
    return scene;
}

std::vector<GpuSetResult> measure_gpu_rays(const gpu::GpuContext& context, GpuRenderer& renderer,
                                           const Model& model, const JobOptions& options, int rounds) {
    const tracing::Mesh mesh = build_ours(model, tracing::BuildQuality::high, 0);
    const Peer cpu = our_peer(mesh);
    const Scene scene = build_scene(scene_of(model, options.size));
    GpuRays timed(context, scene.data(), false);
    GpuRays counted(context, scene.data(), true);
    // Batches as large as a buffer of the device allows.
    JobOptions whole = options;
    whole.batch =
        std::min<std::size_t>(context.device().max_buffer / sizeof(gpu::GpuRay), std::size_t{1} << 22);
    std::vector<GpuSetResult> results;
    for (const std::string set : {"primary", "shadow", "ao", "bounce"})
        results.push_back(measure_set(make_job(set, model, mesh, whole), timed, counted, cpu, rounds));
    results.push_back(measure_frame(renderer, model, options.size, rounds));
    return results;
}

} // namespace glint::bench
