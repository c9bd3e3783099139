#include "scene/materials.h"

#include "math/vec.h"
#include "shading/bsdf.shared.h"

#include <algorithm>
#include <array>

namespace glint::scene {
namespace {

/// n + k i for red, green and blue.
struct ComplexIndex {
    vec3 n;
    vec3 k;
};

// At 650, 550 and 450 nm, linear between the measurements around them. Aluminium: K. M. McPeak et al.,
// "Plasmonic Films Can Easily Be Better", ACS Photonics 2, 2015. Brass (70 % copper): M. R. Querry, Optical
// Constants, CRDC-CR-85034, 1985. Copper, gold, silver: P. B. Johnson and R. W. Christy, "Optical Constants
// of the Noble Metals", Phys. Rev. B 6, 1972. The others: the same, "… of Transition Metals", Phys. Rev. B 9,
// 1974.
constexpr std::array<ComplexIndex, enum_names<Metal>.size()> metals{{
    {{1.246f, 0.789f, 0.489f}, {6.852f, 5.852f, 4.778f}}, // aluminium
    {{0.444f, 0.527f, 1.094f}, {3.695f, 2.765f, 1.829f}}, // brass
    {{3.107f, 3.181f, 2.323f}, {3.331f, 3.329f, 3.135f}}, // chromium
    {{2.237f, 2.052f, 1.736f}, {4.236f, 3.824f, 3.274f}}, // cobalt
    {{0.238f, 1.007f, 1.240f}, {3.626f, 2.582f, 2.393f}}, // copper
    {{0.156f, 0.424f, 1.383f}, {3.602f, 2.472f, 1.915f}}, // gold
    {{2.911f, 2.950f, 2.584f}, {3.089f, 2.932f, 2.767f}}, // iron
    {{1.990f, 1.921f, 1.729f}, {4.209f, 3.616f, 2.944f}}, // nickel
    {{0.052f, 0.060f, 0.040f}, {4.409f, 3.597f, 2.648f}}, // silver
    {{2.741f, 2.542f, 2.267f}, {3.814f, 3.435f, 3.038f}}, // titanium
}};

/// What Whitted's terms multiply: k_d c, k, ρ, τ. Coefficients that have a colour are 1 and a tint.
struct WhittedReading {
    float diffuse = 0;
    float highlight = 0;
    float shininess = 0;
    float reflectivity = 0;
    float transparency = 0;
    vec3 reflected_tint{1};
    vec3 transmitted_tint{1};
    bool fresnel = false;
};

/// The exponent for which Blinn's lobe is as wide as that of microfacets.
float shininess_of(double roughness) {
    const double alpha = std::max(roughness * roughness, 1e-4);
    return static_cast<float>(std::max(0.0, 2 / (alpha * alpha) - 2));
}

/// The reflectance at normal incidence as a mirror, or if it is rough as a highlight.
void read_reflectance(WhittedReading& w, const Material& m, const vec3& reflectance) {
    w.reflected_tint = reflectance;
    w.shininess = shininess_of(m.roughness);
    (m.roughness < double{min_roughness} ? w.reflectivity : w.highlight) = 1;
}

vec3 reflectance_of(const MaterialRecord& f) {
    if ((f.flags & material_metal) == 0) return f.color;
    return {fresnel_conductor(1, f.metal_n.x, f.metal_k.x), fresnel_conductor(1, f.metal_n.y, f.metal_k.y),
            fresnel_conductor(1, f.metal_n.z, f.metal_k.z)};
}

WhittedReading reading_of_coefficients(const Material& m) {
    WhittedReading w;
    w.diffuse = static_cast<float>(m.diffuse);
    w.highlight = static_cast<float>(m.highlight);
    w.shininess = static_cast<float>(m.shininess);
    w.reflectivity = static_cast<float>(m.reflectivity);
    w.transparency = static_cast<float>(m.transparency);
    w.fresnel = m.fresnel;
    return w;
}

/// Of plastic and what lies below a dielectric's surface.
WhittedReading reading_of_body(const Material& m) {
    WhittedReading w;
    w.diffuse = 1;
    w.highlight = normal_reflectance(static_cast<float>(m.index));
    w.shininess = shininess_of(m.roughness);
    return w;
}

/// Its metal, its diffuse and its transmitting part. Coat and sheen are left out.
WhittedReading reading_of_principled(const Material& m, const MaterialRecord& f) {
    WhittedReading w;
    SurfaceRecord surface{};
    surface.color = f.color;
    read_reflectance(w, m, principled_facets(f, surface, {1, 1, false}).f0);
    if (w.reflectivity > 0) w.reflected_tint = f.color * f.metallic;
    const float dielectric = 1 - f.metallic;
    w.transparency = dielectric * f.transmission;
    w.transmitted_tint = f.color;
    w.fresnel = w.transparency > 0;
    // Local light is weighted by 1 − τ.
    if (w.transparency < 1) w.diffuse = dielectric * (1 - f.transmission) / (1 - w.transparency);
    return w;
}

WhittedReading whitted_reading(const Material& m, const MaterialRecord& f) {
    WhittedReading w;
    switch (m.model) {
    case MaterialModel::whitted:
        return reading_of_coefficients(m);
    case MaterialModel::diffuse:
        w.diffuse = 1;
        return w;
    case MaterialModel::conductor:
        read_reflectance(w, m, reflectance_of(f));
        return w;
    case MaterialModel::dielectric:
        w.transparency = 1;
        w.transmitted_tint = f.color;
        w.fresnel = true;
        return w;
    case MaterialModel::plastic:
        return reading_of_body(m);
    case MaterialModel::principled:
        return reading_of_principled(m, f);
    }
    return w;
}

} // namespace

MaterialRecord material_record(const Material& m) {
    MaterialRecord f{};
    f.color = vec3(m.color);
    f.ambient = static_cast<float>(m.ambient);
    f.emission = vec3(m.emission);
    f.absorption = vec3(m.absorption);
    f.index = static_cast<float>(m.index);
    f.model = static_cast<int>(m.model);
    f.roughness = static_cast<float>(m.roughness);
    f.opacity = static_cast<float>(m.opacity);
    f.metallic = static_cast<float>(m.metallic);
    f.transmission = static_cast<float>(m.transmission);
    f.specular_color = vec3(m.specular_color);
    f.specular = static_cast<float>(m.specular);
    f.sheen_color = vec3(m.sheen_color * m.sheen);
    f.sheen_roughness = static_cast<float>(m.sheen_roughness);
    f.clearcoat = static_cast<float>(m.clearcoat);
    f.clearcoat_roughness = static_cast<float>(m.clearcoat_roughness);
    if (m.emission_sides == EmissionSides::front) f.flags |= material_front;
    if (m.metal) {
        const ComplexIndex& index = metals[static_cast<std::size_t>(*m.metal)];
        f.metal_n = index.n;
        f.metal_k = index.k;
        f.flags |= material_metal;
    }

    const WhittedReading w = whitted_reading(m, f);
    f.diffuse = w.diffuse;
    f.highlight = w.highlight;
    f.shininess = w.shininess;
    f.reflectivity = w.reflectivity;
    f.transparency = w.transparency;
    f.reflected_tint = w.reflected_tint;
    f.transmitted_tint = w.transmitted_tint;
    if (w.fresnel) f.flags |= material_fresnel;
    return f;
}

static_assert(static_cast<int>(MaterialModel::diffuse) == model_diffuse &&
              static_cast<int>(MaterialModel::conductor) == model_conductor &&
              static_cast<int>(MaterialModel::dielectric) == model_dielectric &&
              static_cast<int>(MaterialModel::plastic) == model_plastic &&
              static_cast<int>(MaterialModel::principled) == model_principled);

} // namespace glint::scene

namespace glint {

bool is_transparent(const Material& m) {
    switch (m.model) {
    case MaterialModel::whitted:
        return m.transparency > 0;
    case MaterialModel::dielectric:
        return true;
    case MaterialModel::principled:
        return (1 - m.metallic) * m.transmission > 0;
    default:
        return false;
    }
}

} // namespace glint
