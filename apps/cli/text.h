#pragma once
// Formats numbers, times and sizes for people.

#include <cstdint>
#include <string>

namespace glint::cli {

/// 871306 → "871,306".
std::string with_commas(std::uint64_t number);
/// "1 triangle", "2,000 triangles"; the plural adds an s.
std::string counted(std::uint64_t number, const std::string& noun);
/// Seconds: "0.012 s", "1.23 s", "2 min 05 s", "3 h 07 min".
std::string duration(double seconds);
/// In whole seconds, rounded up: "31 s".
std::string whole_duration(double seconds);
/// "3.41 Mrays/s".
std::string ray_rate(std::uint64_t rays, double seconds);
/// Millions of rays per second; 0 if no time has passed.
double mega_rays(std::uint64_t rays, double seconds);

/// The last part of a setting's key: "glint.max_depth" → "max_depth".
std::string setting_name(const std::string& key);

} // namespace glint::cli
