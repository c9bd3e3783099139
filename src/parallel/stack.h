#pragma once
// The stack of the calling thread, for deep recursion.

#include <cstddef>

namespace glint::parallel {

/// Bytes that the calling thread may still put on its stack.
std::size_t stack_left();

} // namespace glint::parallel
