// The end of a thread's stack, as the thread library tells it.

#include "parallel/stack.h"

#include <pthread.h>

#include <cstdint>
#include <limits>

namespace glint::parallel {
namespace {

/// Lowest address of the calling thread's stack; 0 if unknown.
std::uintptr_t stack_end() {
    pthread_attr_t attributes;
    if (::pthread_getattr_np(::pthread_self(), &attributes) != 0) return 0;
    void* lowest = nullptr;
    std::size_t size = 0;
    const bool known = ::pthread_attr_getstack(&attributes, &lowest, &size) == 0;
    ::pthread_attr_destroy(&attributes);
    return known ? reinterpret_cast<std::uintptr_t>(lowest) : 0;
}

} // namespace

std::size_t stack_left() {
    thread_local const std::uintptr_t end = stack_end();
    // The frame, not a variable: sanitizers keep variables elsewhere.
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    return here > end ? here - end : 0;
}

} // namespace glint::parallel
