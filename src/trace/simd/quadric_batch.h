#pragma once
// Kernels for planes and quadrics: one shape at a time against vectors of rays. Private to this room.

#include "trace/simd/kernel_table.h"
#include "trace/world/data.h"

#include <cstddef>
#include <cstdint>

namespace glint::trace {

/// For each SIMD target. Fastest if neighbouring rays are similar.
struct QuadricKernels {
    /// The closest plane or quadric of each ray, with the bits of closest_surface(). meets_mesh[i] is 0 if
    /// ray i certainly meets no triangle before that.
    void (*closest)(const WorldData& world, const Ray* rays, std::size_t count, Hit* hits,
                    std::uint8_t* meets_mesh);
    /// 1 for every ray that hits a plane or quadric, otherwise 0. meets_mesh[i] is 0 if ray i is blocked or
    /// certainly meets no triangle.
    void (*occluded)(const WorldData& world, const Ray* rays, std::size_t count, std::uint8_t* blocked,
                     std::uint8_t* meets_mesh);
};
extern const KernelTable<QuadricKernels> quadric_kernels;

/// World::surfaces().
using PointKernel = void(const WorldData& world, const Ray* rays, const Hit* hits, std::size_t count,
                         const SurfaceRows& rows, std::uint8_t* done);
extern const KernelTable<PointKernel> point_kernels;

} // namespace glint::trace
