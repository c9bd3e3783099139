#pragma once
// Random numbers, scales and offsets of stress cases, determined by the seed on every machine.

#include "math/vec.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace glint::stress {

/// SplitMix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t x = state_;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }
    /// In [0, n), n > 0.
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(((bits() >> 32) * n) >> 32); }
    /// In [lo, hi].
    int between(int lo, int hi) {
        return lo + static_cast<int>(below(static_cast<std::uint32_t>(hi - lo + 1)));
    }
    bool one_in(std::uint32_t n) { return below(n) == 0; }
    /// In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double uniform(double lo, double hi) {
        const double x = unit();
        return lo + (hi - lo) * x;
    }
    /// 10^k for a random k in [lo, hi], by products: the C library's pow varies between compilers.
    double power_of_ten(int lo, int hi) {
        const int k = between(lo, hi);
        double power = 1.0;
        for (int i = 0; i < std::abs(k); ++i) power *= 10.0;
        return k < 0 ? 1.0 / power : power;
    }
    int axis() { return between(0, 2); }
    double sign() { return one_in(2) ? 1.0 : -1.0; }
    /// Along one of the axes, of unit length.
    dvec3 along_axis() {
        dvec3 d(0.0);
        const int k = axis();
        d[k] = sign();
        return d;
    }
    /// In the cube [-size, size]^3.
    dvec3 in_cube(double size) {
        const double x = uniform(-size, size);
        const double y = uniform(-size, size);
        const double z = uniform(-size, size);
        return {x, y, z};
    }
    /// In the ball of that radius.
    dvec3 in_ball(double radius) {
        for (;;) {
            const dvec3 p = in_cube(1.0);
            if (glm::dot(p, p) <= 1.0) return p * radius;
        }
    }
    /// Of unit length.
    dvec3 direction() {
        for (;;) {
            const dvec3 p = in_cube(1.0);
            const double squared = glm::dot(p, p);
            if (squared <= 1.0 && squared > 1e-4) return p / std::sqrt(squared);
        }
    }

  private:
    std::uint64_t state_;
};

/// A scaled translation: p -> (p + offset) · scale.
struct ScaledOffset {
    dvec3 offset{0};
    double scale = 1;

    vec3 operator()(const dvec3& p) const { return vec3((p + offset) * scale); }
};

/// The identity with probability 1/2, otherwise a scale within 10^±12 and an offset of at most
/// 2^`offset_bits`.
inline ScaledOffset random_offset(Random& random, int offset_bits) {
    ScaledOffset to_world;
    if (random.one_in(2)) return to_world;
    if (random.one_in(2)) to_world.scale = random.power_of_ten(-12, 12);
    if (random.one_in(2)) {
        const int bits = random.between(0, offset_bits);
        to_world.offset = random.in_cube(std::ldexp(1.0, bits));
    }
    return to_world;
}

} // namespace glint::stress
