#pragma once
// Selects a traversal kernel. All kernels give identical results; only speed differs.

#include <array>
#include <cstdint>

namespace glint {

enum class Kernel : std::uint8_t {
    automatic,    ///< packets or streams, as the hint suggests
    scalar,       ///< one ray at a time in plain C++: the reference
    single,       ///< one ray at a time, eight boxes or triangles at once
    packets,      ///< coherent groups culled by a shaft
    streams,      ///< groups of one octant filtered ray by ray
    lone = single ///< former name
};

/// Names for users, in the order of Kernel.
inline constexpr std::array kernel_names{"auto", "scalar", "single", "packet", "stream"};

enum class SimdTarget : std::uint8_t {
    best,  ///< the widest the machine supports
    plain, ///< the baseline of the architecture
    sse4,
    avx2,
    avx512
};

/// A kernel and its instruction set.
struct KernelChoice {
    Kernel kernel = Kernel::automatic;
    SimdTarget target = SimdTarget::best;
};

/// Whether this machine supports a target. Choosing an unsupported one throws std::invalid_argument.
bool is_available(SimdTarget target);

} // namespace glint
