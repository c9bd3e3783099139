#ifndef GLINT_SHADING_WHITTED_SHARED_H
#define GLINT_SHADING_WHITTED_SHARED_H
#include "math/elementary.shared.h"
#include "math/shared.h"

// Every term of the light model, each written once: the CPU, the GPU and the explanation of a pixel call
// these.
//
// Symbols: n_g geometric unit normal turned toward the viewer, n shading normal on the side of n_g, v and l
// unit vectors to viewer and light, r distance to the light, c colour, A ambient light, I intensity of a
// light (colour included), E light arriving. Colours are linear and unbounded. "Report" is the course report
// that the model follows; section numbers are its.

GLINT_SHARED_BEGIN

/// Ambient light: A ⊙ c · k_a. (Report 2.2, which prints a sum; its figures are products.)
GLINT_FN vec3 ambient_term(vec3 ambient_light, vec3 color, real k_a) { return ambient_light * color * k_a; }

/// max(0, n·l), and 0 unless the light also stands above the geometric surface: n_g·l > 0.
GLINT_FN real light_cosine(vec3 n, vec3 n_g, vec3 l) {
    return pick(dot(n_g, l) <= 0.0f, 0.0f, max(0.0f, dot(n, l)));
}

/// Light arriving from a point light: E = I · cosine / r². (Report 2.2.) Nothing arrives from r = 0.
GLINT_FN vec3 point_light_arriving(vec3 intensity, real cosine, real r_squared) {
    return pick(r_squared > 0.0f, intensity * (cosine / r_squared), vec3(0.0f));
}

/// Light arriving from a directional light: E = irradiance · cosine.
GLINT_FN vec3 directional_light_arriving(vec3 irradiance, real cosine) { return irradiance * cosine; }

/// The way of a direction from a spot light's outer cone (0) to its inner cone (1), by cosines; not clamped.
GLINT_FN real spot_ramp(real cos_angle, real cos_outer, real cos_inner) {
    return (cos_angle - cos_outer) / (cos_inner - cos_outer);
}

/// The share of a spot light that leaves in a direction: smoothstep between the cosines of its outer and
/// inner cone.
GLINT_FN real spot_falloff(real cos_angle, real cos_outer, real cos_inner) {
    real x = spot_ramp(cos_angle, cos_outer, cos_inner);
    real between = pick(cos_angle <= cos_outer, 0.0f, x * x * (3.0f - 2.0f * x));
    return pick(cos_angle >= cos_inner, 1.0f, between);
}

/// What a light sends to a point where nothing stands between.
struct LightArrival {
    vec3 direction; ///< l; 0 at the light itself
    real distance;  ///< r
    real cosine;    ///< light_cosine()
    vec3 arriving;  ///< E
};

/// From a point light, and from a spot light before its falloff.
GLINT_FN LightArrival arrival_from_point(vec3 position, vec3 intensity, vec3 p, vec3 n, vec3 n_g) {
    vec3 to_light = position - p;
    real r_squared = dot(to_light, to_light);
    LightArrival arrival;
    arrival.distance = sqrt(r_squared);
    arrival.direction = pick(arrival.distance > 0.0f, to_light / arrival.distance, vec3(0.0f));
    arrival.cosine = light_cosine(n, n_g, arrival.direction);
    arrival.arriving = point_light_arriving(intensity, arrival.cosine, r_squared);
    return arrival;
}

/// Diffuse reflection: E ⊙ c · k_d. (Report 2.2.)
GLINT_FN vec3 diffuse_term(vec3 arriving, vec3 color, real k_d) { return arriving * color * k_d; }

/// A lobe's cosine to the power m, from 0 to 1: a cosine rounded to just above 1 would run away with a large
/// m. 0^0 = 1.
GLINT_FN real lobe_of(real cosine, real m) { return pow_of(min(1.0f, max(0.0f, cosine)), m); }

/// The mirror direction R = 2 (n·v) n − v. (Report 2.3.)
GLINT_FN vec3 mirror_direction(vec3 v, vec3 n) { return n * (2.0f * dot(n, v)) - v; }

/// n·h with Blinn's half vector h = (l + v)/|l + v|; 0 where light and viewer are opposite. (Report 2.5.)
GLINT_FN real blinn_cosine(vec3 n, vec3 l, vec3 v) {
    vec3 sum = l + v;
    real squared = dot(sum, sum);
    return pick(squared > 0.0f, dot(n, sum) / sqrt(squared), 0.0f);
}

/// v·R, R the mirror direction of l. (Report 2.5 discusses both.)
GLINT_FN real phong_cosine(vec3 n, vec3 l, vec3 v) { return dot(v, mirror_direction(l, n)); }

/// Blinn's lobe max(0, n·h)^m. (Report 2.5.)
GLINT_FN real blinn_lobe(vec3 n, vec3 l, vec3 v, real m) { return lobe_of(blinn_cosine(n, l, v), m); }

/// Phong's lobe max(0, v·R)^m, for comparison. (Report 2.5.)
GLINT_FN real phong_lobe(vec3 n, vec3 l, vec3 v, real m) { return lobe_of(phong_cosine(n, l, v), m); }

/// Highlight: E · k · lobe. It has the light's colour, not the material's, and carries n·l and 1/r² as the
/// report's figures do, though neither its formula nor textbook Blinn-Phong has them. (Report 2.5.)
GLINT_FN vec3 highlight_term(vec3 arriving, real k, real lobe) { return arriving * (k * lobe); }

/// Each channel limited to 2^22: what is more than enough where a sum will be limited to 1, and little enough
/// that taking the rest away again leaves 1 exactly.
GLINT_FN vec3 limit_to_range(vec3 color) { return min(color, vec3(4194304.0f)); }

/// Each channel limited to 1.
GLINT_FN vec3 limit_to_one(vec3 color) { return min(color, vec3(1.0f)); }

/// The direction of the mirror ray; that of the geometric normal where it would go below the surface else.
GLINT_FN vec3 mirror_ray_direction(vec3 v, vec3 n, vec3 n_g) {
    vec3 direction = normalize(mirror_direction(v, n));
    return pick(dot(direction, n_g) > 0.0f, direction, normalize(mirror_direction(v, n_g)));
}

/// What Snell's law says under the root: 1 − (η₁/η₂)² (1 − (n·v)²). Below 0 the reflection is total.
GLINT_FN real snell_discriminant(real n_dot_v, real eta) {
    return 1.0f - eta * eta * max(0.0f, 1.0f - n_dot_v * n_dot_v);
}

/// The refracted direction T = (η n·v − √(1 − η² (1 − (n·v)²))) n − η v with η = η₁/η₂. (Report 2.4.)
/// `discriminant` is snell_discriminant(n·v, η) and must not be negative. Equal indices go straight on.
GLINT_FN vec3 refracted_direction(vec3 v, vec3 n, real eta, real discriminant) {
    vec3 bent = normalize(n * (eta * dot(n, v) - sqrt(discriminant)) - v * eta);
    return pick(eta == 1.0f, -v, bent);
}

/// Fresnel's amplitude for light that swings across the plane of incidence, from the cosines on both sides
/// and the indices. (Born and Wolf, Principles of Optics, section 1.5.2.)
GLINT_FN real fresnel_s(real cos_1, real cos_2, real index_1, real index_2) {
    return (index_1 * cos_1 - index_2 * cos_2) / (index_1 * cos_1 + index_2 * cos_2);
}

/// And for light that swings within it.
GLINT_FN real fresnel_p(real cos_1, real cos_2, real index_1, real index_2) {
    return (index_2 * cos_1 - index_1 * cos_2) / (index_2 * cos_1 + index_1 * cos_2);
}

/// Fresnel's reflectance of a dielectric for unpolarised light.
GLINT_FN real fresnel_reflectance(real cos_1, real cos_2, real index_1, real index_2) {
    real s = fresnel_s(cos_1, cos_2, index_1, index_2);
    real p = fresnel_p(cos_1, cos_2, index_1, index_2);
    return 0.5f * (s * s + p * p);
}

/// What is left of light after a way through an absorbing medium: e^(−σ d). (Beer and Lambert.)
GLINT_FN vec3 transmittance(vec3 sigma, real d) {
    return vec3(exp_of(-(sigma.x * d)), exp_of(-(sigma.y * d)), exp_of(-(sigma.z * d)));
}

/// The weight of the local terms where the bounce is followed: 1 − τ, or 1 − ρ − τ where energy is balanced.
GLINT_FN real local_weight(real reflectivity, real transparency, bool balanced) {
    real kept = 1.0f - transparency;
    return balanced ? max(0.0f, kept - reflectivity) : kept;
}

GLINT_SHARED_END
#endif
