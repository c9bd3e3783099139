#pragma once
// Function tables of the kernels for each SIMD target. Used by trace and by render/shade_batch.h.

#include "glint/kernels.h"
#include "trace/mesh/tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace glint::trace {

/// How a batch is traced: as coherent packets or as streams filtered ray by ray.
enum class BatchForm : std::uint8_t { packets, streams };

struct BatchKernels {
    void (*closest)(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                    BatchForm form);
    void (*occluded)(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                     BatchForm form);
};
struct SingleKernels {
    TriangleRecord (*closest)(const MeshTree& tree, const Ray& ray);
    bool (*occluded)(const MeshTree& tree, const Ray& ray);
};

/// Plain, SSE4, AVX2, AVX-512, in this order.
inline constexpr std::size_t kernel_targets = 4;

/// Kernels by target; null if the target was not compiled.
template <class Kernels>
using KernelTable = std::array<const Kernels*, kernel_targets>;

/// The table of an object that each target's namespace defines under one name.
#define GLINT_KERNEL_TABLE(name)                                                                             \
    { HWY_CHOOSE_FALLBACK(name), HWY_CHOOSE_SSE4(name), HWY_CHOOSE_AVX2(name), HWY_CHOOSE_AVX3(name) }

extern const KernelTable<BatchKernels> batch_kernels;
extern const KernelTable<SingleKernels> single_kernels;

/// Row of a target in these tables. Throws std::invalid_argument if the machine lacks the target.
std::size_t row_of(SimdTarget target);

} // namespace glint::trace
