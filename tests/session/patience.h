#pragma once
// Waiting for what other threads do.

#include <chrono>
#include <thread>

namespace glint::viewer {

/// Waits until it is so; false where it never becomes so.
template <class Condition>
bool comes_true(const Condition& condition) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > patience) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

} // namespace glint::viewer
