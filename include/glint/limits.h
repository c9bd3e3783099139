#pragma once
// The limits of scenes, pictures and memory.

#include "glint/error.h"

#include <cstdint>
#include <string>

namespace glint {

/// Largest coordinate and length, in scene units.
inline constexpr double coordinate_limit = 1e12;

/// Largest side of a picture, and largest number of pixels.
inline constexpr int picture_side_limit = 65536;
inline constexpr std::int64_t picture_pixel_limit = std::int64_t{1} << 30;

/// Largest number of samples per pixel.
inline constexpr int sample_limit = 1 << 20;

/// Bytes of memory that this process can still take: what the machine, its control groups and ulimit allow
/// it, less what it holds.
double available_memory();

/// Throws Error(resource) if there is not so much memory: "`what` takes 3.2 GiB of memory, and 300 MiB are
/// left". To be called before work that would need it: the system may promise memory that it does not have.
void require_memory(double bytes, const std::string& what, const std::string& hint,
                    const Location& where = {});

/// "512 B", "1.5 MiB".
std::string bytes_text(double bytes);

struct SceneDescription;
/// Bytes that build_scene() takes at its peak, estimated from the numbers of triangles and objects.
double build_memory(const SceneDescription& description);

} // namespace glint
