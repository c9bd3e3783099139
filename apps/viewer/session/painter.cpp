#include "painter.h"

#include "renderer.h"

namespace glint::viewer {
namespace {

class CpuPainter : public Painter {
  public:
    explicit CpuPainter(int threads) : picture_(threads) {}

    void start(const Scene& scene, const ProgressiveOptions& options) override {
        picture_.start(scene, options);
    }
    bool advance(double seconds) override { return picture_.advance(seconds); }
    const Refinement& reached() const override { return picture_.reached(); }
    void show(Frame& frame) override {
        frame.image = picture_.image(); // into the memory that the frame has
        frame.width = frame.image.width;
        frame.height = frame.image.height;
    }
    std::string device() const override { return {}; }

  private:
    Progressive picture_;
};

class GpuPainter : public Painter {
  public:
    explicit GpuPainter(std::shared_ptr<void> context)
        : context_(std::move(context)), picture_(GpuCurrentContext{}) {}

    void start(const Scene& scene, const ProgressiveOptions& options) override {
        picture_.start(scene, options);
        stays_ = is_visible(options.show);
    }
    bool advance(double seconds) override { return picture_.advance(seconds); }
    const Refinement& reached() const override { return picture_.reached(); }
    void show(Frame& frame) override {
        const std::shared_ptr<const GpuPicture> picture = picture_.picture();
        frame.width = picture->width();
        frame.height = picture->height();
        // What visible() has yet to make colours of is brought back.
        frame.image = stays_ ? Image() : picture->read();
        if (stays_) frame.on_device = picture;
    }
    std::string device() const override { return picture_.device().name; }

  private:
    std::shared_ptr<void> context_;
    GpuProgressive picture_;
    bool stays_ = true; ///< the picture, on the device
};

} // namespace

std::unique_ptr<Painter> cpu_painter(int threads) { return std::make_unique<CpuPainter>(threads); }
std::unique_ptr<Painter> gpu_painter(std::shared_ptr<void> context) {
    return std::make_unique<GpuPainter>(std::move(context));
}

} // namespace glint::viewer
