#pragma once
// Which of the equal ways through a mesh rays shall take. No choice shows in any answer, only in the time.

#include <array>
#include <cstdint>

namespace glint {

enum class Kernel : std::uint8_t {
    automatic, ///< packets or streams by the hint; within packets by how many rays are left
    scalar,    ///< one ray at a time in plain C++: the oracle
    lone,      ///< one ray at a time, eight boxes or triangles at once
    packets,   ///< groups of neighbours within a shaft
    streams    ///< groups of one octant, filtered ray by ray
};

/// What users call them, by Kernel.
inline constexpr std::array kernel_names{"auto", "scalar", "single", "packet", "stream"};

enum class SimdTarget : std::uint8_t {
    best,  ///< the widest that the machine has
    plain, ///< what every machine of this kind has
    sse4,
    avx2,
    avx512
};

/// A kernel and the instructions it may use.
struct KernelChoice {
    Kernel kernel = Kernel::automatic;
    SimdTarget target = SimdTarget::best;
};

/// Can this machine run kernels for the target? Asking for others throws std::invalid_argument.
bool is_available(SimdTarget target);

} // namespace glint
