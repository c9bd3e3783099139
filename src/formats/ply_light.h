#pragma once

#include <array>

namespace glint::ply {

/// Linear light of the 256 sRGB codes, computed once: the curve takes longer than the rest of a vertex.
const std::array<float, 256>& light_of_codes();

} // namespace glint::ply
