#pragma once
// Trigonometry of set-up: angles in degrees, as scene files give them, in double. Our own, since the C
// library's last bit changes with the CPU. Multiples of 30° and 90° come out exact where the value is.

namespace glint {

/// sin and cos of an angle in degrees, |error| below 3e-16, exact at multiples of 90.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

/// sin/cos; infinite at 90 + 180 k.
double tan_degrees(double degrees);

} // namespace glint
