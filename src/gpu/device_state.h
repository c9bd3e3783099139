#pragma once
// A device at work: its context, the programs that it has compiled, and the scene that it holds.

#include "gpu/context.h"
#include "gpu/dispatch_budget.h"
#include "gpu/program.h"
#include "gpu/scene_buffers.h"
#include "gpu/scene_data.h"

#include <map>
#include <memory>
#include <optional>

namespace glint {

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

    /// Lays a scene in the device's memory. What the one before has in common with it stays there: trees, and
    /// all of it where only camera and size are others. Throws Error(device); then none is held.
    void prepare(const Scene& scene);
    /// How often anything of a scene was laid there.
    int upload_count() const { return upload_count_; }

    /// The scene that is held; none before prepare().
    const std::optional<Scene>& scene() const { return scene_; }
    const GpuSettings& settings() const { return data_.settings; }
    const SceneBuffers& buffers() const { return *buffers_; }

    /// The program for the scene and what is asked of it.
    const GpuProgram& program(bool terms, bool first_hit);
    /// That which makes pictures of films.
    const GpuProgram& show_program();

  private:
    GpuContext context_;
    std::map<ProgramChoice, std::unique_ptr<GpuProgram>> programs_;
    std::unique_ptr<GpuProgram> show_program_;
    std::unique_ptr<SceneBuffers> buffers_;
    GpuSceneData data_; ///< what stays of it: settings and numbers
    std::optional<Scene> scene_;
    DispatchBudget budget_;
    int upload_count_ = 0;
};

} // namespace glint
