#pragma once
// From linear light to the codes of a picture file and back. The bytes of a picture depend on the light
// alone: the sRGB curve (IEC 61966-2-1) is computed with + - * / only, never with the C library's pow.

#include <cstdint>
#include <span>

namespace glint {

/// Linear light of an sRGB value 0 … 1, the exact curve; the linear piece goes on below 0.
double linear_from_srgb(double encoded);

/// Linear light of a code, to the nearest float. Encoding it gives the code back.
float linear_from_srgb8(std::uint8_t code);
float linear_from_srgb16(std::uint16_t code);

/// The sRGB code nearest to the exact curve at `linear`. Below 0 and NaN give 0, above 1 the highest code.
std::uint8_t srgb8_from_linear(float linear);
/// The codes of many values.
void srgb8_codes(std::span<const float> linear, std::uint8_t* codes);
std::uint16_t srgb16_from_linear(float linear);

/// Without a curve, truncated: min(255, floor(255 · linear)), 65535 for 16 bits. Below 0 and NaN give 0.
std::uint8_t raw8_from_linear(float linear);
std::uint16_t raw16_from_linear(float linear);

/// A share 0 … 1 (coverage), rounded to the nearest code; no curve. Below 0 and NaN give 0.
std::uint8_t unorm8_from_float(float share);
std::uint16_t unorm16_from_float(float share);

} // namespace glint
