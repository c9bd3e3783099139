// The free list: frames return to it from the deleter of their last reference.
#include "frame_pool.h"

#include <utility>

namespace glint::viewer {

std::shared_ptr<RenderedFrame> FramePool::take() {
    std::unique_ptr<RenderedFrame> frame;
    {
        const std::lock_guard lock(free_->mutex);
        if (!free_->frames.empty()) {
            frame = std::move(free_->frames.back());
            free_->frames.pop_back();
        }
    }
    if (!frame) frame = std::make_unique<RenderedFrame>();
    return {frame.release(), [list = free_](RenderedFrame* released) {
                std::unique_ptr<RenderedFrame> returned(released);
                returned->on_device.reset();
                const std::lock_guard lock(list->mutex);
                if (list->frames.size() < max_free) list->frames.push_back(std::move(returned));
            }};
}

} // namespace glint::viewer
