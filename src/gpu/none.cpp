// The public interface when glint is built without the backend.

#include "glint/gpu.h"

namespace glint {

struct GpuRenderer::State {
    GpuDevice device;
};

std::vector<GpuDevice> gpu_devices(std::string* why) {
    if (why != nullptr) *why = "this glint was built with no GPU support (-DGLINT_GPU=OFF)";
    return {};
}

GpuDevice gpu_device(GpuCurrentContext) {
    GpuDevice device;
    gpu_devices(&device.fault);
    return device;
}

GpuRenderer::GpuRenderer(int, const GpuLimits&) {
    std::string why;
    gpu_devices(&why);
    throw Error(ErrorKind::device, why, "--backend cpu needs none");
}
GpuRenderer::~GpuRenderer() = default;
GpuRenderer::GpuRenderer(GpuRenderer&&) noexcept = default;
GpuRenderer& GpuRenderer::operator=(GpuRenderer&&) noexcept = default;
const GpuDevice& GpuRenderer::device() const { return state_->device; }
void GpuRenderer::prepare(const Scene&) {}
Picture GpuRenderer::render(const RenderOptions&) { return {}; }

struct GpuProgressive::State {
    GpuDevice device;
    Refinement reached;
};

GpuProgressive::GpuProgressive(int device) { GpuRenderer refuse(device); }
GpuProgressive::GpuProgressive(GpuCurrentContext) { GpuRenderer refuse; }
GpuProgressive::~GpuProgressive() = default;
const GpuDevice& GpuProgressive::device() const { return state_->device; }
void GpuProgressive::start(const Scene&, const ProgressiveOptions&) {}
bool GpuProgressive::advance(double) { return false; }
const Refinement& GpuProgressive::reached() const { return state_->reached; }
std::shared_ptr<const GpuPicture> GpuProgressive::picture() const { return nullptr; }
Image GpuProgressive::image() const { return {}; }
int GpuProgressive::upload_count() const { return 0; }

GpuPicture::~GpuPicture() = default;
void GpuPicture::was_drawn() const {}
Image GpuPicture::read() const { return {}; }

} // namespace glint
