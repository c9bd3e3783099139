#ifndef GLINT_MATH_RANDOM_SHARED_H
#define GLINT_MATH_RANDOM_SHARED_H
#include "math/shared.h"

// Counter-based random numbers: pure functions of (seed, pixel, sample, dimension), so any sample of any
// pixel can be drawn in any order on any machine.

GLINT_SHARED_BEGIN

/// A 32-bit mix with full avalanche (the finaliser of MurmurHash3, Appleby 2011).
GLINT_FN uint hash_mix(uint x) {
    x = x ^ (x >> 16);
    x = x * 0x85ebca6bu;
    x = x ^ (x >> 13);
    x = x * 0xc2b2ae35u;
    x = x ^ (x >> 16);
    return x;
}

/// Combines a hash with another word.
GLINT_FN uint hash_with(uint h, uint word) { return hash_mix(h * 0x9e3779b1u + word + 0x7f4a7c15u); }

GLINT_FN uint reverse_bits(uint x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// Owen's nested uniform scrambling of the bits of x, most significant first, by a hash in which each bit
/// depends on higher bits only (Laine and Karras 2011; Burley, "Practical Hash-based Owen Scrambling", JCGT
/// 2020).
GLINT_FN uint owen_scramble(uint x, uint key) {
    x = reverse_bits(x);
    x = x + key;
    x = x ^ (x * 0x6c50b47cu);
    x = x ^ (x * 0xb82f1e52u);
    x = x ^ (x * 0xc7afe638u);
    x = x ^ (x * 0x8d22f6e6u);
    return reverse_bits(x);
}

/// The second dimension of the Sobol sequence; the first is reverse_bits(index). Its generator matrix is
/// Pascal's triangle mod 2, the Kronecker power of (1 1; 0 1), so five shifts suffice for 32 columns.
GLINT_FN uint sobol_second(uint index) {
    uint x = index;
    x = x ^ ((x >> 1) & 0x55555555u);
    x = x ^ ((x >> 2) & 0x33333333u);
    x = x ^ ((x >> 4) & 0x0f0f0f0fu);
    x = x ^ ((x >> 8) & 0x00ff00ffu);
    x = x ^ ((x >> 16) & 0x0000ffffu);
    return reverse_bits(x);
}

/// A float in [0, 1): the high 24 bits.
GLINT_FN float unit_float(uint bits) { return float(bits >> 8) * (1.0f / 16777216.0f); }

/// The key of a pixel's random stream.
GLINT_FN uint pixel_key(uint seed_low, uint seed_high, uint x, uint y) {
    uint h = hash_with(0x243f6a88u, seed_low);
    h = hash_with(h, seed_high);
    h = hash_with(h, x);
    return hash_with(h, y);
}

/// Point `index` of a (0, 2)-sequence in base 2, Owen-scrambled by `key` and padded by `dimension` (one per
/// pair of numbers): every 2^k first points are stratified in all elementary intervals of 2^k boxes.
GLINT_FN vec2 sample_pair(uint key, uint index, uint dimension) {
    uint stream = hash_with(key, dimension);
    uint shuffled = owen_scramble(index, hash_with(stream, 0u));
    uint a = owen_scramble(reverse_bits(shuffled), hash_with(stream, 1u));
    uint b = owen_scramble(sobol_second(shuffled), hash_with(stream, 2u));
    return vec2(unit_float(a), unit_float(b));
}

GLINT_SHARED_END
#endif
