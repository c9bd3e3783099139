#pragma once
// Samples of four dimensions: what belongs together, such as where a path goes and which point of a lamp is
// sampled there, is stratified together.

#include "math/random.shared.h"

#include <array>

namespace glint {

/// Direction numbers of one dimension of the Sobol sequence, summed over the bits of each of an index's
/// bytes: the word of an index is the exclusive or of four entries.
using SobolTable = std::array<std::array<uint, 256>, 4>;

/// `degree` and `coefficients` of the primitive polynomial, and the first numbers m, as S. Joe and F. Y. Kuo
/// list them ("Constructing Sobol Sequences with Better Two-Dimensional Projections", SIAM J. Sci. Comput. 30
/// (5), 2008).
constexpr SobolTable sobol_table(int degree, uint coefficients, const std::array<uint, 3>& m) {
    std::array<uint, 32> direction{};
    for (int k = 0; k < 32; ++k) {
        const auto at = [&](int i) -> uint& { return direction[static_cast<std::size_t>(i)]; };
        if (k < degree) {
            at(k) = m[static_cast<std::size_t>(k)] << (31 - k);
            continue;
        }
        at(k) = at(k - degree) ^ (at(k - degree) >> degree);
        for (int j = 1; j < degree; ++j)
            if ((coefficients >> (degree - 1 - j) & 1u) != 0) at(k) ^= at(k - j);
    }
    SobolTable table{};
    for (std::size_t byte = 0; byte < 4; ++byte)
        for (std::size_t value = 0; value < 256; ++value)
            for (std::size_t bit = 0; bit < 8; ++bit)
                if ((value >> bit & 1u) != 0) table[byte][value] ^= direction[8 * byte + bit];
    return table;
}

inline constexpr SobolTable third_sobol = sobol_table(2, 1, {1, 3, 0});
inline constexpr SobolTable fourth_sobol = sobol_table(3, 1, {1, 3, 1});

constexpr uint sobol_word(const SobolTable& table, uint index) {
    return table[0][index & 255u] ^ table[1][index >> 8 & 255u] ^ table[2][index >> 16 & 255u] ^
           table[3][index >> 24];
}

/// The third and fourth dimension of point `index` of the Sobol sequence, Owen-scrambled by `key` and padded
/// by `set`, of which sample_pair() gives the first two: the four are stratified together. Numbers of
/// different sets are independent.
inline vec2 second_pair(uint key, uint index, uint set) {
    const uint stream = hash_with(key, set);
    const uint shuffled = owen_scramble(index, hash_with(stream, 0u));
    const uint a = owen_scramble(sobol_word(third_sobol, shuffled), hash_with(stream, 3u));
    const uint b = owen_scramble(sobol_word(fourth_sobol, shuffled), hash_with(stream, 4u));
    return {unit_float(a), unit_float(b)};
}

} // namespace glint
