#ifndef GLINT_SHADING_BSDF_SHARED_H
#define GLINT_SHADING_BSDF_SHARED_H
#include "math/shared.h"
#include "shading/bsdf_lobes.shared.h"
#include "shading/microfacet.shared.h"
#include "shading/records.shared.h"
#include "shading/whitted.shared.h"
#ifndef GLINT_GLSL
#include "shading/microfacet_energy.h"
#endif

// What a path tracer asks of a material at one point of a surface, for single rays:
//
//     Bsdf b = bsdf_at(material, surface, sides, modes);  // once at each vertex
//     lobes_at(b, l)                                      // value and density of a light's direction
//     bsdf_sample(b, u_lobe, u, v)                        // the next direction of the path
//
// A Bsdf is a sum of lobes. Deltas (mirrors, smooth refraction) are met by bsdf_sample() alone: lobes_at(),
// of which bsdf_value() and bsdf_pdf() give one half each, speaks of the rest. Densities are over solid
// angle, and those of bsdf_sample() include the choice of the lobe, so that both functions give the same
// density. Values hold |cos θ|. Directions are unit vectors that point away from the surface: v to the viewer
// (SurfaceRecord::v, which holds for the whole Bsdf), l to the light.
//
// Light counts if it is on the same side of the geometric surface as of the shading normal's. A sampled
// direction that is not has the value 0, and ends its path; its density stays.
//
// The formulas with their sources are in docs/light-model.md. microfacet_energy() is a table: in C++
// shading/microfacet_energy.h, in a shader a buffer.

GLINT_SHARED_BEGIN

#ifndef GLINT_GLSL
using shading::microfacet_energy;
using shading::sheen_energy;
#endif

/// The media on both sides of a surface.
struct BsdfSides {
    real index_before; ///< of refraction, on the viewer's side
    real index_after;  ///< behind the surface; of solids only
    truth solid;       ///< it bounds a transparent solid and bends light; else it is a sheet, or opaque
};

/// Rougher surfaces are made of microfacets.
const float min_roughness = 0.01f;

/// Nearer to 1, a ratio of indices bends light by less than single precision can tell.
const float min_bending = 0.001f;

GLINT_FN FacetLobe no_facets() {
    FacetLobe lobe;
    lobe.alpha = 1.0f;
    lobe.fresnel = fresnel_of_color;
    lobe.f0 = vec3(0.0f);
    lobe.f90 = vec3(0.0f);
    lobe.kept_0 = 0.0f;
    lobe.kept_90 = 0.0f;
    lobe.eta = 1.0f;
    lobe.thin = false;
    lobe.reflected = vec3(0.0f);
    lobe.transmitted = vec3(0.0f);
    return lobe;
}

/// Without lobes.
GLINT_FN Bsdf black_bsdf(GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides) {
    Bsdf b;
    b.v = s.v;
    b.n_g = s.n_g;
    b.basis = basis_about(s.n);
    b.diffuse = vec3(0.0f);
    b.body = body_plain;
    b.sheen = vec3(0.0f);
    b.sheen_alpha = 1.0f;
    b.gloss = gloss_none;
    b.gloss_strength = vec3(0.0f);
    b.shininess = 0.0f;
    b.facets = no_facets();
    b.coat = no_facets();
    b.mirror = vec3(0.0f);
    b.mirror_direction = mirror_ray_direction(s.v, s.n, s.n_g);
    b.refracted = vec3(0.0f);
    b.refracted_direction = -s.v;
    b.straight = !sides.solid;
    b.through = 0.0f;
    b.radiance_scale = 1.0f;
    b.pick_diffuse = 0.0f;
    b.pick_gloss = 0.0f;
    b.pick_coat = 0.0f;
    b.pick_mirror = 0.0f;
    b.pick_refracted = 0.0f;
    b.pick_through = 0.0f;
    return b;
}

/// With probabilities in proportion to estimates of what the lobes reflect, which for deltas are their
/// weights.
GLINT_FN Bsdf with_choice(GLINT_IN(Bsdf) lobes, real diffuse, real gloss, real coat) {
    Bsdf b = lobes;
    b.pick_diffuse = diffuse;
    b.pick_gloss = gloss;
    b.pick_coat = coat;
    b.pick_mirror = max_channel(b.mirror);
    b.pick_refracted = max_channel(b.refracted) / b.radiance_scale;
    real sum = b.pick_diffuse + b.pick_gloss + b.pick_coat + b.pick_mirror + b.pick_refracted;
    real scale = sum > 0.0f ? 1.0f / sum : 0.0f;
    b.pick_diffuse = b.pick_diffuse * scale;
    b.pick_gloss = b.pick_gloss * scale;
    b.pick_coat = b.pick_coat * scale;
    b.pick_mirror = b.pick_mirror * scale;
    b.pick_refracted = b.pick_refracted * scale;
    return b;
}

/// All lobes weaker: those of a layer under another, or of a surface that is not there everywhere.
GLINT_FN Bsdf dimmed(GLINT_IN(Bsdf) lobes, real left) {
    Bsdf b = lobes;
    b.diffuse = b.diffuse * left;
    b.sheen = b.sheen * left;
    b.gloss_strength = b.gloss_strength * left;
    b.facets.reflected = b.facets.reflected * left;
    b.facets.transmitted = b.facets.transmitted * left;
    b.coat.reflected = b.coat.reflected * left;
    b.mirror = b.mirror * left;
    b.refracted = b.refracted * left;
    return b;
}

/// A share `opacity` of the surface is there; the rest lets light through.
GLINT_FN Bsdf perforated(GLINT_IN(Bsdf) lobes, real opacity) {
    Bsdf b = dimmed(lobes, opacity);
    b.through = 1.0f - opacity;
    b.pick_diffuse = b.pick_diffuse * opacity;
    b.pick_gloss = b.pick_gloss * opacity;
    b.pick_coat = b.pick_coat * opacity;
    b.pick_mirror = b.pick_mirror * opacity;
    b.pick_refracted = b.pick_refracted * opacity;
    b.pick_through = b.through;
    return b;
}

/// Whitted's model as a BSDF: f = w (c k_d + k lobe^m)/π + ρ δ_mirror + τ δ_refracted, w and the shares of
/// both deltas as for Whitted's rays.
GLINT_FN Bsdf whitted_bsdf(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides,
                           GLINT_IN(WhittedModes) modes) {
    Bsdf b = black_bsdf(s, sides);
    real weight = local_weight(modes, m);
    b.diffuse = s.color * (weight * m.diffuse);
    b.gloss = modes.highlight == highlight_phong ? gloss_phong : gloss_blinn;
    b.gloss_strength = vec3(weight * m.highlight);
    b.shininess = m.shininess;
    Split split = split_at_sheet(s, m);
    if (sides.solid) {
        Refraction refraction = refraction_at(s, sides.index_before / sides.index_after);
        split = split_at_solid(m, refraction, sides.index_before, sides.index_after);
    }
    b.mirror = vec3(split.reflected);
    b.refracted = vec3(split.refracted);
    b.refracted_direction = split.direction;
    return with_choice(b, max_channel(b.diffuse), b.gloss_strength.x * (8.0f / (m.shininess + 8.0f)), 0.0f);
}

/// Lambert's: f = c/π.
GLINT_FN Bsdf diffuse_bsdf(GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides) {
    Bsdf b = black_bsdf(s, sides);
    b.diffuse = s.color;
    return with_choice(b, max_channel(b.diffuse), 0.0f, 0.0f);
}

/// The factor for light that several facets reflect, of a metal with that reflectance at normal incidence.
/// (E. Turquin, "Practical Multiple Scattering Compensation for Microfacet Models", 2019.)
GLINT_FN vec3 compensated(vec3 reflectance, real energy) {
    return vec3(1.0f) + reflectance * ((1.0f - energy) / energy);
}

GLINT_FN Bsdf conductor_bsdf(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s,
                             GLINT_IN(BsdfSides) sides) {
    Bsdf b = black_bsdf(s, sides);
    b.facets.f0 = s.color;
    b.facets.f90 = vec3(1.0f);
    if ((m.flags & material_metal) != 0) {
        b.facets.fresnel = fresnel_of_metal;
        b.facets.f0 = m.metal_n / sides.index_before;
        b.facets.f90 = m.metal_k / sides.index_before;
    }
    real cosine = dot(s.n, s.v);
    if (m.roughness < min_roughness) {
        b.mirror = facet_fresnel(b.facets, cosine);
        return with_choice(b, 0.0f, 0.0f, 0.0f);
    }
    b.gloss = gloss_facets;
    b.facets.alpha = m.roughness * m.roughness;
    b.facets.reflected =
        compensated(facet_fresnel(b.facets, 1.0f), microfacet_energy(cosine, b.facets.alpha, 0.0f));
    return with_choice(b, 0.0f, 1.0f, 0.0f);
}

/// Smooth glass: a solid's surface, or both faces of a sheet at once.
GLINT_FN Bsdf smooth_dielectric(GLINT_IN(Bsdf) black, GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides,
                                real eta) {
    Bsdf b = black;
    real share = fresnel_dielectric(min(1.0f, dot(s.n, s.v)), eta);
    if (!sides.solid) share = pane_reflectance(share);
    if (sides.solid) {
        Refraction refraction = refraction_at(s, 1.0f / eta);
        if (refraction.total) share = 1.0f;
        b.refracted_direction = refraction.direction;
    }
    b.mirror = vec3(share);
    b.refracted = s.color * ((1.0f - share) * b.radiance_scale);
    return with_choice(b, 0.0f, 0.0f, 0.0f);
}

GLINT_FN Bsdf dielectric_bsdf(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s,
                              GLINT_IN(BsdfSides) sides) {
    Bsdf b = black_bsdf(s, sides);
    real eta = (sides.solid ? sides.index_after : m.index) / sides.index_before;
    if (sides.solid) b.radiance_scale = 1.0f / (eta * eta);
    if (m.roughness < min_roughness || abs(eta - 1.0f) < min_bending)
        return smooth_dielectric(b, s, sides, eta);
    b.gloss = gloss_facets;
    b.facets.alpha = m.roughness * m.roughness;
    b.facets.fresnel = sides.solid ? fresnel_of_index : fresnel_of_pane;
    b.facets.eta = eta;
    b.facets.thin = !sides.solid;
    real energy = microfacet_energy(dot(s.n, s.v), b.facets.alpha, sides.solid ? eta : 0.0f);
    b.facets.reflected = vec3(1.0f / energy);
    b.facets.transmitted = s.color / energy;
    return with_choice(b, 0.0f, 1.0f, 0.0f);
}

/// A diffuse body under a dielectric coat. What the body reflects passes the coat from inside, and what the
/// coat reflects back is reflected again: 1/(1 − c F̄).
GLINT_FN Bsdf plastic_bsdf(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides) {
    Bsdf b = black_bsdf(s, sides);
    real eta = m.index / sides.index_before;
    real inside = mean_reflectance(1.0f / eta);
    real share = fresnel_dielectric(min(1.0f, dot(s.n, s.v)), eta);
    b.diffuse = s.color * ((1.0f - share) / (eta * eta)) / (vec3(1.0f) - s.color * inside);
    b.body = body_coated;
    b.facets.fresnel = fresnel_of_index;
    b.facets.eta = eta;
    b.facets.reflected = vec3(1.0f);
    if (m.roughness < min_roughness) {
        b.mirror = vec3(share);
        return with_choice(b, max_channel(b.diffuse), 0.0f, 0.0f);
    }
    b.gloss = gloss_facets;
    b.facets.alpha = m.roughness * m.roughness;
    return with_choice(b, max_channel(b.diffuse), share, 0.0f);
}

/// The reflection of metal and of what lies over the diffuse and the transmitting part, as one lobe.
GLINT_FN FacetLobe principled_facets(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s,
                                     GLINT_IN(BsdfSides) sides) {
    FacetLobe lobe = no_facets();
    real dielectric = 1.0f - m.metallic;
    vec3 tinted = min(m.specular_color * normal_reflectance(m.index), vec3(1.0f)) * m.specular;
    lobe.f0 = tinted * dielectric + s.color * m.metallic;
    lobe.f90 = vec3(m.specular * dielectric + m.metallic);
    lobe.kept_0 = max_channel(tinted);
    lobe.kept_90 = m.specular;
    lobe.thin = !sides.solid;
    lobe.eta = sides.solid && m.transmission > 0.0f ? sides.index_after / sides.index_before : 1.0f;
    lobe.reflected = vec3(1.0f);
    lobe.transmitted = s.color * (dielectric * m.transmission);
    return lobe;
}

/// The lobe as rough or as deltas.
GLINT_FN Bsdf with_principled_facets(GLINT_IN(Bsdf) body, GLINT_IN(MaterialRecord) m,
                                     GLINT_IN(SurfaceRecord) s) {
    Bsdf b = body;
    real cosine = min(1.0f, dot(s.n, s.v));
    truth bends = !b.facets.thin && lets_through(b.facets);
    if (bends) b.radiance_scale = 1.0f / (b.facets.eta * b.facets.eta);
    if (m.roughness < min_roughness || (bends && abs(b.facets.eta - 1.0f) < min_bending)) {
        b.mirror = facet_fresnel(b.facets, cosine);
        b.refracted = b.facets.transmitted * ((1.0f - facet_kept(b.facets, cosine)) * b.radiance_scale);
        if (bends) b.refracted_direction = refraction_at(s, 1.0f / b.facets.eta).direction;
        return b;
    }
    b.gloss = gloss_facets;
    b.facets.alpha = m.roughness * m.roughness;
    real through = (1.0f - m.metallic) * m.transmission;
    real energy = microfacet_energy(cosine, b.facets.alpha, 0.0f);
    real of_glass = bends ? microfacet_energy(cosine, b.facets.alpha, b.facets.eta) : energy;
    b.facets.reflected = compensated(b.facets.f0, energy) * (1.0f - through) + vec3(through / of_glass);
    b.facets.transmitted = b.facets.transmitted / of_glass;
    return b;
}

GLINT_FN Bsdf with_clearcoat(GLINT_IN(Bsdf) lobes, GLINT_IN(MaterialRecord) m, real cosine) {
    real share = m.clearcoat * (0.04f + 0.96f * schlick_weight(cosine));
    Bsdf b = dimmed(lobes, 1.0f - share);
    if (m.clearcoat_roughness < min_roughness) {
        b.mirror = b.mirror + vec3(share);
        return b;
    }
    b.coat.alpha = m.clearcoat_roughness * m.clearcoat_roughness;
    b.coat.f0 = vec3(1.0f);
    b.coat.f90 = vec3(1.0f);
    b.coat.reflected = vec3(share);
    return b;
}

/// The metallic-roughness material of glTF 2.0, appendix B, with its extensions.
GLINT_FN Bsdf principled_bsdf(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s,
                              GLINT_IN(BsdfSides) sides) {
    Bsdf b = black_bsdf(s, sides);
    real cosine = min(1.0f, dot(s.n, s.v));
    b.facets = principled_facets(m, s, sides);
    b.diffuse = s.color * ((1.0f - m.metallic) * (1.0f - m.transmission));
    b.body = body_mixed;
    b = with_principled_facets(b, m, s);
    if (max_channel(m.sheen_color) > 0.0f) {
        b.sheen_alpha = max(m.sheen_roughness * m.sheen_roughness, 0.0001f);
        b = dimmed(b, 1.0f - max_channel(m.sheen_color) * min(1.0f, sheen_energy(cosine, b.sheen_alpha)));
        b.sheen = m.sheen_color;
    }
    if (m.clearcoat > 0.0f) b = with_clearcoat(b, m, cosine);
    real gloss = 0.0f;
    if (b.gloss == gloss_facets)
        gloss = max_channel(facet_fresnel(b.facets, cosine) * b.facets.reflected) +
                max_channel(b.facets.transmitted) * (1.0f - facet_kept(b.facets, cosine));
    return with_choice(b, max_channel(b.diffuse) + max_channel(b.sheen), gloss, b.coat.reflected.x);
}

/// The surface with a normal that the viewer sees.
GLINT_FN SurfaceRecord seen_surface(GLINT_IN(SurfaceRecord) surface) {
    SurfaceRecord s = surface;
    s.n = dot(s.n, s.v) > 0.0f ? s.n : s.n_g;
    return s;
}

GLINT_FN Bsdf whole_bsdf_at(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) surface,
                            GLINT_IN(BsdfSides) sides, GLINT_IN(WhittedModes) modes) {
    if (m.model == model_whitted) return whitted_bsdf(m, surface, sides, modes);
    if (m.model == model_diffuse) return diffuse_bsdf(surface, sides);
    SurfaceRecord s = seen_surface(surface);
    if (m.model == model_conductor) return conductor_bsdf(m, s, sides);
    if (m.model == model_dielectric) return dielectric_bsdf(m, s, sides);
    if (m.model == model_plastic) return plastic_bsdf(m, s, sides);
    return principled_bsdf(m, s, sides);
}

/// `modes` are read for materials of the model `whitted`.
GLINT_FN Bsdf bsdf_at(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) surface, GLINT_IN(BsdfSides) sides,
                      GLINT_IN(WhittedModes) modes) {
    Bsdf b = whole_bsdf_at(m, surface, sides, modes);
    if (m.opacity < 1.0f) b = perforated(b, m.opacity);
    return b;
}

GLINT_SHARED_END
#endif
