// The table of what rough surfaces keep (shading/microfacet_energy.h). GLINT_UPDATE_DOCS=1 writes it anew.

#include "math/trig.h"
#include "shading/microfacet.shared.h"
#include "shading/microfacet_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

namespace glint::shading {
namespace {

using namespace energy_table;

vec3 direction_of(float cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

/// The mean over the facets, of which each half of the disk shows the same.
double facets_keep(float cosine, float alpha, float eta) {
    constexpr int rings = 256, spokes = 32;
    const vec3 o = direction_of(cosine);
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j) {
            const double radius = std::sqrt((i + 0.5) / rings), degrees = 180 * (j + 0.5) / spokes;
            const vec3 around(dvec3(radius * cos_degrees(degrees), radius * sin_degrees(degrees), 0));
            sum += static_cast<double>(microfacet_kept(o, ggx_facet(o, alpha, around), alpha, eta));
        }
    return sum / (rings * spokes);
}

double sheen_reflects(float cosine, float alpha) {
    constexpr int side = 64;
    const vec3 o = direction_of(cosine);
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const vec3 l =
                cosine_sample((static_cast<float>(i) + 0.5f) / side, (static_cast<float>(j) + 0.5f) / side);
            sum += static_cast<double>(sheen_value(o, l, alpha) / (l.z * one_over_pi));
        }
    return sum / (side * side);
}

long node_value(std::size_t plane, std::size_t roughness, std::size_t cosine) {
    const float alpha = alpha_at(roughness), c = cosine_at(cosine, alpha);
    const double value = plane == sheen ? sheen_reflects(c, alpha) : facets_keep(c, alpha, eta_at(plane));
    return std::lround(value * static_cast<double>(scale));
}

void write_table() {
    std::ofstream file(std::string(GLINT_SOURCE_DIR) + "/src/shading/microfacet_energy.inc");
    for (std::size_t p = 0; p < planes; ++p) {
        file << "{{\n";
        for (std::size_t r = 0; r < roughnesses; ++r) {
            file << "{";
            for (std::size_t c = 0; c < cosines; ++c) file << (c > 0 ? "," : "") << node_value(p, r, c);
            file << "},\n";
        }
        file << "}},\n";
    }
}

TEST(EnergyTable, IsWhatIntegrationGives) {
    if (std::getenv("GLINT_UPDATE_DOCS")) return write_table();
    for (std::size_t i = 0; i < planes * roughnesses * cosines; i += 197) {
        const std::size_t p = i / (roughnesses * cosines), r = i / cosines % roughnesses, c = i % cosines;
        EXPECT_NEAR(values()[p][r][c], static_cast<double>(node_value(p, r, c)), 1)
            << p << " " << r << " " << c;
    }
}

TEST(EnergyTable, IsSmoothBetweenItsNodes) {
    for (const float eta : {0.0f, 1.2f, 1.5f, 1 / 1.5f, 2.4f, 1 / 2.4f})
        for (const float roughness : {0.1f, 0.23f, 0.51f, 0.87f})
            for (const float cosine : {0.07f, 0.3f, 0.61f, 0.97f}) {
                const float alpha = roughness * roughness;
                const double exact = facets_keep(cosine, alpha, eta);
                EXPECT_NEAR(static_cast<double>(microfacet_energy(cosine, alpha, eta)) / exact, 1, 4e-3)
                    << eta << " " << roughness << " " << cosine;
            }
}

} // namespace
} // namespace glint::shading
