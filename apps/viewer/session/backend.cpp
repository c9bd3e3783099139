// The two backends: Progressive and GpuProgressive behind one interface.
#include "backend.h"

#include "rendered_frame.h"

namespace glint::viewer {
namespace {

class CpuBackend : public Backend {
  public:
    explicit CpuBackend(int threads) : picture_(threads) {}

    void start(const Scene& scene, const ProgressiveOptions& options) override {
        picture_.start(scene, options);
    }
    bool advance(double seconds) override { return picture_.advance(seconds); }
    const Refinement& reached() const override { return picture_.reached(); }
    void copy_to(RenderedFrame& frame) override {
        frame.image = picture_.image(); // copies into memory that the frame already has
        frame.width = frame.image.width;
        frame.height = frame.image.height;
    }
    std::string device() const override { return {}; }

  private:
    Progressive picture_;
};

class GpuBackend : public Backend {
  public:
    explicit GpuBackend(std::shared_ptr<void> context)
        : context_(std::move(context)), picture_(GpuCurrentContext{}) {}

    void start(const Scene& scene, const ProgressiveOptions& options) override {
        picture_.start(scene, options);
        stays_on_device_ = is_visible(options.show);
    }
    bool advance(double seconds) override { return picture_.advance(seconds); }
    const Refinement& reached() const override { return picture_.reached(); }
    void copy_to(RenderedFrame& frame) override {
        const std::shared_ptr<const GpuPicture> picture = picture_.picture();
        frame.width = picture->width();
        frame.height = picture->height();
        // Values that visible() has yet to map to colours are read back.
        frame.image = stays_on_device_ ? Image() : picture->read();
        if (stays_on_device_) frame.on_device = picture;
    }
    std::string device() const override { return picture_.device().name; }

  private:
    std::shared_ptr<void> context_; // first: released last
    GpuProgressive picture_;
    bool stays_on_device_ = true;
};

} // namespace

std::unique_ptr<Backend> cpu_backend(int threads) { return std::make_unique<CpuBackend>(threads); }
std::unique_ptr<Backend> gpu_backend(std::shared_ptr<void> context) {
    return std::make_unique<GpuBackend>(std::move(context));
}

} // namespace glint::viewer
