#ifndef GLINT_SHADING_MICROFACET_SHARED_H
#define GLINT_SHADING_MICROFACET_SHARED_H
#include "math/shared.h"
#include "shading/sampling.shared.h"
#include "shading/whitted.shared.h"

// Rough surfaces as microfacets, and Fresnel's equations. Directions are in a frame in which +z is the
// normal: o to the viewer, i to the light, h the normal of a facet, all of unit length; o.z and h.z are above
// 0.
//
// The facets' normals have the distribution of Trowbridge and Reitz (GGX): D(h) = 1 / (π α² (s²/α² + c²)²), s
// and c the sine and cosine of h. Smith's masking with correlated heights is G = 1 / (1 + Λ(o) + Λ(i)), Λ(w)
// = (d(w)/|w.z| − 1) / 2 with d(w) = √(w.z² + α² (w.x² + w.y²)). In quotients such as G / (4 o.z i.z) the
// small cosines cancel; the functions below are these quotients. (B. Walter et al., "Microfacet Models for
// Refraction through Rough Surfaces", EGSR 2007; E. Heitz, "Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs", JCGT 3 (2), 2014.)

GLINT_SHARED_BEGIN

const float one_over_pi = 0.318309886f;

GLINT_FN real squared_sine(vec3 w) { return w.x * w.x + w.y * w.y; }

GLINT_FN real ggx_density(vec3 h, real alpha) {
    real squared = alpha * alpha;
    real length = squared_sine(h) / squared + h.z * h.z;
    return one_over_pi / (squared * length * length);
}

/// d(w).
GLINT_FN real ggx_stretch(vec3 w, real alpha) { return sqrt(w.z * w.z + alpha * alpha * squared_sine(w)); }

/// G / (4 o.z |i.z|).
GLINT_FN real ggx_visibility(vec3 o, vec3 i, real alpha) {
    return 0.5f / (ggx_stretch(o, alpha) * abs(i.z) + ggx_stretch(i, alpha) * o.z);
}

/// The density of facets seen from o, without their D(h) and o·h: G₁(o) / o.z. (E. Heitz, "Sampling the GGX
/// Distribution of Visible Normals", JCGT 7 (4), 2018.)
GLINT_FN real ggx_seen(vec3 o, real alpha) { return 2.0f / (o.z + ggx_stretch(o, alpha)); }

/// A facet seen from o, for a point of the unit disk. A cap of the unit sphere, moved by the stretched o, is
/// the half sphere of normals that are seen. (J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with
/// Spherical Caps", HPG 2023.)
GLINT_FN vec3 ggx_facet(vec3 o, real alpha, vec3 around) {
    vec3 stretched = normalize(vec3(o.x * alpha, o.y * alpha, o.z));
    real z = 1.0f - squared_sine(around) * (1.0f + stretched.z);
    real scale = sqrt(max(0.0f, (1.0f + stretched.z) * (1.0f + z))); // √(1 − z²) over the radius in the disk
    vec3 h = vec3(around.x * scale, around.y * scale, z) + stretched;
    return normalize(vec3(h.x * alpha, h.y * alpha, max(0.0f, h.z)));
}

// ── Fresnel's equations. `cosine` is that of the incident direction, 0 … 1.

/// Of a dielectric for unpolarised light; eta = index behind / index in front. 1 where reflection is total.
GLINT_FN real fresnel_dielectric(real cosine, real eta) {
    real discriminant = snell_discriminant(cosine, 1.0f / eta);
    real share = fresnel_reflectance(cosine, sqrt(max(0.0f, discriminant)), 1.0f, eta);
    return pick(discriminant > 0.0f, share, 1.0f);
}

/// Of a thin sheet with all reflections between its faces, each of which reflects the share given: 2R/(1 +
/// R).
GLINT_FN real pane_reflectance(real share) { return 2.0f * share / (1.0f + share); }

/// Of a metal with the complex index n + k i, relative to what is in front. (Born and Wolf, Principles of
/// Optics, section 14.2.)
GLINT_FN real fresnel_conductor(real cosine, real n, real k) {
    real c = cosine * cosine;
    real s = 1.0f - c;
    real q = n * n - k * k - s;
    real a_and_b = sqrt(q * q + 4.0f * n * n * k * k); // a² + b²
    real a = sqrt(max(0.0f, 0.5f * (a_and_b + q)));
    real across = (a_and_b + c - 2.0f * a * cosine) / (a_and_b + c + 2.0f * a * cosine);
    real both = c * a_and_b + s * s;
    real cross_term = 2.0f * a * cosine * s;
    real along = across * (both - cross_term) / (both + cross_term);
    return 0.5f * (across + along);
}

/// (1 − cos θ)⁵. (C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994.)
GLINT_FN real schlick_weight(real cosine) {
    real x = 1.0f - min(1.0f, max(0.0f, cosine));
    real squared = x * x;
    return squared * squared * x;
}

/// The reflectance at normal incidence: ((η − 1)/(η + 1))².
GLINT_FN real normal_reflectance(real eta) {
    real root = (eta - 1.0f) / (eta + 1.0f);
    return root * root;
}

/// The mean of fresnel_dielectric() over the hemisphere in front, weighted by the cosine, for η ≥ 1. (R. V.
/// Dunkle, "Thermal Radiation Characteristics of Surfaces", 1963, after J. W. T. Walsh, 1926.)
GLINT_FN real mean_reflectance_outside(real eta) {
    real e2 = eta * eta;
    real e4 = e2 * e2;
    real plus = e2 + 1.0f;
    real minus = e2 - 1.0f;
    real sum = eta + 1.0f;
    real ln_ratio = (log2_of(eta - 1.0f) - log2_of(sum)) * 0.693147181f;
    real ln_eta = log2_of(eta) * 0.693147181f;
    real mean = 0.5f + (eta - 1.0f) * (3.0f * eta + 1.0f) / (6.0f * sum * sum) +
                e2 * minus * minus / (plus * plus * plus) * ln_ratio -
                2.0f * e2 * eta * (e2 + 2.0f * eta - 1.0f) / (plus * (e4 - 1.0f)) +
                8.0f * e4 * (e4 + 1.0f) / (plus * (e4 - 1.0f) * (e4 - 1.0f)) * ln_eta;
    // Near 1 the terms are large and their sum is small.
    return eta > 1.002f ? mean : 0.0f;
}

/// For any η. Both sides of a surface transmit the same share of each other's light: 1 − F̄(1/η) = (1 −
/// F̄(η))/η².
GLINT_FN real mean_reflectance(real eta) {
    if (eta < 1.0f) return 1.0f - eta * eta * (1.0f - mean_reflectance_outside(1.0f / eta));
    return mean_reflectance_outside(eta);
}

// ── Directions about a facet

/// The half vector of a refraction, on the viewer's side; eta as in fresnel_dielectric().
GLINT_FN vec3 refraction_half_vector(vec3 o, vec3 i, real eta) {
    vec3 h = o + i * eta;
    return normalize(pick(h.z < 0.0f, -h, h));
}

/// o refracted at a facet; the discriminant of Snell's law must not be negative.
GLINT_FN vec3 refracted_at(vec3 h, vec3 o, real eta) {
    return refracted_direction(o, h, 1.0f / eta, max(0.0f, snell_discriminant(dot(o, h), 1.0f / eta)));
}

// ── Cloth

/// D V i.z of fibres: D = (2 + 1/α) sin^(1/α) / (2π) of the half vector, V = 1 / (4 (o.z + i.z − o.z i.z)).
/// (A. C. Estevez and C. Kulla, "Production Friendly Microfacet Sheen BRDF", 2017; V: D. Neubelt and M.
/// Pettineo, "Crafting a Next-Gen Material Pipeline for The Order: 1886", 2013; both in glTF's
/// KHR_materials_sheen.)
GLINT_FN real sheen_value(vec3 o, vec3 i, real alpha) {
    vec3 h = normalize(o + i);
    real density = (2.0f + 1.0f / alpha) * (0.5f * one_over_pi) * pow_of(sqrt(squared_sine(h)), 1.0f / alpha);
    return density * i.z / (4.0f * (o.z + i.z - o.z * i.z));
}

// ── What single scattering keeps

/// The share of light that one facet keeps for a surface without losses seen from o: what it sends into other
/// facets is lost. eta as in fresnel_dielectric(); 0: all is reflected.
GLINT_FN real microfacet_kept(vec3 o, vec3 h, real alpha, real eta) {
    real cosine = dot(o, h);
    vec3 reflected = h * (2.0f * cosine) - o;
    real share = eta > 0.0f ? fresnel_dielectric(cosine, eta) : 1.0f;
    // G / G₁(o) of a direction.
    real shown = 2.0f / ggx_seen(o, alpha);
    real kept = 0.0f;
    if (reflected.z > 0.0f) kept = share * (2.0f * ggx_visibility(o, reflected, alpha) * reflected.z * shown);
    if (share < 1.0f) {
        vec3 refracted = refracted_at(h, o, eta);
        if (refracted.z < 0.0f)
            kept = kept - (1.0f - share) * (2.0f * ggx_visibility(o, refracted, alpha) * refracted.z * shown);
    }
    return kept;
}

GLINT_SHARED_END
#endif
