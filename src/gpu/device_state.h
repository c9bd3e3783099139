#pragma once
// A device: its context, compiled programs, and the scene in its memory.

#include "gpu/context.h"
#include "gpu/dispatch_budget.h"
#include "gpu/program.h"
#include "gpu/scene_buffers.h"
#include "gpu/scene_data.h"

#include <map>
#include <memory>
#include <optional>

namespace glint::gpu {

/// All but the constructors needs the context to be entered.
class GpuDeviceState {
  public:
    GpuDeviceState(int device, const GpuLimits& limits);
    explicit GpuDeviceState(GpuCurrentContext current) : context_(current), budget_({}) {}
    ~GpuDeviceState();
    GpuDeviceState(const GpuDeviceState&) = delete;
    GpuDeviceState& operator=(const GpuDeviceState&) = delete;

    const GpuContext& context() const { return context_; }
    DispatchBudget& budget() { return budget_; }

    /// Uploads a scene. What it shares with the previous one stays: trees, and everything if only camera and
    /// size differ. Throws Error(device); then there is no scene.
    void prepare(const Scene& scene);
    /// Number of uploads, not counting changes of camera and size.
    int upload_count() const { return upload_count_; }

    /// None before prepare().
    const std::optional<Scene>& scene() const { return scene_; }
    const GpuSettings& settings() const { return data_.settings; }
    const SceneBuffers& buffers() const { return *buffers_; }

    /// The program for the scene.
    const GpuProgram& program(bool terms, bool first_hit);
    /// The program that turns films into pictures.
    const GpuProgram& show_program();

  private:
    GpuContext context_;
    std::map<ProgramChoice, std::unique_ptr<GpuProgram>> programs_;
    std::unique_ptr<GpuProgram> show_program_;
    std::unique_ptr<SceneBuffers> buffers_;
    GpuSceneData data_; ///< without its arrays
    std::optional<Scene> scene_;
    DispatchBudget budget_;
    int upload_count_ = 0;
};

} // namespace glint::gpu
