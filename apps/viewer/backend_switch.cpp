// The OpenGL context for rendering, and the selection of backends.
#include "backend_switch.h"

#include "messages.h"
#include "session/session.h"
#include "widgets.h"
#include "window.h"

#include "glint/error.h"

#include <iostream>

namespace glint::viewer {

bool BackendSwitch::select(bool gpu, Session& session) {
    if (gpu_ == gpu) return false;
    gpu_ = gpu;
    session.set_backend(gpu ? gpu_factory() : BackendFactory());
    return true;
}

/// Without OpenGL 4.3 the factory throws, so that the renderer reports that as it does other faults of the
/// card.
BackendFactory BackendSwitch::gpu_factory() {
    try {
        if (!context_) context_.emplace(window_);
    } catch (const Error& error) {
        return [error]() -> std::unique_ptr<Backend> { throw error; };
    }
    return [context = &*context_] { return gpu_backend(context->enter()); };
}

void BackendSwitch::check(const RenderedFrame& frame, Messages& messages) {
    if (frame.why_cpu == why_cpu_) return;
    why_cpu_ = frame.why_cpu;
    if (why_cpu_.empty()) return;
    messages.show("The CPU draws: " + first_line(why_cpu_));
    // A driver's log is longer than the window has room for.
    if (first_line(why_cpu_) != why_cpu_) std::cerr << "The CPU draws: " << why_cpu_ << "\n";
}

} // namespace glint::viewer
