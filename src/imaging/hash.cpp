// Hashes of pictures (XXH3, 128 bits).

#include "glint/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace glint {

namespace {

/// Swaps bytes in a small buffer, so no second picture is needed.
void update_swapped(XXH3_state_t& state, std::span<const float> values) {
    std::array<unsigned char, 4096> buffer;
    constexpr std::size_t batch = buffer.size() / sizeof(float);
    while (!values.empty()) {
        const std::size_t count = std::min(batch, values.size());
        std::memcpy(buffer.data(), values.data(), count * sizeof(float));
        for (std::size_t i = 0; i < count; ++i)
            std::reverse(buffer.begin() + static_cast<std::ptrdiff_t>(4 * i),
                         buffer.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
        XXH3_128bits_update(&state, buffer.data(), count * sizeof(float));
        values = values.subspan(count);
    }
}

XXH128_hash_t hash_little_endian(std::span<const float> values) {
    if constexpr (std::endian::native == std::endian::little)
        return XXH3_128bits(values.data(), values.size_bytes());
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    update_swapped(state, values);
    return XXH3_128bits_digest(&state);
}

} // namespace

std::string picture_hash(const Image& image) {
    const XXH128_hash_t hash = hash_little_endian(image.pixels);
    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, hash);

    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes.digest) {
        text += digits[byte >> 4U];
        text += digits[byte & 15U];
    }
    return text;
}

} // namespace glint
