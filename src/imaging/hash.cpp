// Hashes of pictures (XXH3, 128 bits).

#include "glint/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <vector>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace glint {

namespace {

XXH128_hash_t hash_little_endian(std::span<const float> values) {
    if constexpr (std::endian::native == std::endian::little)
        return XXH3_128bits(values.data(), values.size_bytes());
    std::vector<std::array<unsigned char, 4>> swapped(values.size());
    std::memcpy(swapped.data(), values.data(), values.size_bytes());
    for (auto& bytes : swapped) std::reverse(bytes.begin(), bytes.end());
    return XXH3_128bits(swapped.data(), values.size_bytes());
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
