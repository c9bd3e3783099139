#include "gpu/device_state.h"

#include "scene/scene_data.h"

#include <algorithm>
#include <utility>

namespace glint::gpu {

GpuDeviceState::GpuDeviceState(int device, const GpuLimits& limits) : context_(device), budget_(limits) {
    if (limits.buffer > 0) context_.set_max_buffer(std::min(limits.buffer, context_.device().max_buffer));
}

GpuDeviceState::~GpuDeviceState() {
    // Programs and buffers go while their context is current.
    const GpuScope scope(context_, std::nothrow);
    buffers_.reset();
    programs_.clear();
    show_program_.reset();
}

void GpuDeviceState::prepare(const Scene& scene) {
    const scene::SceneData& wanted = scene.data();
    if (wanted.description.render.integrator != Integrator::whitted)
        throw Error(ErrorKind::device, "graphics cards have no shader for this integrator",
                    "--backend cpu renders it");
    const std::optional<Scene> held = std::exchange(scene_, std::nullopt);
    if (held && held->data().all_but_view == wanted.all_but_view) {
        set_view(data_, wanted);
        scene_ = scene;
        return;
    }
    const bool same_tree = held && &held->data().world.data() == &wanted.world.data();
    std::unique_ptr<SceneBuffers> before = std::move(buffers_);
    if (!same_tree) before.reset();
    ++upload_count_;
    GpuSceneData data = flatten(wanted, same_tree ? &data_.tree : nullptr);
    buffers_ = std::make_unique<SceneBuffers>(context_, data, before.get());
    context_.check("laying out the scene");
    data.tree.nodes = {};
    data.tree.leaves = {};
    data.words = {};
    data.objects = {};
    data.shapes = {};
    data_ = std::move(data);
    scene_ = scene;
}

const GpuProgram& GpuDeviceState::program(bool terms, bool first_hit) {
    ProgramChoice choice = program_for(data_);
    choice.terms = terms;
    choice.first_hit = first_hit;
    auto& made = programs_[choice];
    if (made == nullptr) made = std::make_unique<GpuProgram>(context_, shader_source(choice));
    return *made;
}

const GpuProgram& GpuDeviceState::show_program() {
    if (show_program_ == nullptr) show_program_ = std::make_unique<GpuProgram>(context_, show_source());
    return *show_program_;
}

} // namespace glint::gpu
