// Selects the device, and lists devices.
#include "backend.h"

#include "text.h"

#include "glint/limits.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint::cli {
namespace {

/// Why no graphics card can be used; empty if one can.
std::string why_no_card() {
    std::string why;
    for (const GpuDevice& device : gpu_devices(&why)) {
        if (device.software) continue;
        if (device.fault.empty()) return {};
        why = device.name + ": " + device.fault;
    }
    return why.empty() ? "there is no graphics card" : why;
}

std::string row(const char* label, const std::string& text) {
    return fmt::format("  {:<16}{}\n", label, text);
}

} // namespace

Backend::Backend(const Arguments& arguments, Console& console)
    : wanted_(arguments.text("backend").value_or("cpu")), console_(console) {}

RenderedPicture Backend::render(const Scene& scene, const RenderOptions& options) {
    if (std::optional<RenderedPicture> rendered = render_on_card(scene, options)) return std::move(*rendered);
    return {glint::render(scene, options), {}};
}

std::optional<RenderedPicture> Backend::render_on_card(const Scene& scene, const RenderOptions& options) {
    if (wanted_ == "cpu") return std::nullopt;
    if (wanted_ == "gpu") return render_on_gpu(scene, options);
    std::string why = gpu_ ? "" : why_no_card();
    if (why.empty()) {
        try {
            return render_on_gpu(scene, options);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::device) throw;
            gpu_.reset(); // the device may be lost
            why = error.diagnostics().front().message;
        }
    }
    // Once for all frames of an animation.
    if (why != reported_) report_fallback(why);
    reported_ = why;
    return std::nullopt;
}

/// One line; -v adds the driver's log, if there is one.
void Backend::report_fallback(const std::string& why) {
    const std::size_t end = why.find(":\n");
    const std::string line = "on the CPU: " + why.substr(0, end);
    if (end == std::string::npos) return console_.line(line);
    if (!console_.verbose()) return console_.line(line + " (-v shows its log)");
    console_.line(line + why.substr(end, why.find_last_not_of('\n') + 1 - end));
}

RenderedPicture Backend::render_on_gpu(const Scene& scene, const RenderOptions& options) {
    if (!gpu_) gpu_.emplace();
    gpu_->prepare(scene);
    return {gpu_->render(options), gpu_->device().name};
}

std::string devices_text() {
    std::string why;
    const std::vector<GpuDevice> devices = gpu_devices(&why);
    if (devices.empty()) return fmt::format("no devices for --backend gpu: {}\n", why);
    std::string text;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const GpuDevice& d = devices[i];
        text += fmt::format("{}: {}\n", i, d.name);
        text += row("usable", d.fault.empty() ? (d.software ? "yes, but it runs on the CPU" : "yes")
                                              : "no: " + d.fault);
        if (!d.driver.empty()) {
            text += row("driver", d.driver);
            text += row("largest buffer", bytes_text(static_cast<double>(d.max_buffer)));
            text += row("buffers", with_commas(d.buffers));
            text += row("largest group", with_commas(d.max_group));
        }
    }
    return text;
}

} // namespace glint::cli
