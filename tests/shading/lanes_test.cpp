// Vectors of rays through the shared equations: lane by lane the bits of one ray (shading/lanes-inl.h).

#include "math/random.shared.h"
#include "shading/whitted.shared.h"

#include <cstring>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes_test.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "shading/lanes-inl.h"

// What every target computes, and one ray: twelve numbers in, eighteen out.
#ifndef GLINT_TESTS_LANES_EQUATIONS
#define GLINT_TESTS_LANES_EQUATIONS
namespace glint {
constexpr std::size_t inputs = 12;
constexpr std::size_t outputs = 18;
constexpr std::size_t width = 16; ///< rays at a time: as many as the widest vector holds
} // namespace glint
#define GLINT_TESTS_EQUATIONS                                                                                \
    const vec3 a(in[0], in[1], in[2]);                                                                       \
    const vec3 b(in[3], in[4], in[5]);                                                                       \
    const vec3 c(in[6], in[7], in[8]);                                                                       \
    const real x = in[9];                                                                                    \
    const real y = in[10];                                                                                   \
    const real z = in[11];                                                                                   \
    const vec3 origin = offset_ray_origin(a, b, c, b);                                                       \
    const LightArrival arrival = arrival_from_point(a, b, c, b, a);                                          \
    const vec3 mirror = mirror_ray_direction(a, b, c);                                                       \
    const vec3 limited = limit_to_one(limit_to_range(a));                                                    \
    const real results[] = {next_float(x, y),                                                                \
                            pow_of(x, y),                                                                    \
                            exp2_of(x),                                                                      \
                            spot_falloff(x, y, z),                                                           \
                            blinn_lobe(a, b, c, y),                                                          \
                            phong_lobe(a, b, c, y),                                                          \
                            light_cosine(a, b, c),                                                           \
                            origin.x,                                                                        \
                            origin.y,                                                                        \
                            arrival.direction.x,                                                             \
                            arrival.distance,                                                                \
                            arrival.cosine,                                                                  \
                            arrival.arriving.y,                                                              \
                            mirror.x,                                                                        \
                            mirror.z,                                                                        \
                            limited.x,                                                                       \
                            limited.z,                                                                       \
                            snell_discriminant(x, y)}
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Number k of ray i at rays[k][i].
void equations(const float (*rays)[width], float (*answers)[width]) {
    using namespace lanes;
    using lanes::real;
    using lanes::vec3;
    for (std::size_t first = 0; first < width; first += lane_count) {
        real in[inputs];
        for (std::size_t k = 0; k < inputs; ++k) in[k] = load(rays[k] + first);
        GLINT_TESTS_EQUATIONS;
        for (std::size_t k = 0; k < outputs; ++k) store(results[k], answers[k] + first);
    }
}

} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

namespace glint {
namespace {

HWY_EXPORT(equations);

/// Mostly numbers of any size, sometimes a special one.
float number(uint seed) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float special[] = {0.0f,      -0.0f,     1.0f,   -1.0f,   infinity, -infinity,
                                 0x1p-149f, 0x1p-127f, 128.0f, -150.0f, 0.5f,     2.0f};
    const uint h = hash_mix(seed);
    if (h % 8 == 0) return special[h / 8 % std::size(special)];
    if (h % 8 == 1) return intBitsToFloat(static_cast<int>(hash_mix(h)));
    return (2.0f * unit_float(hash_mix(h)) - 1.0f) * (h % 8 == 2 ? 1e6f : 2.0f);
}

bool same_bits(float a, float b) { return floatBitsToInt(a) == floatBitsToInt(b) || (a != a && b != b); }

TEST(Lanes, HaveTheBitsOfOneRayOnEveryTarget) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        for (uint round = 0; round < 10000; ++round) {
            float rays[inputs][width];
            float answers[outputs][width];
            for (uint k = 0; k < inputs; ++k)
                for (uint i = 0; i < width; ++i)
                    rays[k][i] = number((round * 16 + k) * static_cast<uint>(width) + i);
            HWY_DYNAMIC_DISPATCH(equations)(rays, answers);
            for (std::size_t i = 0; i < width; ++i) {
                float in[inputs];
                for (std::size_t k = 0; k < inputs; ++k) in[k] = rays[k][i];
                GLINT_TESTS_EQUATIONS;
                for (std::size_t k = 0; k < outputs; ++k)
                    ASSERT_TRUE(same_bits(results[k], answers[k][i]))
                        << hwy::TargetName(target) << ", round " << round << ", ray " << i << ", result " << k
                        << ": " << answers[k][i] << ", alone " << results[k];
            }
        }
    }
    hwy::SetSupportedTargetsForTest(0);
}

} // namespace
} // namespace glint

#endif
