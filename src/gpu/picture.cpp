#include "gpu/picture.h"

#include "gpu/context.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <mutex>
#include <utility>
#include <vector>

namespace glint {

GpuPicture::GpuPicture(int width, int height) : width_(width), height_(height) {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    glBindTexture(GL_TEXTURE_2D, 0);
}

GpuPicture::~GpuPicture() {
    if (texture_ == 0) return;
    if (drawn_ != nullptr) glDeleteSync(static_cast<GLsync>(drawn_));
    glDeleteTextures(1, &texture_);
}

void GpuPicture::was_drawn() const {
    if (drawn_ != nullptr) glDeleteSync(static_cast<GLsync>(drawn_));
    drawn_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    // Otherwise another context might wait for a fence that was never submitted.
    glFlush();
}

Image GpuPicture::read() const {
    Image image(width_, height_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, image.pixels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    return image;
}

void GpuPicture::leave_to_context() {
    texture_ = 0;
    drawn_ = nullptr;
}

void GpuPicture::wait_until_drawn() {
    if (drawn_ == nullptr) return;
    glWaitSync(static_cast<GLsync>(drawn_), 0, GL_TIMEOUT_IGNORED);
    glDeleteSync(static_cast<GLsync>(drawn_));
    drawn_ = nullptr;
}

} // namespace glint

namespace glint::gpu {

struct GpuPicturePool::Shelf {
    std::mutex mutex;
    std::vector<std::unique_ptr<GpuPicture>> pictures;
    bool closed = false;

    /// On any thread, perhaps without a context to destroy it in.
    void put(std::unique_ptr<GpuPicture> picture) {
        const std::lock_guard lock(mutex);
        if (!closed) pictures.push_back(std::move(picture));
    }

    /// One of this size, or none. Destroys those of other sizes and all but a few.
    std::unique_ptr<GpuPicture> take(int width, int height) {
        constexpr std::size_t max_spare = 2;
        const std::lock_guard lock(mutex);
        std::erase_if(pictures, [&](const auto& p) { return p->width() != width || p->height() != height; });
        if (pictures.empty()) return nullptr;
        std::unique_ptr<GpuPicture> picture = std::move(pictures.back());
        pictures.pop_back();
        if (pictures.size() > max_spare) pictures.resize(max_spare);
        return picture;
    }
};

GpuPicturePool::GpuPicturePool(const GpuContext& context)
    : context_(context), shelf_(std::make_shared<Shelf>()) {}

GpuPicturePool::~GpuPicturePool() {
    const std::lock_guard lock(shelf_->mutex);
    shelf_->closed = true;
    if (!context_.is_current())
        for (const auto& picture : shelf_->pictures) picture->leave_to_context();
    shelf_->pictures.clear();
}

std::shared_ptr<GpuPicture> GpuPicturePool::take(int width, int height) {
    std::unique_ptr<GpuPicture> picture = shelf_->take(width, height);
    if (picture == nullptr) {
        picture = std::unique_ptr<GpuPicture>(new GpuPicture(width, height));
        context_.check("making room for the picture");
    }
    picture->wait_until_drawn();
    return {picture.release(),
            [shelf = shelf_](GpuPicture* done) { shelf->put(std::unique_ptr<GpuPicture>(done)); }};
}

} // namespace glint::gpu
