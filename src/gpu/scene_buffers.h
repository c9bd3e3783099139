#pragma once
// A flattened scene in the device's memory, in the order of the bindings of shaders/data.glsl.

#include "gpu/program.h"
#include "gpu/scene_data.h"

#include <memory>

namespace glint::gpu {

class GpuContext;

class SceneBuffers {
  public:
    /// Shares the tree of `before`, if given. Throws Error(device) for what the device has no room for, with
    /// its name and the sizes.
    SceneBuffers(const GpuContext& context, const GpuSceneData& data, const SceneBuffers* before);

    /// To bindings 0, 1, …
    void bind() const;

  private:
    std::shared_ptr<const GpuBuffer> nodes_, leaves_;
    GpuBuffer objects_, words_, lights_, shapes_;
};

} // namespace glint::gpu
