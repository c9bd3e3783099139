#include "backend.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint::cli {
namespace {

RenderedPicture render_on_gpu(const Scene& scene, const RenderOptions& options) {
    GpuRenderer renderer;
    renderer.prepare(scene);
    return {renderer.render(options), renderer.device().name};
}

/// Why no graphics card can be used, or nothing.
std::string why_no_card() {
    std::string why;
    for (const GpuDevice& device : gpu_devices(&why)) {
        if (device.software) continue;
        if (device.fault.empty()) return {};
        why = device.name + ": " + device.fault;
    }
    return why.empty() ? "there is no graphics card" : why;
}

RenderedPicture render_where_best(const Scene& scene, const RenderOptions& options, Console& console) {
    std::string why = why_no_card();
    if (why.empty()) {
        try {
            return render_on_gpu(scene, options);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::device) throw;
            why = error.diagnostics().front().message;
        }
    }
    console.line("on the CPU: " + why.substr(0, why.find('\n')));
    return {render(scene, options), {}};
}

std::string row(const char* label, const std::string& text) {
    return fmt::format("  {:<16}{}\n", label, text);
}

} // namespace

RenderedPicture render_on_backend(const Arguments& arguments, const Scene& scene,
                                  const RenderOptions& options, Console& console) {
    const std::string backend = arguments.text("backend").value_or("cpu");
    const bool light = options.show == Aspect::final;
    if (backend == "gpu" && !light)
        throw Error(ErrorKind::usage,
                    fmt::format("--show {} is drawn on the CPU only", aspect_name(options.show)),
                    "leave --backend gpu away");
    if (backend == "gpu") return render_on_gpu(scene, options);
    if (backend == "auto" && light) return render_where_best(scene, options, console);
    return {render(scene, options), {}};
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
            text += row("largest buffer", bytes(static_cast<double>(d.largest_buffer)));
            text += row("buffers", with_commas(d.buffers));
            text += row("largest group", with_commas(d.largest_group));
        }
    }
    return text;
}

} // namespace glint::cli
