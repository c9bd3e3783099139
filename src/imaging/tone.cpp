// The sRGB curve and its inverse.

#include "imaging/tone.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace glint::imaging {

namespace {

/// Fifth root of y > 0 by Newton iteration, which decreases monotonically from above: the same bits on every
/// machine.
double fifth_root(double y) {
    double root = y > 1 ? y : 1;
    for (;;) {
        const double fourth = (root * root) * (root * root);
        const double next = (4 * root + y / fourth) / 5;
        if (!(next < root)) return root;
        root = next;
    }
}

/// The sRGB curve as a table of the linear values at which the rounded code increases. The slope is at most
/// 12.92, so with more than 12.92 buckets a code no bucket contains two steps: a code is that of the bucket's
/// start or the next.
class SrgbTable {
  public:
    SrgbTable(unsigned highest, std::size_t buckets)
        : highest_(highest), buckets_(static_cast<float>(buckets)), threshold_(highest + 2), first_(buckets) {
        for (unsigned code = 1; code <= highest; ++code)
            threshold_[code] = nearest_above(linear_from_srgb((code - 0.5) / highest));
        threshold_[highest + 1] = std::numeric_limits<float>::infinity();

        unsigned code = 0;
        for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
            while (threshold_[code + 1] <= static_cast<float>(bucket) / buckets_) ++code;
            first_[bucket] = static_cast<std::uint16_t>(code);
        }
    }

    unsigned code(float linear) const {
        if (!(linear > 0)) return 0;
        if (linear >= 1) return highest_;
        const unsigned first = first_[static_cast<std::size_t>(linear * buckets_)];
        return first + (linear >= threshold_[first + 1] ? 1U : 0U);
    }

  private:
    /// The least float not below x: a float reaches it exactly when it reaches x.
    static float nearest_above(double x) {
        const auto rounded = static_cast<float>(x);
        return rounded >= x ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
    }

    unsigned highest_;
    float buckets_;                    ///< a power of two, so that scaling is exact
    std::vector<float> threshold_;     ///< by code: least value with this code
    std::vector<std::uint16_t> first_; ///< by bucket: code at its start
};

const SrgbTable& table_of_bytes() {
    static const SrgbTable table(255, std::size_t{1} << 12U);
    return table;
}

double truncated(float linear, double highest) {
    if (!(linear > 0)) return 0;
    const double code = highest * linear;
    return code < highest ? code : highest;
}

double rounded(float share, double highest) {
    if (!(share > 0)) return 0;
    const double code = highest * share + 0.5;
    return code < highest ? code : highest;
}

} // namespace

double linear_from_srgb(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    // x^2.4 = x² · (x²)^(1/5)
    const double base = (encoded + 0.055) / 1.055;
    const double square = base * base;
    return square * fifth_root(square);
}

float linear_from_srgb8(std::uint8_t code) { return static_cast<float>(linear_from_srgb(code / 255.0)); }

float linear_from_srgb16(std::uint16_t code) { return static_cast<float>(linear_from_srgb(code / 65535.0)); }

std::uint8_t srgb8_from_linear(float linear) {
    return static_cast<std::uint8_t>(table_of_bytes().code(linear));
}

void srgb8_codes(std::span<const float> linear, std::uint8_t* codes) {
    const SrgbTable& table = table_of_bytes();
    for (const float value : linear) *codes++ = static_cast<std::uint8_t>(table.code(value));
}

std::uint16_t srgb16_from_linear(float linear) {
    static const SrgbTable table(65535, std::size_t{1} << 20U);
    return static_cast<std::uint16_t>(table.code(linear));
}

std::uint8_t raw8_from_linear(float linear) { return static_cast<std::uint8_t>(truncated(linear, 255)); }

std::uint16_t raw16_from_linear(float linear) { return static_cast<std::uint16_t>(truncated(linear, 65535)); }

std::uint8_t unorm8_from_float(float share) { return static_cast<std::uint8_t>(rounded(share, 255)); }

std::uint16_t unorm16_from_float(float share) { return static_cast<std::uint16_t>(rounded(share, 65535)); }

} // namespace glint::imaging
