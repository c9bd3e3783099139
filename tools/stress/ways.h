#pragma once
// All combinations of kernel and SIMD target that this machine supports.

#include "glint/kernels.h"

#include <span>

namespace glint::stress {

struct Way {
    const char* name; ///< as in `glint --kernel … --simd …`
    KernelChoice choice;
};

/// Maximum number of ways.
inline constexpr std::size_t max_ways = 24;

/// Each kernel with each available target; constant during the life of the program.
std::span<const Way> ways();

} // namespace glint::stress
