#pragma once
// The sRGB curve for 8-bit vertex colours.

#include <array>

namespace glint::ply {

/// Linear light of the 256 sRGB codes. A table, as evaluating the curve takes longer than reading the rest of
/// a vertex.
const std::array<float, 256>& srgb8_table();

} // namespace glint::ply
