#pragma once
// Planes and quadrics against many rays, shape by shape, several rays at once. Private to this
// room.

#include "trace/simd/kernel_table.h"
#include "trace/world/data.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace glint::trace {

/// The kernels as compiled for each SIMD target. Rays that are neighbours should go nearly the same way.
struct SurfaceKernels {
    /// The closest plane or quadric of each ray, with the bits of closest_surface(). mesh_ahead[i]
    /// is 0 where ray i surely meets no triangle before that.
    void (*closest)(const WorldData& world, const Ray* rays, std::size_t count, Hit* hits,
                    std::uint8_t* meets_mesh);
    /// 1 for every ray that meets a plane or quadric, else 0. mesh_ahead[i] is 0 where ray i is
    /// blocked, or surely meets no triangle.
    void (*occluded)(const WorldData& world, const Ray* rays, std::size_t count, std::uint8_t* blocked,
                     std::uint8_t* meets_mesh);
};
extern const std::array<SurfaceKernels, kernel_targets> surface_kernels;

/// What World::surfaces() does.
using PointKernel = void (*)(const WorldData& world, const Ray* rays, const Hit* hits, std::size_t count,
                             const SurfaceRows& rows, std::uint8_t* done);
extern const std::array<PointKernel, kernel_targets> point_kernels;

} // namespace glint::trace
