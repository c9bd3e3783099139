#pragma once
// Where pictures that windows draw come from, and go back to.

#include "glint/gpu.h"

#include <memory>

namespace glint {

class GpuContext;

/// Textures that nobody looks at any more serve again: they come back from any thread, and those that are
/// too many go when the next is taken. All of it needs the context; pictures are let go without it, but those
/// that outlive the pool need one that shares with it there.
class GpuPicturePool {
  public:
    explicit GpuPicturePool(const GpuContext& context);
    ~GpuPicturePool();
    GpuPicturePool(const GpuPicturePool&) = delete;
    GpuPicturePool& operator=(const GpuPicturePool&) = delete;

    /// A picture of this size that the device is done with. Throws Error(device) where there is no room for
    /// it.
    std::shared_ptr<GpuPicture> take(int width, int height);

  private:
    struct Shelf;
    const GpuContext& context_;
    std::shared_ptr<Shelf> shelf_;
};

} // namespace glint
