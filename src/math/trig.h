#pragma once
// Trigonometric functions of angles in degrees in double precision, for scene set-up. Independent of the C
// library, whose last bit varies between machines. Exact at multiples of 30° and 90° where the value is
// representable.

namespace glint {

/// sin and cos of an angle in degrees, |error| below 3e-16, exact at multiples of 90.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

/// sin/cos; infinite at 90 + 180 k.
double tan_degrees(double degrees);

/// Arc cosine in 0 … 180 degrees and arc sine in −90 … 90 degrees, |error| below 1e-13. Arguments are clamped
/// to ±1.
double acos_degrees(double cosine);
double asin_degrees(double sine);

} // namespace glint
