#pragma once
// A free list of frames: their images are large, and allocating large memory is slow.

#include "rendered_frame.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace glint::viewer {

/// For any thread. Frames may outlive the pool.
class FramePool {
  public:
    /// A frame with whatever it last held, or a new one. It returns to the free list with its last reference,
    /// on whichever thread drops that; a GPU picture that it holds is released there.
    std::shared_ptr<RenderedFrame> take();

  private:
    static constexpr std::size_t max_free = 4;
    struct FreeList {
        std::mutex mutex;
        std::vector<std::unique_ptr<RenderedFrame>> frames; ///< guarded by `mutex`
    };
    std::shared_ptr<FreeList> free_ = std::make_shared<FreeList>();
};

} // namespace glint::viewer
