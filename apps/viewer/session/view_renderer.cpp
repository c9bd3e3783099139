// One view: first pass, refinement, and the fall-back from the GPU to the CPU.
#include "view_renderer.h"

#include "clock.h"
#include "rendered_frame.h"

#include <algorithm>
#include <new>
#include <utility>

namespace glint::viewer {
namespace {

double samples(int pixels, int step) { return static_cast<double>(pixels) / (step * step); }

/// Moves an average towards a measurement. One late picture does not make the next ones coarse: the machine
/// may have been busy otherwise.
void update(double& average, double measured) {
    constexpr double weight = 0.25;
    constexpr double max_growth = 4;
    average += weight * (std::min(measured, max_growth * average) - average);
}

/// Runs GPU work; returns why it failed, or nothing.
template <class Work>
std::string gpu_fault(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.diagnostics().front().message;
    } catch (const std::bad_alloc&) {
        return "there is too little memory for the graphics card's part";
    }
    return {};
}

} // namespace

int FirstPassCost::step(int pixels) const {
    int step = 1;
    while (step < max_coarsest && predicted_seconds(pixels, step) > seconds_) step *= 2;
    return step;
}

void FirstPassCost::learn(int pixels, int step, double trace_seconds, double show_seconds) {
    update(seconds_per_sample_, trace_seconds / std::max(1.0, samples(pixels, step)));
    update(seconds_per_pixel_, show_seconds / pixels);
}

double FirstPassCost::predicted_seconds(int pixels, int step) const {
    return samples(pixels, step) * seconds_per_sample_ + pixels * seconds_per_pixel_;
}

ViewRenderer::ViewRenderer(int threads, double first_picture_seconds, const CancelFlag& cancel)
    : threads_(threads), cancel_(cancel), cpu_(first_picture_seconds), gpu_(first_picture_seconds) {}

void ViewRenderer::start(Picture picture) {
    picture_ = std::move(picture);
    if (!start_on_gpu()) start_on_cpu();
}

/// False: the CPU has to render.
bool ViewRenderer::start_on_gpu() {
    if (!picture_->gpu || !fault_.empty()) return false;
    fault_ = gpu_fault([&] {
        if (!gpu_.backend) gpu_.backend = picture_->gpu();
        render_first_pass(gpu_);
    });
    if (fault_.empty()) return true;
    gpu_.backend.reset();
    return false;
}

void ViewRenderer::start_on_cpu() {
    if (!cpu_.backend) cpu_.backend = cpu_backend(threads_);
    render_first_pass(cpu_);
}

void ViewRenderer::fall_back(const std::string& fault) {
    fault_ = fault;
    gpu_.backend.reset();
    start_on_cpu();
}

void ViewRenderer::render_first_pass(Device& device) {
    const double begin = now();
    ProgressiveOptions options;
    options.coarsest = device.cost.step(pixel_count());
    options.show = picture_->show;
    options.kernel.kernel = picture_->kernel;
    options.cancel = &cancel_;
    // The very first pass also waits for what later ones find: compiled shaders, memory.
    const bool is_warm = device.backend->reached().step > 0;
    device.backend->start(picture_->scene, options);
    device.backend->advance(0);
    on_gpu_ = &device == &gpu_;
    first_step_ = is_warm && device.backend->reached().step > 0 ? options.coarsest : 0;
    first_pass_seconds_ = now() - begin;
}

void ViewRenderer::refine(double seconds) {
    if (is_finished()) return;
    if (!on_gpu_) {
        cpu_.backend->advance(seconds);
        return;
    }
    const std::string fault = gpu_fault([&] { gpu_.backend->advance(seconds); });
    if (!fault.empty()) fall_back(fault);
}

bool ViewRenderer::copy_to(RenderedFrame& frame) {
    // A cancelled first pass has nothing.
    const int step = active().backend->reached().step;
    if (step == 0 || step > picture_->max_step) return false;
    if (on_gpu_) {
        const std::string fault = gpu_fault([&] { gpu_.backend->copy_to(frame); });
        if (!fault.empty()) {
            fall_back(fault);
            return copy_to(frame);
        }
    } else {
        cpu_.backend->copy_to(frame);
    }
    frame.reached = active().backend->reached();
    frame.camera = picture_->scene.camera();
    frame.rays_per_second =
        frame.reached.seconds > 0 ? static_cast<double>(frame.reached.rays) / frame.reached.seconds : 0;
    frame.show = picture_->show;
    frame.device = active().backend->device();
    frame.why_cpu = fault_;
    if (!is_visible(picture_->show)) frame.image = visible(frame.image, picture_->show, picture_->scene);
    // After a fault the CPU starts again: what is shown must not become coarser.
    picture_->max_step = std::min(picture_->max_step, step);
    return true;
}

void ViewRenderer::learn_show_seconds(double seconds) {
    if (first_step_ > 0) active().cost.learn(pixel_count(), first_step_, first_pass_seconds_, seconds);
}

void ViewRenderer::release() {
    picture_.reset();
    cpu_.backend.reset();
    gpu_.backend.reset();
}

bool ViewRenderer::is_finished() const { return !picture_ || active().backend->reached().finished; }

int ViewRenderer::pixel_count() const {
    const RenderSettings& settings = picture_->scene.render_settings();
    return settings.width * settings.height;
}

} // namespace glint::viewer
