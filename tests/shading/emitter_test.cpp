// Points on lamps: their densities, by histograms and integrals.

#include "shading/emitter.shared.h"

#include "math/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace glint {
namespace {

TEST(Sampling, AnglesAndTheirCosinesAndSines) {
    for (int i = 0; i <= 20000; ++i) {
        const double angle = std::numbers::pi * i / 20000;
        const auto x = static_cast<float>(3 * std::cos(angle)), y = static_cast<float>(3 * std::sin(angle));
        EXPECT_NEAR(angle_of(x, std::max(0.0f, y)), angle, 4e-7);
        const auto whole = static_cast<float>(2 * angle);
        const vec2 at = cos_sin_of(whole);
        EXPECT_NEAR(at.x, std::cos(static_cast<double>(whole)), 2e-7);
        EXPECT_NEAR(at.y, std::sin(static_cast<double>(whole)), 2e-7);
    }
    EXPECT_EQ(angle_of(0.0f, 0.0f), 0.0f);
}

EmitterRecord flat(int kind, const vec3& base, const vec3& u, const vec3& v) {
    EmitterRecord e{};
    e.kind = kind;
    e.base = base;
    e.u = u;
    e.v = v;
    e.n = normalize(cross(u, v));
    e.area = length(cross(u, v)) * (kind == emitter_triangle ? 0.5f : 1.0f);
    if (kind == emitter_disk) e.area = static_cast<float>(std::numbers::pi) * dot(u, u);
    return e;
}

EmitterRecord ball(const vec3& center, float radius) {
    EmitterRecord e{};
    e.kind = emitter_sphere;
    e.base = center;
    e.radius = radius;
    e.area = static_cast<float>(4 * std::numbers::pi) * radius * radius;
    return e;
}

struct Lamp {
    std::string name;
    EmitterRecord record;
    double solid_angle; ///< seen from the origin; 0: not known in closed form
};

std::vector<Lamp> lamps() {
    return {{"square", flat(emitter_rectangle, {-0.5f, -0.5f, 1}, {1, 0, 0}, {0, 1, 0}),
             4 * std::asin(0.25 / 1.25)}, // (a/2)² / (h² + (a/2)²)
            {"parallelogram", flat(emitter_rectangle, {0.2f, -1, 0.5f}, {0.3f, 2, 0.4f}, {0.1f, 0, 1}), 0},
            {"octant", flat(emitter_triangle, {1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}), std::numbers::pi / 2},
            {"close triangle", flat(emitter_triangle, {0.01f, 0.01f, 0.02f}, {1, 0, 0}, {0, 1, 0}), 0},
            {"far triangle", flat(emitter_triangle, {90, 0, 60}, {1, 0, 0}, {0, 1, 0}), 0},
            {"disk", flat(emitter_disk, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}),
             2 * std::numbers::pi * (1 - 2 / std::sqrt(5.0))},
            {"ball", ball({0.3f, 0.4f, 2}, 1), 2 * std::numbers::pi * (1 - std::sqrt(1 - 1 / 4.25))},
            {"far ball", ball({3000, 0, 4000}, 1), 2 * std::numbers::pi * (1 - std::sqrt(1 - 1 / 25e6))},
            {"ball around", ball({0.3f, 0, 0}, 2), 4 * std::numbers::pi}};
}

TEST(Emitter, SamplesHaveTheDensityThatTheyGive) {
    constexpr uint samples = 1 << 16;
    for (const Lamp& lamp : lamps()) {
        double angle = 0;
        for (uint i = 0; i < samples; ++i) {
            const vec2 u = sample_pair(7, i, 3);
            const EmitterSample s = sample_emitter(lamp.record, vec3(0.0f), u.x, u.y);
            ASSERT_GT(s.pdf, 0) << lamp.name;
            EXPECT_EQ(s.pdf, emitter_pdf(lamp.record, vec3(0.0f), s.p, s.n)) << lamp.name;
            EXPECT_NEAR(length(s.direction), 1, 1e-6);
            angle += 1.0 / static_cast<double>(s.pdf) / samples;
        }
        if (lamp.solid_angle == 0) continue;
        EXPECT_NEAR(angle, lamp.solid_angle, 2e-3 * lamp.solid_angle) << lamp.name;
    }
}

/// The statistic of χ² between the samples' places in a grid on the lamp and the integral of their density
/// there, in standard deviations from its mean.
double deviation(const EmitterRecord& e) {
    constexpr int cells_across = 12, fine = 12, drawn = 200000;
    const auto cell_of = [&](const vec3& p) {
        // The weights of the edges.
        const vec3 d = p - e.base;
        const double uu = dot(e.u, e.u), vv = dot(e.v, e.v), uv = dot(e.u, e.v);
        const double du = dot(d, e.u), dv = dot(d, e.v), det = uu * vv - uv * uv;
        const double x = (du * vv - dv * uv) / det, y = (dv * uu - du * uv) / det;
        const auto clamped = [](double a) {
            return std::min(cells_across - 1, std::max(0, static_cast<int>(a * cells_across)));
        };
        return clamped(x) + cells_across * clamped(y);
    };
    std::vector<double> found(cells_across * cells_across, 0), expected(cells_across * cells_across, 0);
    for (uint i = 0; i < drawn; ++i) {
        const float u = unit_float(hash_with(1, i)), v = unit_float(hash_with(2, i));
        found[static_cast<std::size_t>(cell_of(sample_emitter(e, vec3(0.0f), u, v).p))] += 1;
    }
    constexpr int points = cells_across * fine;
    for (int i = 0; i < points; ++i)
        for (int j = 0; j < points; ++j) {
            const float u = (static_cast<float>(i) + 0.5f) / points,
                        v = (static_cast<float>(j) + 0.5f) / points;
            if (e.kind == emitter_triangle && u + v > 1) continue;
            const vec3 p = e.base + e.u * u + e.v * v;
            const double area = static_cast<double>(length(cross(e.u, e.v))) / (points * points);
            const double density = static_cast<double>(emitter_pdf(e, vec3(0.0f), p, e.n)) *
                                   static_cast<double>(std::abs(dot(e.n, normalize(p))) / dot(p, p));
            expected[static_cast<std::size_t>(cell_of(p))] += drawn * area * density;
        }
    double chi = 0;
    int cells = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        // Cells on a triangle's hypotenuse are integrated too coarsely.
        const bool cut = e.kind == emitter_triangle && i % cells_across + i / cells_across + 2 > cells_across;
        if (expected[i] < 5 || cut) continue;
        chi += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
        ++cells;
    }
    return (chi - cells) / std::sqrt(2.0 * cells);
}

TEST(G18, PointsOnFlatLampsAreSpreadAsTheirDensitySays) {
    for (const Lamp& lamp : lamps()) {
        if (!is_flat_with_corners(lamp.record)) continue;
        EXPECT_LT(std::abs(deviation(lamp.record)), 4) << lamp.name;
    }
}

TEST(Emitter, PointsOfABallInAConeAreOnItsNearSide) {
    for (const EmitterRecord& e :
         {ball({0.3f, 0.4f, 2}, 1), ball({0, 0, 1.01f}, 1), ball({3000, 0, 4000}, 1)})
        for (uint i = 0; i < 1000; ++i) {
            const vec2 u = sample_pair(7, i, 3);
            const EmitterSample s = sample_emitter(e, vec3(0.0f), u.x, u.y);
            EXPECT_NEAR(length(s.p - e.base), e.radius, 1e-6f * length(e.base) + 2e-7f);
            EXPECT_LE(dot(s.n, s.direction), 1e-3f);
            EXPECT_LT(length(end_before(e, s)), s.distance + 1e-6f * s.distance);
        }
}

} // namespace
} // namespace glint
