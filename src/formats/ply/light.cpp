// Table of the sRGB curve.

#include "formats/ply/light.h"

#include "imaging/tone.h"

#include <cstddef>
#include <cstdint>

namespace glint::ply {

const std::array<float, 256>& srgb8_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> light{};
        for (std::size_t code = 0; code < light.size(); ++code)
            light[code] = linear_from_srgb8(static_cast<std::uint8_t>(code));
        return light;
    }();
    return table;
}

} // namespace glint::ply
