#pragma once
// Trigonometry of set-up: angles in degrees, as scene files give them, in double. Our own, since the C
// library's last bit changes with the CPU. Multiples of 30° and 90° come out exact where the value is.

namespace glint {

/// sin and cos of an angle in degrees, |error| below 3e-16, exact at multiples of 90.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

/// sin/cos; infinite at 90 + 180 k.
double tan_degrees(double degrees);

/// The angle in degrees, 0 … 180, of a cosine, and −90 … 90 of a sine; |error| below 1e-13. What lies beyond
/// ±1 counts as ±1.
double acos_degrees(double cosine);
double asin_degrees(double sine);

} // namespace glint
