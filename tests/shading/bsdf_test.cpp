// BSDFs: samples, densities and values belong together, and no light is lost where none should be
// (shading/bsdf.shared.h). GLINT_ALL_TRIALS=1 in the environment runs the χ² tests at full size.

#include "math/random.shared.h"
#include "shading/bsdf.shared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace glint {
namespace {

constexpr double pi = std::numbers::pi;

/// All of it is there.
MaterialRecord whole_material() {
    MaterialRecord m{};
    m.opacity = 1;
    m.reflected_tint = m.transmitted_tint = vec3(1);
    return m;
}

/// A material at a point between two media.
struct Case {
    std::string name;
    MaterialRecord material = whole_material();
    BsdfSides sides{1, 1, false};
    WhittedModes modes{};
};

Case coefficients(const char* name, float k_d, float k, float m, int highlight) {
    Case c{name};
    c.material.diffuse = k_d;
    c.material.highlight = k;
    c.material.shininess = m;
    c.material.reflectivity = 0.1f;
    c.modes.highlight = highlight;
    return c;
}

Case rough(const char* name, int model, float roughness, const BsdfSides& sides) {
    Case c{name};
    c.material.model = model;
    c.material.roughness = roughness;
    c.material.index = 1.5f;
    c.material.specular = 1;
    c.material.specular_color = vec3(1);
    c.sides = sides;
    return c;
}

Case metal(float roughness) {
    Case c = rough("metal", model_conductor, roughness, {1, 1, false});
    c.material.flags = material_metal;
    c.material.metal_n = vec3(0.16f, 0.42f, 1.38f);
    c.material.metal_k = vec3(3.6f, 2.47f, 1.92f);
    return c;
}

/// Cloth under lacquer, partly metallic and partly transparent.
Case principled(float roughness, const BsdfSides& sides) {
    Case c = rough("principled", model_principled, roughness, sides);
    c.material.metallic = 0.3f;
    c.material.transmission = 0.4f;
    c.material.clearcoat = 0.5f;
    c.material.clearcoat_roughness = 0.3f;
    c.material.sheen_color = vec3(0.3f, 0.2f, 0.1f);
    c.material.sheen_roughness = 0.5f;
    return c;
}

const BsdfSides opaque{1, 1, false};
const BsdfSides into_glass{1, 1.5f, true};
const BsdfSides out_of_glass{1.5f, 1, true};

Bsdf bsdf_of(const Case& c, const vec3& v, const vec3& color = vec3(0.7f, 0.5f, 0.3f)) {
    SurfaceRecord s{};
    s.n = s.n_g = normalize(vec3(0.2f, -0.3f, 0.9f));
    s.v = turned_to(s.n, v);
    s.color = color;
    return bsdf_at(c.material, s, c.sides, c.modes);
}

/// Where the viewer is: about +z, the azimuth at random.
vec3 toward(double degrees, uint seed) {
    const double theta = degrees * pi / 180, phi = 2 * pi * static_cast<double>(unit_float(hash_mix(seed)));
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

bool all_trials() { return std::getenv("GLINT_ALL_TRIALS") != nullptr; }

vec3 sample_numbers(uint seed, uint i) {
    const vec2 a = sample_pair(seed, i, 0), b = sample_pair(seed, i, 1);
    return {a.x, a.y, b.x};
}

// ── χ²: as many samples in each cell of directions as the density says

struct Grid {
    int rows, columns; ///< by polar angle and azimuth
    int cells() const { return rows * columns; }
};

double density_in(const Bsdf& b, double theta, double phi) {
    const vec3 l(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    return static_cast<double>(bsdf_pdf(b, l)) * std::sin(theta);
}

/// The density's integral over a box of angles, where it changes quickly over smaller ones.
double integral(const Bsdf& b, double theta, double phi, double height, double width, int level) {
    const auto at = [&](double x, double y) {
        return density_in(b, theta + x * height, phi + y * width) * height * width;
    };
    const double whole = at(0.5, 0.5);
    const double parts = (at(0.25, 0.25) + at(0.25, 0.75) + at(0.75, 0.25) + at(0.75, 0.75)) / 4;
    const bool settled = level >= 3 && std::abs(whole - parts) < 1e-7 + 1e-3 * parts;
    if (settled || level > 9) return parts;
    double sum = 0;
    for (const double x : {0.0, 0.5})
        for (const double y : {0.0, 0.5})
            sum += integral(b, theta + x * height, phi + y * width, height / 2, width / 2, level + 1);
    return sum;
}

std::vector<double> expected_shares(const Bsdf& b, const Grid& grid) {
    std::vector<double> shares;
    const double height = pi / grid.rows, width = 2 * pi / grid.columns;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            shares.push_back(integral(b, row * height, column * width, height, width, all_trials() ? 1 : 0));
    return shares;
}

int cell_of(const vec3& d, const Grid& grid) {
    const double theta = std::acos(std::clamp(static_cast<double>(d.z), -1.0, 1.0));
    const double turn = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) / (2 * pi);
    const int row = std::min(static_cast<int>(theta / pi * grid.rows), grid.rows - 1);
    const int column =
        std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * grid.columns), grid.columns - 1);
    return row * grid.columns + column;
}

/// The probability of a χ² at least as large. (E. B. Wilson and M. M. Hilferty, 1931.)
double p_value(double chi_squared, double degrees) {
    const double spread = 2 / (9 * degrees);
    const double z = (std::cbrt(chi_squared / degrees) - (1 - spread)) / std::sqrt(spread);
    return std::erfc(z / std::sqrt(2.0)) / 2;
}

/// Cells that expect few samples are taken together.
double p_of(const std::vector<double>& shares, const std::vector<int>& counts, double samples) {
    double chi_squared = 0, rest = 0, rest_count = 0;
    int degrees = -1;
    const auto add = [&](double expected, double found) {
        chi_squared += (found - expected) * (found - expected) / expected;
        ++degrees;
    };
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double expected = shares[i] * samples;
        if (expected >= 8) {
            add(expected, counts[i]);
            continue;
        }
        rest += expected;
        rest_count += counts[i];
    }
    if (rest > 8) add(rest, rest_count);
    return degrees > 0 ? p_value(chi_squared, degrees) : 1;
}

void check_distribution(const Case& c, const vec3& v, uint seed, double min_p) {
    const Grid grid = all_trials() ? Grid{101, 202} : Grid{18, 36};
    const uint samples = all_trials() ? 1'000'000 : 20'000;
    const Bsdf b = bsdf_of(c, v);
    std::vector<int> counts(static_cast<std::size_t>(grid.cells()));
    double deltas = 0, lost = 0;
    for (uint i = 0; i < samples; ++i) {
        // Independent numbers: those of a sequence fit too well.
        const uint h = hash_with(seed, i);
        const BsdfSample drawn =
            bsdf_sample(b, unit_float(hash_mix(h)), unit_float(hash_mix(h + 1)), unit_float(hash_mix(h + 2)));
        lost += !drawn.delta && drawn.pdf == 0 ? 1 : 0;
        if (drawn.delta)
            ++deltas;
        else
            ++counts[static_cast<std::size_t>(cell_of(drawn.direction, grid))];
    }
    const std::vector<double> shares = expected_shares(b, grid);
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    const double spread = static_cast<double>(b.pick_diffuse + b.pick_gloss + b.pick_coat);
    EXPECT_NEAR(sum, spread, 1e-3) << c.name << " " << c.material.roughness << " " << v.z;
    EXPECT_NEAR(deltas / samples, 1 - spread, 0.02);
    EXPECT_LE(lost, samples * 1e-5) << c.name << ": more than rounding puts samples where the density is 0";
    EXPECT_GT(p_of(shares, counts, samples), min_p) << c.name << " " << c.material.roughness << " " << v.z;
}

std::vector<Case> sampled_cases() {
    std::vector<Case> all{
        coefficients("blinn", 0.5f, 0.5f, 40, highlight_blinn),
        coefficients("phong", 0.2f, 0.6f, 15, highlight_phong), rough("diffuse", model_diffuse, 0, opaque),
        rough("plastic", model_plastic, 0.3f, opaque), rough("sheet", model_dielectric, 0.4f, opaque)};
    all.push_back(metal(0.3f));
    all.back().name = "half of a metal";
    all.back().material.opacity = 0.5f;
    for (const float r : {0.2f, 0.5f, 1.0f}) {
        all.push_back(metal(r));
        all.push_back(rough("into glass", model_dielectric, r, into_glass));
        all.push_back(rough("out of glass", model_dielectric, r, out_of_glass));
        all.push_back(principled(r, r < 0.4f ? opaque : into_glass));
    }
    return all;
}

TEST(Bsdf, SamplesHaveTheirDensity) {
    const std::vector<Case> cases = sampled_cases();
    const int directions = all_trials() ? 20 : 3;
    // Šidák: together the tests fail by chance once in a thousand.
    const double min_p = 1 - std::pow(1 - 1e-3, 1.0 / (directions * static_cast<double>(cases.size())));
    uint seed = 1;
    for (const Case& c : cases)
        for (int i = 0; i < directions; ++i, ++seed)
            check_distribution(c, toward(88.0 * (i + 0.5) / directions, seed), seed, min_p);
}

TEST(Bsdf, SampleWeightsAreValueOverDensity) {
    for (const Case& c : sampled_cases())
        for (uint i = 0; i < 500; ++i) {
            const Bsdf b = bsdf_of(c, toward(17.0 * (i % 5), i));
            const vec3 u = sample_numbers(7, i);
            const BsdfSample drawn = bsdf_sample(b, u.x, u.y, u.z);
            if (drawn.delta) continue;
            ASSERT_EQ(drawn.pdf, bsdf_pdf(b, drawn.direction));
            if (!(drawn.pdf > 0)) continue;
            const vec3 expected = sum_of(bsdf_value(b, drawn.direction)) / drawn.pdf;
            ASSERT_LT(largest(dvec3(sum_of(drawn.weight) - expected)),
                      1e-5 * largest(dvec3(expected)) + 1e-7);
            ASSERT_EQ(drawn.transmits, dot(drawn.direction, b.n_g) < 0);
        }
}

// ── White furnace

/// The share of uniform light 1 that comes back or through, without the scale of radiance in media.
vec3 albedo(const Bsdf& b) {
    const uint samples = all_trials() ? 1u << 20u : 1u << 15u;
    dvec3 sum(0);
    for (uint i = 0; i < samples; ++i) {
        const vec3 u = sample_numbers(11, i);
        const BsdfSample drawn = bsdf_sample(b, u.z, u.x, u.y);
        sum += dvec3(sum_of(drawn.weight) / drawn.radiance_scale);
    }
    return vec3(sum / static_cast<double>(samples));
}

std::vector<double> view_angles() {
    if (!all_trials()) return {0, 50, 80};
    return {0, 10, 20, 30, 40, 45, 50, 60, 70, 75, 80, 85, 88};
}

void expect_white(const Case& c, double tolerance) {
    for (const double degrees : view_angles()) {
        const vec3 a = albedo(bsdf_of(c, toward(degrees, 3), vec3(1)));
        EXPECT_NEAR(a.x, 1, tolerance) << c.name << " " << c.material.roughness << " at " << degrees;
    }
}

TEST(Furnace, SmoothSurfacesLoseNothing) {
    for (const int model : {model_diffuse, model_conductor, model_dielectric, model_plastic})
        for (const BsdfSides& sides : {opaque, into_glass, out_of_glass})
            if (!sides.solid || model == model_dielectric)
                expect_white(rough("smooth", model, 0, sides), model == model_plastic ? 1e-3 : 1e-4);
}

TEST(Furnace, RoughMetalAndGlassLoseLessThanAHundredth) {
    const std::vector<float> indices =
        all_trials() ? std::vector{1.1f, 1.33f, 1.5f, 2.4f} : std::vector{1.5f};
    for (const float r : {0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
        for (const float eta : indices) {
            expect_white(rough("metal", model_conductor, r, opaque), 5e-3);
            expect_white(rough("sheet", model_dielectric, r, opaque), 5e-3);
            expect_white(rough("into glass", model_dielectric, r, {1, eta, true}), 5e-3);
            expect_white(rough("out of glass", model_dielectric, r, {eta, 1, true}), 5e-3);
        }
}

/// Toward grazing views glTF's mix by the half vector gives more than it gets.
TEST(Furnace, WhitePrincipledSurfacesSeenFromAboveKeepTheirLight) {
    for (const float r : {0.0f, 0.3f, 1.0f})
        for (const BsdfSides& sides : {opaque, into_glass}) {
            const vec3 a = albedo(bsdf_of(principled(r, sides), toward(0, 5), vec3(1)));
            EXPECT_LT(a.x, 1.005) << r;
            EXPECT_GT(a.x, 0.6) << r;
        }
}

// ── Reciprocity: f(v, l) = f(l, v), where no factor depends on the viewer's direction alone

TEST(Bsdf, IsReciprocal) {
    for (const Case& c :
         {coefficients("blinn", 0.5f, 0.5f, 40, highlight_blinn), rough("diffuse", model_diffuse, 0, opaque),
          rough("plastic", model_plastic, 0.3f, opaque)})
        for (uint i = 0; i < 100; ++i) {
            const vec3 v = toward(80.0 * static_cast<double>(unit_float(hash_mix(i))), i);
            const vec3 l = toward(80.0 * static_cast<double>(unit_float(hash_mix(~i))), ~i);
            const Bsdf from_v = bsdf_of(c, v), from_l = bsdf_of(c, l);
            const float one = sum_of(bsdf_value(from_v, from_l.v)).y / l.z;
            const float other = sum_of(bsdf_value(from_l, from_v.v)).y / v.z;
            EXPECT_NEAR(one, other, 1e-4f * one) << c.name;
        }
}

TEST(Bsdf, RefractionIsReciprocalUpToTheSquareOfTheIndex) {
    FacetLobe in = no_facets();
    in.fresnel = fresnel_of_index;
    in.alpha = 0.3f;
    in.eta = 1.5f;
    in.reflected = in.transmitted = vec3(1);
    FacetLobe out = in;
    out.eta = 1 / 1.5f;
    for (uint i = 0; i < 200; ++i) {
        const vec3 o = toward(80.0 * static_cast<double>(unit_float(hash_mix(i))), i);
        const vec3 u = sample_numbers(9, i);
        const vec3 l = facet_sample(in, o, 0.99f, u.x, u.y);
        if (!(l.z < -0.05f)) continue;
        const float one = facet_value(in, o, l).value.x / -l.z;
        const float other = facet_value(out, vec3(l.x, l.y, -l.z), vec3(o.x, o.y, -o.z)).value.x / o.z;
        EXPECT_NEAR(one * 2.25f, other, 2e-3f * other);
    }
}

// ── Fresnel

/// Truths of the house: reflectances of η = 1.5, and their means over the hemisphere.
TEST(Fresnel, HasItsClosedForms) {
    const double angles[] = {0, 30, 45, 60, 80, 85, 89};
    const double shares[] = {.04, .0415226, .0502399, .0891867, .3877044, .6127996, .9041850};
    for (int i = 0; i < 7; ++i)
        EXPECT_NEAR(fresnel_dielectric(static_cast<float>(std::cos(angles[i] * pi / 180)), 1.5f), shares[i],
                    1e-6);
    EXPECT_NEAR(mean_reflectance(1.5f), 0.0917780, 5e-6);
    EXPECT_NEAR(mean_reflectance(1 / 1.5f), 0.5963458, 5e-6);
    EXPECT_EQ(fresnel_dielectric(0.5f, 1 / 1.5f), 1);
    EXPECT_NEAR(pane_reflectance(0.04f), 0.0769231, 1e-7);
}

TEST(Fresnel, OfAMetalWithoutAbsorptionIsThatOfADielectric) {
    for (int i = 0; i <= 20; ++i) {
        const float cosine = static_cast<float>(i) / 20;
        EXPECT_NEAR(fresnel_conductor(cosine, 1.5f, 0), fresnel_dielectric(cosine, 1.5f), 1e-6);
    }
    EXPECT_NEAR(fresnel_conductor(1, 0.2f, 3), (0.64 + 9) / (1.44 + 9), 1e-6);
}

// ── Deltas

TEST(Bsdf, ReflectsAllWhereReflectionIsTotal) {
    for (const float r : {0.0f, 0.2f}) {
        const Bsdf b = bsdf_of(rough("glass", model_dielectric, r, out_of_glass), toward(60, 1), vec3(1));
        for (uint i = 0; i < 64; ++i) {
            const vec3 u = sample_numbers(3, i);
            const BsdfSample drawn = bsdf_sample(b, u.x, u.y, u.z);
            if (r == 0) {
                EXPECT_TRUE(drawn.delta && !drawn.transmits);
                EXPECT_NEAR(sum_of(drawn.weight).x, 1, 1e-6);
            }
        }
    }
}

TEST(Bsdf, SheetsLetLightThroughUnbent) {
    Case c{"pane"};
    c.material.transparency = 0.25f;
    c.material.diffuse = 1;
    const Bsdf pane = bsdf_of(c, toward(40, 1));
    const BsdfSample through = bsdf_sample(pane, 0.99f, 0.5f, 0.5f);
    EXPECT_TRUE(through.delta && through.transmits && through.straight);
    EXPECT_EQ(through.direction, -pane.v);
    EXPECT_NEAR(through.weight.transmission.x * pane.pick_refracted, 0.25, 1e-6);

    const Bsdf glass = bsdf_of(rough("glass", model_dielectric, 0, opaque), toward(0, 1), vec3(0.5f));
    EXPECT_NEAR(glass.mirror.x, 0.0769231, 1e-6);
    EXPECT_NEAR(glass.refracted.x, 0.5 * 0.9230769, 1e-6);
    EXPECT_FALSE(has_spread(glass));

    // A solid bends light, even where the indices are equal.
    const Bsdf solid = bsdf_of(rough("glass", model_dielectric, 0, {1.5f, 1.5f, true}), toward(30, 1));
    EXPECT_FALSE(bsdf_sample(solid, 0.5f, 0.5f, 0.5f).straight);
}

TEST(Bsdf, LetsLightThroughWhereTheSurfaceIsNotThere) {
    Case c = rough("diffuse", model_diffuse, 0, opaque);
    const Bsdf whole = bsdf_of(c, toward(20, 1));
    c.material.opacity = 0.25f;
    const Bsdf b = bsdf_of(c, toward(20, 1));
    EXPECT_EQ(b.through, 0.75f);
    EXPECT_EQ(sum_of(bsdf_value(b, b.n_g)), sum_of(bsdf_value(whole, b.n_g)) * 0.25f);
    const BsdfSample through = bsdf_sample(b, 0.5f, 0.5f, 0.5f);
    EXPECT_TRUE(through.delta && through.transmits && through.straight);
    EXPECT_EQ(through.direction, -b.v);
    EXPECT_EQ(sum_of(through.weight), vec3(1));
    EXPECT_NEAR(albedo(b).x, 0.25 * 0.7 + 0.75, 1e-3);
    EXPECT_NEAR(albedo(bsdf_of(c, toward(20, 1), vec3(0))).x, 0.75, 1e-3);
}

TEST(Bsdf, OfCoefficientsIsWhittedsLocalLight) {
    Case c = coefficients("blinn", 0.5f, 0.25f, 30, highlight_blinn);
    c.material.transparency = 0.5f;
    const Bsdf b = bsdf_of(c, toward(30, 1));
    SurfaceRecord s{};
    s.n = s.n_g = b.n_g;
    s.v = b.v;
    s.color = vec3(0.7f, 0.5f, 0.3f);
    s.lit_side = 1;
    LightRecord light{};
    light.position = b.n_g * 2.0f + vec3(0.5f, 0, 0);
    light.strength = vec3(3, 2, 1);
    const LightArrival arrival = light_arrival(light, s);
    const ShownLight shown = shown_light(c.modes, s, c.material, arrival, vec3(1));
    const vec3 whitted = (shown.diffuse + shown.highlight) * local_weight(c.modes, c.material);
    const vec3 radiance = light.strength * static_cast<float>(pi) / (arrival.distance * arrival.distance);
    const vec3 path = sum_of(bsdf_value(b, arrival.direction)) * radiance;
    EXPECT_LT(largest(dvec3(path - whitted)), 1e-6 * largest(dvec3(whitted)));
}

} // namespace
} // namespace glint
