#pragma once
// Every way of tracing that this machine can be made to take.

#include "glint/kernels.h"

#include <span>

namespace glint::stress {

struct Way {
    const char* name; ///< as `glint --kernel … --simd …` call them
    KernelChoice choice;
};

/// No more than this many.
inline constexpr std::size_t most_ways = 24;

/// Each kernel with each target: the same list for the life of the program.
std::span<const Way> ways();

} // namespace glint::stress
