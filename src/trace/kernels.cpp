#include "trace/kernel_table.h"

#include <stdexcept>

#include <hwy/targets.h>

namespace glint {
namespace {

/// Asked of the machine once, as that may take longer than many rays; a function's static costs one branch.
bool has(std::size_t row) {
    constexpr std::int64_t needs[kernel_targets] = {0, HWY_SSE4, HWY_AVX2, HWY_AVX3};
    static const std::int64_t machine = hwy::SupportedTargets();
    return batch_kernels[row].closest != nullptr && (machine & needs[row]) == needs[row];
}

/// The table's row of the widest target.
std::size_t best_row() {
    static const std::size_t best = [] {
        std::size_t row = kernel_targets - 1;
        while (row > 0 && !has(row)) --row;
        return row;
    }();
    return best;
}

/// The table's row of a target that is not the best: they stand in one order.
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

bool is_available(SimdTarget target) { return target == SimdTarget::best || has(own_row(target)); }

TriangleRecord closest(const MeshTree& tree, const Ray& ray, const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar) return closest_scalar(tree, ray);
    return lone_kernels[row_of(choice.target)].closest(tree, ray);
}

bool occluded(const MeshTree& tree, const Ray& ray, const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar) return occluded_scalar(tree, ray);
    return lone_kernels[row_of(choice.target)].occluded(tree, ray);
}

void closest(const MeshTree& tree, std::span<const Ray> rays, std::span<TriangleRecord> records, RayHint hint,
             const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar || choice.kernel == Kernel::lone) {
        for (std::size_t i = 0; i < rays.size(); ++i) records[i] = closest(tree, rays[i], choice);
        return;
    }
    batch_kernels[row_of(choice.target)].closest(tree, rays.data(), records.data(), rays.size(),
                                                 form_of(choice.kernel, hint));
}

void occluded(const MeshTree& tree, std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
              const KernelChoice& choice) {
    if (choice.kernel == Kernel::scalar || choice.kernel == Kernel::lone) {
        for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = occluded(tree, rays[i], choice) ? 1 : 0;
        return;
    }
    batch_kernels[row_of(choice.target)].occluded(tree, rays.data(), blocked.data(), rays.size(),
                                                  form_of(choice.kernel, hint));
}

} // namespace glint
