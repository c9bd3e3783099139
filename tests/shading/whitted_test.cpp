// The equations of the light model one by one, against double precision (docs/light-model.md).

#include "shading/whitted.shared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glint {
namespace {

constexpr double one_degree = 3.14159265358979323846 / 180;
const vec3 up(0, 0, 1);

/// The unit vector `degrees` from +z, toward +x.
vec3 at(double degrees) {
    return vec3(static_cast<float>(std::sin(degrees * one_degree)), 0,
                static_cast<float>(std::cos(degrees * one_degree)));
}

float blinn_lobe(const vec3& n, const vec3& l, const vec3& v, float m) {
    return lobe_of(blinn_cosine(n, l, v), m);
}
float phong_lobe(const vec3& n, const vec3& l, const vec3& v, float m) {
    return lobe_of(phong_cosine(n, l, v), m);
}

TEST(LightCosine, IsZeroBelowEitherHorizon) {
    EXPECT_FLOAT_EQ(light_cosine(up, up, at(60)), 0.5f);
    EXPECT_EQ(light_cosine(up, up, at(91)), 0);
    EXPECT_EQ(light_cosine(at(80), up, at(95)), 0) << "the shading normal alone would light it";
    EXPECT_EQ(light_cosine(at(80), up, at(-20)), 0);
    EXPECT_EQ(light_cosine(up, up, vec3(1, 0, 0)), 0);
}

TEST(PointLight, FallsWithTheSquareAndGivesNothingAtItself) {
    EXPECT_EQ(point_light_arriving(vec3(8, 4, 2), 0.5f, 4), vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(point_light_arriving(vec3(8), 1, 0), vec3(0.0f));
}

TEST(SpotFalloff, IsSmoothBetweenTheConesAndSharpWithoutAGap) {
    EXPECT_EQ(spot_falloff(0.9f, 0.5f, 0.9f), 1);
    EXPECT_EQ(spot_falloff(0.5f, 0.5f, 0.9f), 0);
    EXPECT_FLOAT_EQ(spot_falloff(0.7f, 0.5f, 0.9f), 0.5f);
    EXPECT_EQ(spot_falloff(0.5f, 0.5f, 0.5f), 1);
    EXPECT_EQ(spot_falloff(0.4999f, 0.5f, 0.5f), 0);
    float last = 0;
    for (float c = 0.4f; c < 1; c += 0.001f) {
        const float share = spot_falloff(c, 0.5f, 0.9f);
        EXPECT_GE(share, last);
        last = share;
    }
}

TEST(Lobes, StayBetweenZeroAndOne) {
    for (const float m : {0.0f, 0.5f, 1.0f, 32.0f, 1e4f, 1e9f, 1e30f})
        for (double a = -89; a < 90; a += 7.3)
            for (double b = -89; b < 90; b += 5.9)
                for (const float lobe :
                     {blinn_lobe(at(3), at(a), at(b), m), phong_lobe(at(3), at(a), at(b), m)}) {
                    EXPECT_GE(lobe, 0);
                    EXPECT_LE(lobe, 1);
                }
}

TEST(Lobes, FollowTheirPowers) {
    for (const double m : {1.0, 5.0, 50.0})
        for (const double a : {0.0, 10.0, 30.0}) {
            EXPECT_NEAR(blinn_lobe(up, at(a), up, float(m)), std::pow(std::cos(a / 2 * one_degree), m), 1e-5);
            EXPECT_NEAR(phong_lobe(up, at(a), up, float(m)), std::pow(std::cos(a * one_degree), m), 1e-5);
        }
}

TEST(Lobes, ZeroToThePowerZeroIsOne) {
    EXPECT_EQ(phong_lobe(up, at(80), at(80), 0), 1);
    EXPECT_EQ(phong_lobe(up, at(80), at(80), 1), 0);
    EXPECT_EQ(blinn_lobe(up, at(90), at(-90), 0), 1) << "light and eye opposite: no half vector";
    EXPECT_EQ(blinn_lobe(up, vec3(1, 0, 0), vec3(-1, 0, 0), 2), 0);
}

TEST(MirrorDirection, ReflectsAboutTheNormal) {
    for (const double a : {0.0, 20.0, 85.0}) {
        const vec3 r = mirror_direction(at(a), up);
        EXPECT_NEAR(r.x, at(-a).x, 1e-6);
        EXPECT_NEAR(r.z, at(-a).z, 1e-6);
    }
}

TEST(Refraction, FollowsSnell) {
    for (const double index : {0.5, 0.75, 1.1, 1.5, 2.4})
        for (const double a : {0.0, 5.0, 20.0, 25.0}) {
            const float eta = static_cast<float>(1 / index);
            const float discriminant = snell_discriminant(dot(up, at(a)), eta);
            const vec3 t = refracted_direction(at(a), up, eta, discriminant);
            const double s = std::sin(a * one_degree) / index;
            EXPECT_NEAR(t.x, -s, 1e-6);
            EXPECT_NEAR(t.z, -std::sqrt(1 - s * s), 1e-6);
        }
}

TEST(Refraction, GoesStraightOnBetweenEqualIndices) {
    const vec3 v = at(33.3);
    EXPECT_EQ(refracted_direction(v, up, 1, snell_discriminant(dot(v, up), 1)), -v);
}

TEST(Refraction, HasNoDirectionBeyondTheCriticalAngle) {
    const double critical = std::asin(1 / 1.5) / one_degree;
    EXPECT_LT(snell_discriminant(dot(up, at(critical + 0.01)), 1.5f), 0);
    EXPECT_GE(snell_discriminant(dot(up, at(critical - 0.01)), 1.5f), 0);
    EXPECT_GE(snell_discriminant(1.0000001f, 1e6f), 0) << "a cosine rounded above 1 is straight on";
}

/// Reflectance at `degrees` on the way from index 1 into n, and the angle behind.
double reflectance(double degrees, double n) {
    const double c1 = std::cos(degrees * one_degree);
    const double c2 = std::sqrt(1 - std::pow(std::sin(degrees * one_degree) / n, 2));
    return fresnel_reflectance(float(c1), float(c2), 1, float(n));
}

TEST(Fresnel, HasTheTextbooksValues) {
    const double degrees[] = {0, 30, 45, 60, 80, 85, 89};
    const double expected[] = {.04, .0415226, .0502399, .0891867, .3877044, .6127996, .9041850};
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(reflectance(degrees[i], 1.5), expected[i], 1e-6) << degrees[i];
}

TEST(Fresnel, IsTheSameFromBothSides) {
    for (double a = 0; a < 89; a += 3.7) {
        const double c1 = std::cos(a * one_degree);
        const double c2 = std::sqrt(1 - std::pow(std::sin(a * one_degree) / 1.5, 2));
        EXPECT_FLOAT_EQ(fresnel_reflectance(float(c1), float(c2), 1, 1.5f),
                        fresnel_reflectance(float(c2), float(c1), 1.5f, 1));
    }
}

TEST(Fresnel, IsHalfOfOnePolarisationAtBrewstersAngle) {
    // Light polarised in the plane of incidence is not reflected there: half of the other kind's share
    // remains.
    const double a = std::atan(1.5);
    EXPECT_NEAR(a / one_degree, 56.309932, 1e-6);
    const double c1 = std::cos(a), c2 = std::sin(a);
    const double s = (c1 - 1.5 * c2) / (c1 + 1.5 * c2);
    EXPECT_NEAR(reflectance(a / one_degree, 1.5), s * s / 2, 1e-6);
}

TEST(Transmittance, IsOneWithoutAbsorptionAndMultipliesAlongTheWay) {
    EXPECT_EQ(transmittance(vec3(0.0f), 1e30f), vec3(1.0f));
    const vec3 sigma(0.1f, 1, 3);
    const vec3 whole = transmittance(sigma, 3);
    const vec3 parts = transmittance(sigma, 1) * transmittance(sigma, 2);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(whole[c], std::exp(-3.0 * double(sigma[c])), 2e-6 * double(whole[c]));
        EXPECT_NEAR(parts[c], whole[c], 4e-6f * whole[c]);
    }
    EXPECT_EQ(transmittance(vec3(1e30f), 1e30f), vec3(0.0f));
}

TEST(LocalWeight, KeepsWhatTheEnergyRuleSays) {
    EXPECT_EQ(local_weight(0.5f, 0.25f, false), 0.75f);
    EXPECT_EQ(local_weight(0.5f, 0.25f, true), 0.25f);
    EXPECT_EQ(local_weight(0.9f, 0.1f, true), 0.0f);
    EXPECT_GE(local_weight(0.7f, 0.3f, true), 0.0f);
}

TEST(Limits, CutEachChannelAlone) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(limit_to_one(vec3(0.5f, 1, infinity)), vec3(0.5f, 1, 1));
    const vec3 cut = limit_to_range(vec3(0.5f, 1000, infinity));
    EXPECT_EQ(cut.x, 0.5f);
    EXPECT_EQ(cut.y, 1000);
    EXPECT_EQ(3 * cut.z + (1 - 3 * cut.z), 1);
}

} // namespace
} // namespace glint
