// Vectors of rays through the shared equations: lane by lane the bits of one ray (shading/lanes-inl.h).

#include "math/random.shared.h"
#include "shading/whitted.shared.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes_test.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "shading/lanes-inl.h"

// What every target computes, and one ray: twelve numbers in, eighteen out of the terms, nineteen of the
// steps.
#ifndef GLINT_TESTS_LANES_EQUATIONS
#define GLINT_TESTS_LANES_EQUATIONS
namespace glint {
constexpr std::size_t inputs = 12;
constexpr std::size_t outputs = 19;
constexpr int no_light = -1;      ///< terms only
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
                            lobe_of(blinn_cosine(a, b, c), y),                                               \
                            lobe_of(phong_cosine(a, b, c), y),                                               \
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
                            snell_discriminant(x, y),                                                        \
                            fresnel_reflectance(x, y, z, x)}
/// A surface and a material of the numbers, and a light of each kind.
#define GLINT_TESTS_STEPS(kind_)                                                                             \
    SurfaceRecord s;                                                                                         \
    s.p = vec3(in[0], in[1], in[2]);                                                                         \
    s.p_error = vec3(0.0f);                                                                                  \
    s.n_g = vec3(in[3], in[4], in[5]);                                                                       \
    s.n = vec3(in[6], in[4], in[5]);                                                                         \
    s.v = vec3(in[6], in[7], in[8]);                                                                         \
    s.color = vec3(in[9], in[10], in[11]);                                                                   \
    s.lit_side = pick(in[7] > 0.0f, 1.0f, -1.0f);                                                            \
    MaterialRecord m;                                                                                        \
    m.ambient = in[0];                                                                                       \
    m.diffuse = in[1];                                                                                       \
    m.highlight = in[2];                                                                                     \
    m.shininess = in[3];                                                                                     \
    m.reflectivity = in[4];                                                                                  \
    m.transparency = in[5];                                                                                  \
    m.reflected_tint = vec3(in[5], in[7], in[9]);                                                            \
    const LightRecord light{{1, 2, 3}, kind_, {0.6f, 0, -0.8f}, 0.5f, {1.5f, 1, 0.5f}, 0.9f};                \
    const WhittedModes modes{kind_ == light_spot, kind_ != light_spot, kind_ == light_directional,           \
                             kind_ == light_point ? highlight_phong : highlight_blinn};                      \
    const LightArrival arrival = light_arrival(light, s);                                                    \
    const SpawnedRay to_light = shadow_ray(light, s, arrival);                                               \
    const ShownLight shown = shown_light(modes, s, m, arrival, vec3(shadow_transmittance(modes, in[8])));    \
    LocalTerms local = ambient_terms(vec3(0.5f), s, m);                                                      \
    local.diffuse = local.diffuse + shown.diffuse;                                                           \
    local.highlight = local.highlight + shown.highlight;                                                     \
    const LocalTerms limited = weighted_terms(limited_terms(modes, local), local_weight(modes, m));          \
    const SpawnedRay mirror = reflected_ray(s);                                                              \
    const real results[] = {arrival.direction.x,                                                             \
                            arrival.distance,                                                                \
                            arrival.cosine,                                                                  \
                            arrival.arriving.y,                                                              \
                            to_light.origin.x,                                                               \
                            to_light.direction.z,                                                            \
                            to_light.tmax,                                                                   \
                            shown.diffuse.x,                                                                 \
                            shown.highlight.y,                                                               \
                            limited.ambient.z,                                                               \
                            limited.diffuse.x,                                                               \
                            limited.highlight.y,                                                             \
                            limited.clamp.x,                                                                 \
                            local_sum(local).z,                                                              \
                            pick(is_worth_shadow_ray(modes, s, m, arrival), 1.0f, 0.0f),                     \
                            pick(has_bounces(m), 1.0f, 0.0f),                                                \
                            mirror.origin.y,                                                                 \
                            mirror.direction.x,                                                              \
                            mirror.tmax}
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Number k of ray i at rays[k][i].
void equations(const float (*rays)[width], float (*answers)[width], int kind) {
    using namespace lanes;
    using lanes::real;
    using lanes::vec3;
    for (std::size_t first = 0; first < width; first += lane_count) {
        real in[inputs];
        for (std::size_t k = 0; k < inputs; ++k) in[k] = load(rays[k] + first);
        const auto keep = [&](const real(&results)[outputs]) {
            for (std::size_t k = 0; k < outputs; ++k) store(results[k], answers[k] + first);
        };
        if (kind == no_light) {
            GLINT_TESTS_EQUATIONS;
            keep(results);
        } else {
            GLINT_TESTS_STEPS(kind);
            keep(results);
        }
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

void keep(const float (&results)[outputs], float (&answers)[outputs]) {
    std::copy(std::begin(results), std::end(results), answers);
}

void equations_of_one(const float (&in)[inputs], float (&answers)[outputs], int kind) {
    if (kind == no_light) {
        GLINT_TESTS_EQUATIONS;
        keep(results, answers);
    } else {
        GLINT_TESTS_STEPS(kind);
        keep(results, answers);
    }
}

/// Compares all lanes of one round with single rays.
void compare(std::int64_t target, uint round, int kind) {
    float rays[inputs][width];
    float answers[outputs][width];
    for (uint k = 0; k < inputs; ++k)
        for (uint i = 0; i < width; ++i) rays[k][i] = number((round * 16 + k) * static_cast<uint>(width) + i);
    HWY_DYNAMIC_DISPATCH(equations)(rays, answers, kind);
    for (std::size_t i = 0; i < width; ++i) {
        float in[inputs];
        float single[outputs];
        for (std::size_t k = 0; k < inputs; ++k) in[k] = rays[k][i];
        equations_of_one(in, single, kind);
        for (std::size_t k = 0; k < outputs; ++k)
            ASSERT_TRUE(same_bits(single[k], answers[k][i]))
                << hwy::TargetName(target) << ", round " << round << ", light " << kind << ", ray " << i
                << ", result " << k << ": " << answers[k][i] << ", one ray: " << single[k];
    }
}

TEST(Lanes, HaveTheBitsOfOneRayOnEveryTarget) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        for (const int kind : {no_light, light_point, light_directional, light_spot})
            for (uint round = 0; round < 5000; ++round) compare(target, round, kind);
    }
    hwy::SetSupportedTargetsForTest(0);
}

} // namespace
} // namespace glint

#endif
