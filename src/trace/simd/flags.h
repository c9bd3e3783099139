#pragma once
// Expands bit masks to bytes, for kernels that test many rays at once. Private to this room.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace glint::trace {

/// Writes the lowest `count` bits, at most 64, as one byte of 0 or 1 each.
inline void write_flags(std::uint64_t bits, std::uint8_t* flags, std::size_t count) {
    for (std::size_t i = 0; i < count; i += 8) {
        const std::uint64_t one_each = (bits >> i & 255u) * 0x0101010101010101u & 0x8040201008040201u;
        std::uint64_t eight = (one_each + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
        if constexpr (std::endian::native == std::endian::big) eight = __builtin_bswap64(eight);
        if (count - i >= 8)
            std::memcpy(flags + i, &eight, 8);
        else
            std::memcpy(flags + i, &eight, count - i);
    }
}

} // namespace glint::trace
