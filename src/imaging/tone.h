#pragma once
// Conversion between linear light and the codes of picture files. The sRGB curve (IEC 61966-2-1) is computed
// with + - * / only, not the C library's pow, so codes do not depend on the machine.

#include <cstdint>
#include <span>

namespace glint::imaging {

/// Linear light of an sRGB value 0 … 1 by the exact curve; the linear piece extends below 0.
double linear_from_srgb(double encoded);

/// Linear light of a code, rounded to the nearest float. Encoding returns the code.
float linear_from_srgb8(std::uint8_t code);
float linear_from_srgb16(std::uint16_t code);

/// The sRGB code nearest to the exact curve at `linear`. Values below 0 and NaN give 0, values above 1 the
/// largest code.
std::uint8_t srgb8_from_linear(float linear);
/// Converts an array.
void srgb8_codes(std::span<const float> linear, std::uint8_t* codes);
std::uint16_t srgb16_from_linear(float linear);

/// Truncates without a curve: min(255, floor(255 · linear)), or 65535 for 16 bits. Values below 0 and NaN
/// give 0.
std::uint8_t raw8_from_linear(float linear);
std::uint16_t raw16_from_linear(float linear);

/// Rounds a value in 0 … 1, such as coverage, to the nearest code, without a curve. Values below 0 and NaN
/// give 0.
std::uint8_t unorm8_from_float(float share);
std::uint16_t unorm16_from_float(float share);

} // namespace glint::imaging
