#pragma once
// Choices that affect the speed of builds and rays, never results.

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

/// A traversal kernel and its instruction set.
struct KernelChoice {
    Kernel kernel = Kernel::automatic;
    SimdTarget target = SimdTarget::best;
};

/// Hint on the rays of a batch.
enum class RayHint {
    coherent,  ///< neighbouring rays are similar: camera rays by tiles, shadow rays to one light
    incoherent ///< neighbouring rays are unrelated: bounces, ambient occlusion
};

/// Trade-off of a build.
enum class BuildQuality {
    fast, ///< fast build, for trees that change often or serve few rays
    high  ///< best tracing speed, for many rays
};

/// Whether this machine supports a target. Choosing an unsupported one throws std::invalid_argument.
bool is_available(SimdTarget target);

} // namespace glint
