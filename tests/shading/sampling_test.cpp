// Directions from random numbers: their distributions, by a fine grid of the unit square.

#include "shading/sampling.shared.h"

#include "math/sobol.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace glint {
namespace {

constexpr int grid_size = 512;
float cell(int i) { return (static_cast<float>(i) + 0.5f) / grid_size; }

TEST(Sampling, SineAndCosineOfUpToAnEighthTurn) {
    for (int i = -1000; i <= 1000; ++i) {
        const float x = 0.785398163f * static_cast<float>(i) / 1000;
        EXPECT_NEAR(sin_of_eighth(x), std::sin(static_cast<double>(x)), 1.2e-7 * std::abs(x));
        EXPECT_NEAR(cos_of_eighth(x), std::cos(static_cast<double>(x)), 1.2e-7);
    }
}

TEST(Sampling, SetsStratifyEachDimension) {
    std::array<std::set<int>, 4> strata;
    for (uint i = 0; i < 256; ++i) {
        const vec2 first = sample_pair(99, i, 3), second = second_pair(99, i, 3);
        const float at[] = {first.x, first.y, second.x, second.y};
        for (std::size_t d = 0; d < 4; ++d) strata[d].insert(static_cast<int>(at[d] * 256));
    }
    for (const auto& found : strata) EXPECT_EQ(found.size(), 256u);
}

/// The mean square error of 16 x y z w, whose mean is 1, divided by that of as many random points.
double error_of_product(uint points, bool joint) {
    constexpr uint runs = 64;
    double error = 0;
    for (uint run = 0; run < runs; ++run) {
        double sum = 0;
        for (uint i = 0; i < points; ++i) {
            const vec2 first = sample_pair(hash_mix(run), i, 5);
            const vec2 second = joint ? second_pair(hash_mix(run), i, 5) : sample_pair(hash_mix(run), i, 6);
            sum += static_cast<double>(16 * first.x * first.y * second.x * second.y);
        }
        error += std::pow(sum / points - 1, 2) / runs;
    }
    return error * points / (std::pow(4.0 / 3, 4) - 1);
}

TEST(Sampling, FourJointDimensionsConvergeFasterThanTwoPairs) {
    EXPECT_LT(error_of_product(64, true), 0.1);
    EXPECT_LT(error_of_product(1024, true), 0.005);
    EXPECT_GT(error_of_product(1024, false), 0.1);
}

/// Uniform by area: every circle and every sector has its share of the points.
TEST(Sampling, TheDiskIsCoveredUniformly) {
    int within[4] = {}, sectors[8] = {};
    for (int i = 0; i < grid_size; ++i)
        for (int j = 0; j < grid_size; ++j) {
            const vec3 p = disk_sample(cell(i), cell(j));
            const double r = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
            ASSERT_LE(r, 1 + 1e-6);
            for (int k = 0; k < 4; ++k)
                if (r < 0.25 * (k + 1)) ++within[k];
            const double turn = std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)) / 6.283185307;
            ++sectors[static_cast<int>(std::floor((turn < 0 ? turn + 1 : turn) * 8)) % 8];
        }
    const double points = double{grid_size} * grid_size;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(within[k] / points, std::pow(0.25 * (k + 1), 2), 0.002) << k;
    for (const int sector : sectors) EXPECT_NEAR(sector / points, 0.125, 0.002);
}

/// The mean of cos^k θ is 2 / (k + 2).
TEST(Sampling, TheHemisphereIsWeightedByTheCosine) {
    double cosine = 0, square = 0, x = 0;
    for (int i = 0; i < grid_size; ++i)
        for (int j = 0; j < grid_size; ++j) {
            const vec3 d = cosine_sample(cell(i), cell(j));
            EXPECT_NEAR(length(d), 1, 1e-6);
            cosine += d.z;
            square += d.z * d.z;
            x += d.x;
        }
    const double points = double{grid_size} * grid_size;
    EXPECT_NEAR(cosine / points, 2.0 / 3, 1e-4);
    EXPECT_NEAR(square / points, 0.5, 1e-4);
    EXPECT_NEAR(x / points, 0, 1e-4);
}

TEST(Sampling, TurningKeepsLengthsAndAngles) {
    for (int i = 0; i < 1000; ++i) {
        const auto t = static_cast<float>(i);
        const vec3 n = normalize(vec3(std::sin(t), std::cos(1.7f * t), std::sin(2.3f * t + 1)));
        const vec3 x = turned_to(n, vec3(1, 0, 0)), y = turned_to(n, vec3(0, 1, 0)),
                   z = turned_to(n, vec3(0, 0, 1));
        EXPECT_EQ(z, n);
        EXPECT_NEAR(length(x), 1, 1e-6);
        EXPECT_NEAR(length(cross(x, y) - n), 0, 1e-6);
    }
    EXPECT_EQ(turned_to(vec3(0, 0, -1), vec3(0, 0, 1)), vec3(0, 0, -1));
}

} // namespace
} // namespace glint
