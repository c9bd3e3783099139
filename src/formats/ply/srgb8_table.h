#pragma once
// The sRGB curve for 8-bit vertex colours.

#include "imaging/tone.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace glint::formats::ply {

/// Linear light of the 256 sRGB codes. A table, as evaluating the curve takes longer than reading the rest of
/// a vertex.
inline const std::array<float, 256>& srgb8_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> light{};
        for (std::size_t code = 0; code < light.size(); ++code)
            light[code] = imaging::linear_from_srgb8(static_cast<std::uint8_t>(code));
        return light;
    }();
    return table;
}

} // namespace glint::formats::ply
