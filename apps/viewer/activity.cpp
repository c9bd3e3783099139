// The window's clock.
#include "activity.h"

#include <chrono>

namespace glint::viewer {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace glint::viewer
