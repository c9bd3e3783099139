#pragma once
// The sentinel of indices.

#include <cstdint>

namespace glint {

/// The index of nothing: no triangle, no instance, no child.
inline constexpr std::uint32_t invalid_index = 0xffffffffu;

} // namespace glint
