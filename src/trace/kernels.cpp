#include "trace/kernel_table.h"

#include <stdexcept>

#include <hwy/targets.h>

namespace glint {
namespace {

constexpr std::size_t plain = 0;
constexpr std::size_t sse4 = 1;
constexpr std::size_t avx2 = 2;

/// Asked of the processor once: in a virtual machine each question costs a microsecond.
std::int64_t machine_targets() {
    static const std::int64_t machine = hwy::SupportedTargets();
    return machine;
}

bool has(std::size_t target) {
    const bool compiled = batch_kernels[target].closest != nullptr;
    const std::int64_t machine = machine_targets();
    if (target == avx2) return compiled && (machine & HWY_AVX2) != 0;
    if (target == sse4) return compiled && (machine & HWY_SSE4) != 0;
    return compiled;
}

/// The table's row of the best target.
std::size_t best_row() {
    static const std::size_t best = has(avx2) ? avx2 : (has(sse4) ? sse4 : plain);
    return best;
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
    return target == SimdTarget::plain ? plain : (target == SimdTarget::sse4 ? sse4 : avx2);
}

bool is_available(SimdTarget target) {
    switch (target) {
    case SimdTarget::sse4:
        return has(sse4);
    case SimdTarget::avx2:
        return has(avx2);
    case SimdTarget::plain:
    case SimdTarget::best:
        return true;
    }
    return false;
}

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
