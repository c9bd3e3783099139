#pragma once
// What changes from dispatch to dispatch, and where the parts of a scene are: the uniform block of
// shaders/data.glsl, member by member.

#include "math/vec.h"

#include <cstdint>

namespace glint {

struct GpuSettings {
    vec4 camera_eye{0.0f};
    vec4 camera_forward{0.0f};
    vec4 camera_right{0.0f};
    vec4 camera_up{0.0f};
    vec4 ambient_light{0.0f};
    vec4 background{0.0f};
    uvec4 seed{0u};
    uvec4 media_of_eye{0u};
    uvec4 limits{0u};
    uvec4 modes{0u};
    uvec4 at_shapes{0u};
    uvec4 at_tables{0u};
    uvec4 tile{0u};
    uvec4 area{0u};
    uvec4 turn{0u};
    uvec4 pass{1u, 0u, 0u, 0u};
};
static_assert(sizeof(GpuSettings) == 16 * 16);

} // namespace glint
