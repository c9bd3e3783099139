#pragma once
// Input and output of estimators: camera samples and what is measured along them.

#include "glint/term.h"
#include "math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace glint::rendering {

/// A pixel of the whole picture (not of a crop), from the top left.
struct Pixel {
    int x = 0;
    int y = 0;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// A camera ray and the film sample that it measures.
struct CameraSample {
    vec3 origin{0.0f};
    vec3 direction{0.0f}; ///< unit
    Pixel pixel;
    std::uint32_t index = 0; ///< of the sample within its pixel; with the pixel it names all random numbers
    float weight = 1;        ///< of the pixel filter: +1 or −1
};

/// Radiance by the terms of an integrator, Term or PathTerm; the sum in their order is the radiance.
struct Terms {
    std::array<vec3, term_count> value;

    vec3& operator[](Term term) { return value[static_cast<std::size_t>(term)]; }
    const vec3& operator[](Term term) const { return value[static_cast<std::size_t>(term)]; }
    vec3& operator[](PathTerm term) { return value[static_cast<std::size_t>(term)]; }
    vec3 sum() const {
        vec3 total = value[0];
        for (std::size_t i = 1; i < value.size(); ++i) total = total + value[i];
        return total;
    }
    /// One of them if a number is given, else their sum.
    vec3 sum(const std::optional<int>& term) const {
        return term ? value[static_cast<std::size_t>(*term)] : sum();
    }
    friend Terms operator+(Terms a, const Terms& b) {
        for (std::size_t i = 0; i < a.value.size(); ++i) a.value[i] = a.value[i] + b.value[i];
        return a;
    }
    friend Terms operator-(Terms a, const Terms& b) {
        for (std::size_t i = 0; i < a.value.size(); ++i) a.value[i] = a.value[i] - b.value[i];
        return a;
    }
    friend Terms operator/(Terms a, float divisor) {
        for (vec3& v : a.value) v = v / divisor;
        return a;
    }
};

/// Values measured along one camera ray.
struct Channels {
    vec3 radiance{0.0f};
    Terms terms{};        ///< their sum is the radiance, to the bit; unchanged if not requested
    bool covered = false; ///< the ray hit something
};

/// Rays traced, by kind, and rays that were not; light that was limited.
struct RayCounts {
    std::uint64_t primary = 0;
    std::uint64_t reflected = 0;
    std::uint64_t refracted = 0;
    std::uint64_t shadow = 0;
    std::uint64_t left_out = 0; ///< mirror and refracted rays below min_weight
    double light = 0;           ///< of all samples, the sum of their channels; if clamp_indirect is set
    double clamped = 0;         ///< what clamp_indirect took of it

    std::uint64_t total() const { return primary + reflected + refracted + shadow; }
    friend RayCounts operator+(const RayCounts& a, const RayCounts& b) {
        return {a.primary + b.primary, a.reflected + b.reflected, a.refracted + b.refracted,
                a.shadow + b.shadow,   a.left_out + b.left_out,   a.light + b.light,
                a.clamped + b.clamped};
    }
};

} // namespace glint::rendering
