#pragma once
// Waiting for other threads.

#include <chrono>
#include <thread>

namespace glint::viewer {

/// Waits until the condition holds; false after a time limit.
template <class Condition>
bool wait_until(const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

} // namespace glint::viewer
