#pragma once
// Planes, spheres and cylinders against many rays, shape by shape, several rays at once. Private to this
// room.

#include "trace/world_data.h"

#include <cstdint>
#include <span>

namespace glint {

/// The closest plane, sphere or cylinder of each ray, with the bits of closest_surface(). Meant for few of
/// them: every one is tested. mesh_ahead[i] is 0 where ray i surely meets no triangle before that.
void closest_surfaces(const WorldData& world, std::span<const Ray> rays, Hit* hits, std::uint8_t* mesh_ahead);

/// 1 for every ray that meets a plane, sphere or cylinder, else 0. mesh_ahead[i] is 0 where ray i is blocked,
/// or surely meets no triangle.
void occluded_surfaces(const WorldData& world, std::span<const Ray> rays, std::uint8_t* blocked,
                       std::uint8_t* mesh_ahead);

} // namespace glint
