#include "gpu/picture.h"

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
    if (drawn_ != nullptr) glDeleteSync(static_cast<GLsync>(drawn_));
    glDeleteTextures(1, &texture_);
}

void GpuPicture::was_drawn() const {
    if (drawn_ != nullptr) glDeleteSync(static_cast<GLsync>(drawn_));
    drawn_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    // Else another context might wait for what was never sent.
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

void GpuPicture::wait_until_drawn() {
    if (drawn_ == nullptr) return;
    glWaitSync(static_cast<GLsync>(drawn_), 0, GL_TIMEOUT_IGNORED);
    glDeleteSync(static_cast<GLsync>(drawn_));
    drawn_ = nullptr;
}

struct GpuPicturePool::Shelf {
    std::mutex mutex;
    std::vector<std::unique_ptr<GpuPicture>> pictures;
    bool closed = false;

    void put(std::unique_ptr<GpuPicture> picture) {
        constexpr std::size_t most_spare = 2;
        const std::lock_guard lock(mutex);
        if (!closed && pictures.size() < most_spare) pictures.push_back(std::move(picture));
    }
};

GpuPicturePool::GpuPicturePool() : shelf_(std::make_shared<Shelf>()) {}

GpuPicturePool::~GpuPicturePool() {
    const std::lock_guard lock(shelf_->mutex);
    shelf_->closed = true;
    shelf_->pictures.clear();
}

std::shared_ptr<GpuPicture> GpuPicturePool::take(int width, int height) {
    std::unique_ptr<GpuPicture> picture;
    {
        const std::lock_guard lock(shelf_->mutex);
        // Those of another size will not be wanted again.
        std::erase_if(shelf_->pictures,
                      [&](const auto& p) { return p->width() != width || p->height() != height; });
        if (!shelf_->pictures.empty()) {
            picture = std::move(shelf_->pictures.back());
            shelf_->pictures.pop_back();
        }
    }
    if (picture == nullptr) picture = std::unique_ptr<GpuPicture>(new GpuPicture(width, height));
    picture->wait_until_drawn();
    return {picture.release(),
            [shelf = shelf_](GpuPicture* done) { shelf->put(std::unique_ptr<GpuPicture>(done)); }};
}

} // namespace glint
