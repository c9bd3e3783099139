#pragma once
// Where pictures that windows draw come from, and go back to.

#include "glint/gpu.h"

#include <memory>

namespace glint {

/// Textures that nobody looks at any more serve again. All but the destructor of pictures needs the context;
/// a picture that outlives its pool needs a context too where it is let go.
class GpuPicturePool {
  public:
    GpuPicturePool();
    ~GpuPicturePool();
    GpuPicturePool(const GpuPicturePool&) = delete;
    GpuPicturePool& operator=(const GpuPicturePool&) = delete;

    /// A picture of this size that the device is done with.
    std::shared_ptr<GpuPicture> take(int width, int height);

  private:
    struct Shelf;
    std::shared_ptr<Shelf> shelf_;
};

} // namespace glint
