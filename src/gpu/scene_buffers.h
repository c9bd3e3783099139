#pragma once
// A flattened scene in the device's memory, in the order of the bindings of shaders/data.glsl.

#include "gpu/program.h"
#include "gpu/scene_data.h"

#include <memory>

namespace glint {

class GpuContext;

class SceneBuffers {
  public:
    /// Where `before` is given, the tree is the one that it holds, and stays where it is. Throws
    /// Error(device) for what the device cannot hold, with its name and the sizes.
    SceneBuffers(const GpuContext& context, const GpuSceneData& data, const SceneBuffers* before);

    /// All to their bindings, from 0 on.
    void bind() const;

  private:
    std::shared_ptr<const GpuBuffer> nodes_, leaves_;
    GpuBuffer objects_, words_, lights_, shapes_;
};

} // namespace glint
