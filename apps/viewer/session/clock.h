#pragma once
// The window's clock.

#include <chrono>

namespace glint::viewer {

/// Seconds of a monotonic clock.
inline double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace glint::viewer
