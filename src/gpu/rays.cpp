#include "gpu/rays.h"

#include "scene/scene_data.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace glint::gpu {
namespace {

/// Rays of a dispatch: enough to fill the device, few enough to keep the desktop responsive.
constexpr std::size_t rays_on_a_card = std::size_t{1} << 20;
constexpr std::size_t rays_in_software = std::size_t{1} << 14;

} // namespace

GpuRays::GpuRays(const GpuContext& context, const scene::SceneData& scene, bool count_steps)
    : context_(context) {
    const GpuScope scope(context);
    const GpuSceneData data = flatten(scene);
    ProgramChoice choice = program_for(data);
    choice.rays = true;
    choice.count = count_steps;
    parts_.reset(new Parts{
        data.settings, {context, data, nullptr}, {context, shader_source(choice)}, GpuTimer(context)});
}

GpuRays::~GpuRays() {
    const GpuScope scope(context_, std::nothrow);
    parts_.reset();
}

std::vector<GpuHit> GpuRays::trace(std::span<const GpuRay> rays, bool any) {
    const GpuScope scope(context_);
    const GpuBuffer work(context_, "the rays", rays.data(), rays.size_bytes());
    parts_->scene.bind();
    work.bind_storage(6);
    const std::size_t most = context_.device().software ? rays_in_software : rays_on_a_card;
    for (std::size_t first = 0; first < rays.size(); first += most) {
        const std::size_t past = std::min(first + most, rays.size());
        GpuSettings settings = parts_->settings;
        settings.first_slot = static_cast<std::uint32_t>(first);
        settings.end_slot = static_cast<std::uint32_t>(past);
        settings.any_hit = any ? 1 : 0;
        parts_->timer.start();
        parts_->program.dispatch(settings, past - first);
        parts_->timer.stop();
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        seconds_ += parts_->timer.seconds();
        context_.check("tracing rays");
    }
    std::vector<GpuHit> hits(rays.size());
    work.read(0, hits.data(), rays.size_bytes());
    context_.check("reading hits");
    return hits;
}

} // namespace glint::gpu
