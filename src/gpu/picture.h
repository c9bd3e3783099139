#pragma once
// Textures of pictures, reused.

#include "glint/gpu.h"

#include <memory>

namespace glint::gpu {

class GpuContext;

/// Pictures return to the pool when they are released, on any thread, with or without a context; spare ones
/// are destroyed when the next is taken. All functions need the context. A picture that outlives the pool
/// must be released while a context that shares with the pool's is current.
class GpuPicturePool {
  public:
    explicit GpuPicturePool(const GpuContext& context);
    ~GpuPicturePool();
    GpuPicturePool(const GpuPicturePool&) = delete;
    GpuPicturePool& operator=(const GpuPicturePool&) = delete;

    /// A picture of this size that the device no longer reads. Throws Error(device) if there is no memory for
    /// it.
    std::shared_ptr<GpuPicture> take(int width, int height);

  private:
    struct Shelf;
    const GpuContext& context_;
    std::shared_ptr<Shelf> shelf_;
};

} // namespace glint::gpu
