#pragma once
// Seconds by the wall's clock.

#include <chrono>

namespace glint {

inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace glint
