// Runtime dispatch: detects the SIMD targets of the machine and calls the kernels.

#include "trace/mesh/scalar.h"
#include "trace/simd/kernel_table.h"

#include <stdexcept>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace glint::trace {
namespace {

/// Number of table rows whose instructions processor and system support, by the requirements of Highway for
/// its targets. Highway can detect this as well, but loading its library takes two to three milliseconds, as
/// it measures the clock.
std::size_t count_rows() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    const auto has_bit = [](unsigned leaf, unsigned bit) {
        unsigned a = 0, b = 0, c = 0, d = 0;
        return __get_cpuid(leaf, &a, &b, &c, &d) != 0 && (c & bit) != 0;
    };
    const bool sse4 = __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("sse4.1") &&
                      __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
                      __builtin_cpu_supports("aes");
    if (!sse4) return 1;
    // clang++ 14 does not know the last two by name.
    const bool avx2 = __builtin_cpu_supports("avx") && __builtin_cpu_supports("avx2") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
                      __builtin_cpu_supports("fma") && has_bit(0x80000001u, bit_LZCNT) &&
                      has_bit(1u, bit_F16C);
    if (!avx2) return 2;
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512cd");
    return avx512 ? 4 : 3;
#else
    return 1;
#endif
}

/// Detected once; the static costs one branch.
bool has(std::size_t row) {
    static const std::size_t rows = count_rows();
    return batch_kernels[row] != nullptr && row < rows;
}

/// Row of the widest available target.
std::size_t best_row() {
    static const std::size_t best = [] {
        std::size_t row = kernel_targets - 1;
        while (row > 0 && !has(row)) --row;
        return row;
    }();
    return best;
}

/// Row of a named target: enumerators and rows have the same order.
std::size_t own_row(SimdTarget target) {
    return static_cast<std::size_t>(target) - static_cast<std::size_t>(SimdTarget::plain);
}

BatchForm form_of(Kernel kernel, RayHint hint) {
    if (kernel == Kernel::automatic)
        return hint == RayHint::coherent ? BatchForm::packets : BatchForm::streams;
    return kernel == Kernel::streams ? BatchForm::streams : BatchForm::packets;
}

} // namespace

std::size_t row_of(SimdTarget target) {
    if (target == SimdTarget::best) return best_row();
    if (!is_available(target)) throw std::invalid_argument("this machine lacks the SIMD target asked for");
    return own_row(target);
}

} // namespace glint::trace

namespace glint {

bool is_available(SimdTarget target) {
    return target == SimdTarget::best || trace::has(trace::own_row(target));
}

} // namespace glint

namespace glint::trace {

TriangleRecord closest(const MeshTree& tree, const Ray& ray, const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar) return closest_scalar(tree, ray);
    return single_kernels[row_of(choice.target)]->closest(tree, ray);
}

bool occluded(const MeshTree& tree, const Ray& ray, const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar) return occluded_scalar(tree, ray);
    return single_kernels[row_of(choice.target)]->occluded(tree, ray);
}

void closest(const MeshTree& tree, std::span<const Ray> rays, std::span<TriangleRecord> records, RayHint hint,
             const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar || choice.kernel == Kernel::single) {
        for (std::size_t i = 0; i < rays.size(); ++i) records[i] = closest(tree, rays[i], choice);
        return;
    }
    batch_kernels[row_of(choice.target)]->closest(tree, rays.data(), records.data(), rays.size(),
                                                  form_of(choice.kernel, hint));
}

void occluded(const MeshTree& tree, std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
              const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar || choice.kernel == Kernel::single) {
        for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = occluded(tree, rays[i], choice) ? 1 : 0;
        return;
    }
    batch_kernels[row_of(choice.target)]->occluded(tree, rays.data(), blocked.data(), rays.size(),
                                                   form_of(choice.kernel, hint));
}

} // namespace glint::trace
