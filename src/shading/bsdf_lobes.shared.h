#ifndef GLINT_SHADING_BSDF_LOBES_SHARED_H
#define GLINT_SHADING_BSDF_LOBES_SHARED_H
#include "math/shared.h"
#include "shading/microfacet.shared.h"
#include "shading/records.shared.h"
#include "shading/sampling.shared.h"
#include "shading/whitted.shared.h"

// The lobes of a BSDF, their values and samples: see shading/bsdf.shared.h.

GLINT_SHARED_BEGIN

/// Values or weights of lobes, by the layer of a picture to which the first hit's belong.
struct BsdfValue {
    vec3 diffuse;
    vec3 specular; ///< reflected, but not diffusely: highlights and mirrors
    vec3 transmission;
};

GLINT_FN vec3 sum_of(GLINT_IN(BsdfValue) value) {
    return (value.diffuse + value.specular) + value.transmission;
}

// FacetLobe::fresnel
const int fresnel_of_index = 0; ///< a dielectric, by `eta`
const int fresnel_of_pane = 1;  ///< both faces of a thin sheet of it
const int fresnel_of_metal = 2; ///< n + k i = f0 + f90 i
const int fresnel_of_color = 3; ///< Schlick's, from f0 to f90

/// Light that microfacets reflect and transmit.
struct FacetLobe {
    real alpha;
    int fresnel;
    vec3 f0;
    vec3 f90;
    real kept_0; ///< fresnel_of_color: the share that is not transmitted rises from this …
    real kept_90;
    real eta;         ///< index behind / in front
    bool thin;        ///< light goes through unbent
    vec3 reflected;   ///< factor of what is reflected
    vec3 transmitted; ///< factor of what is transmitted; 0: opaque
};

// Bsdf::gloss
const int gloss_none = 0;
const int gloss_blinn = 1;
const int gloss_phong = 2;
const int gloss_facets = 3;

// Bsdf::body
const int body_plain = 0;  ///< Lambert's
const int body_coated = 1; ///< under a dielectric, of which light passes the face on its way in: 1 − F(l)
const int body_mixed = 2;  ///< gets what the facets' lobe does not keep at the half vector

/// A material at one point, seen from one direction.
struct Bsdf {
    vec3 v;
    vec3 n_g;    ///< both normals on the viewer's side
    Basis basis; ///< about the shading normal

    vec3 diffuse; ///< albedo of the Lambertian lobe
    int body;
    vec3 sheen; ///< of cloth; sampled with the Lambertian lobe
    real sheen_alpha;

    int gloss;
    vec3 gloss_strength; ///< Blinn and Phong: k
    real shininess;      ///< Blinn and Phong: m
    FacetLobe facets;
    FacetLobe coat; ///< a second lobe

    vec3 mirror; ///< weight of the mirror direction's delta
    vec3 mirror_direction;
    vec3 refracted; ///< weight of the refracted direction's delta
    vec3 refracted_direction;
    truth straight;      ///< that is straight on through a sheet
    real through;        ///< weight of a delta straight on, where the surface is not there
    real radiance_scale; ///< the factor of what is transmitted that roulette must not see: (η₁/η₂)², or 1

    // Probabilities of the lobes; their sum is 1, or 0 for a black surface.
    real pick_diffuse;
    real pick_gloss;
    real pick_coat;
    real pick_mirror;
    real pick_refracted;
    real pick_through;
};

struct BsdfSample {
    vec3 direction;
    BsdfValue weight; ///< f |cos θ| / pdf; 0 ends the path
    real pdf;         ///< bsdf_pdf() of the direction; 0 for a delta
    truth delta;
    truth transmits;     ///< the direction leaves on the other side
    truth straight;      ///< a delta that goes on unbent, through a sheet or where the surface is not there
    real radiance_scale; ///< (n_before/n_after)² where the weight has this factor of refraction, else 1
};

GLINT_FN BsdfValue no_value() {
    BsdfValue value;
    value.diffuse = vec3(0.0f);
    value.specular = vec3(0.0f);
    value.transmission = vec3(0.0f);
    return value;
}

GLINT_FN real max_channel(vec3 color) { return max(color.x, max(color.y, color.z)); }

/// Has it lobes that are not deltas? If not, sampling lights is of no use.
GLINT_FN truth has_spread(GLINT_IN(Bsdf) b) { return b.pick_diffuse + b.pick_gloss + b.pick_coat > 0.0f; }

// ── Glossy lobes of Blinn and Phong

/// The cosine whose power is the lobe.
GLINT_FN real gloss_cosine(GLINT_IN(Bsdf) b, vec3 l) {
    return b.gloss == gloss_phong ? phong_cosine(b.basis.n, l, b.v) : blinn_cosine(b.basis.n, l, b.v);
}

/// Density (m + 1)/(2π) cos^m of half vectors h about n, or of l about the mirror direction. That of l is a
/// (4 |h·v|)th of h's. (M. Pharr, G. Humphreys, Physically Based Rendering, 1st edition, section 14.5.)
GLINT_FN real gloss_pdf(GLINT_IN(Bsdf) b, vec3 l) {
    real scale = (b.shininess + 1.0f) * (0.5f * one_over_pi);
    if (b.gloss == gloss_phong) return scale * lobe_of(phong_cosine(b.basis.n, l, b.v), b.shininess);
    vec3 h = l + b.v;
    real size = sqrt(dot(h, h));
    real cosine = abs(dot(h, b.v));
    if (!(cosine > 0.0f)) return 0.0f;
    return scale * lobe_of(abs(dot(h, b.basis.n)) / size, b.shininess) * size / (4.0f * cosine);
}

/// A unit vector about +z with density (m + 1)/(2π) cos^m θ.
GLINT_FN vec3 power_cosine_sample(real m, real u, real v) {
    vec3 around = disk_sample(u, v);
    real squared = squared_sine(around); // uniform in 0 … 1
    real cosine = pow_of(max(0.0f, 1.0f - squared), 1.0f / (m + 1.0f));
    real scale = squared > 0.0f ? sqrt(max(0.0f, 1.0f - cosine * cosine) / squared) : 0.0f;
    return vec3(around.x * scale, around.y * scale, cosine);
}

GLINT_FN vec3 gloss_direction(GLINT_IN(Bsdf) b, real u, real v) {
    vec3 d = power_cosine_sample(b.shininess, u, v);
    if (b.gloss == gloss_phong) return turned_to(normalize(mirror_direction(b.v, b.basis.n)), d);
    return mirror_direction(b.v, from_basis(b.basis, d));
}

// ── Microfacets, in the frame of the normal

/// The cosine on the side with the lower index; 0 where reflection is total.
GLINT_FN real cosine_outside(real cosine, real eta) {
    if (eta >= 1.0f) return cosine;
    return sqrt(max(0.0f, snell_discriminant(cosine, 1.0f / eta)));
}

/// F at a facet, where the cosine is that of its normal with the viewer's direction.
GLINT_FN vec3 facet_fresnel(GLINT_IN(FacetLobe) lobe, real cosine) {
    if (lobe.fresnel == fresnel_of_metal)
        return vec3(fresnel_conductor(cosine, lobe.f0.x, lobe.f90.x),
                    fresnel_conductor(cosine, lobe.f0.y, lobe.f90.y),
                    fresnel_conductor(cosine, lobe.f0.z, lobe.f90.z));
    if (lobe.fresnel == fresnel_of_color)
        return lobe.f0 + (lobe.f90 - lobe.f0) * schlick_weight(cosine_outside(cosine, lobe.eta));
    real share = fresnel_dielectric(cosine, lobe.eta);
    return vec3(lobe.fresnel == fresnel_of_pane ? pane_reflectance(share) : share);
}

/// The share of light that is not transmitted.
GLINT_FN real facet_kept(GLINT_IN(FacetLobe) lobe, real cosine) {
    if (lobe.fresnel != fresnel_of_color) return facet_fresnel(lobe, cosine).x;
    real outside = cosine_outside(cosine, lobe.eta);
    return outside > 0.0f ? lobe.kept_0 + (lobe.kept_90 - lobe.kept_0) * schlick_weight(outside) : 1.0f;
}

GLINT_FN truth lets_through(GLINT_IN(FacetLobe) lobe) { return max_channel(lobe.transmitted) > 0.0f; }

/// The probability that a facet is taken to reflect.
GLINT_FN real facet_pick_reflection(GLINT_IN(FacetLobe) lobe, real cosine) {
    if (!lets_through(lobe)) return 1.0f;
    real reflected = max_channel(facet_fresnel(lobe, cosine) * lobe.reflected);
    real transmitted = max_channel(lobe.transmitted) * (1.0f - facet_kept(lobe, cosine));
    return transmitted > 0.0f ? reflected / (reflected + transmitted) : 1.0f;
}

/// f |cos θ| of one lobe, and its density.
struct FacetValue {
    vec3 value;
    real pdf;
};

GLINT_FN FacetValue no_facet_value() {
    FacetValue none;
    none.value = vec3(0.0f);
    none.pdf = 0.0f;
    return none;
}

/// Of facets with the half vector of o and i, if these reflect o to i: to below the surface too, where it is
/// lost. By probability.
GLINT_FN real facet_density(GLINT_IN(FacetLobe) lobe, vec3 o, vec3 h, real probability) {
    return probability * ggx_density(h, lobe.alpha) * ggx_seen(o, lobe.alpha) * 0.25f;
}

GLINT_FN FacetValue reflected_value(GLINT_IN(FacetLobe) lobe, vec3 o, vec3 i) {
    FacetValue found = no_facet_value();
    vec3 h = o + i;
    if (!(h.z > 0.0f)) return found;
    h = normalize(h);
    real cosine = dot(o, h);
    found.pdf = facet_density(lobe, o, h, facet_pick_reflection(lobe, cosine));
    if (i.z > 0.0f)
        found.value = facet_fresnel(lobe, cosine) * lobe.reflected *
                      (ggx_density(h, lobe.alpha) * ggx_visibility(o, i, lobe.alpha) * i.z);
    return found;
}

/// Through a sheet: as reflected, then mirrored.
GLINT_FN FacetValue passed_value(GLINT_IN(FacetLobe) lobe, vec3 o, vec3 i) {
    FacetValue found = no_facet_value();
    vec3 h = o + vec3(i.x, i.y, -i.z);
    if (!(h.z > 0.0f)) return found;
    h = normalize(h);
    real cosine = dot(o, h);
    found.pdf = facet_density(lobe, o, h, 1.0f - facet_pick_reflection(lobe, cosine));
    if (i.z < 0.0f)
        found.value = lobe.transmitted * ((1.0f - facet_kept(lobe, cosine)) * ggx_density(h, lobe.alpha) *
                                          ggx_visibility(o, i, lobe.alpha) * -i.z);
    return found;
}

/// Walter et al., eq. 21 and 17.
GLINT_FN FacetValue refracted_value(GLINT_IN(FacetLobe) lobe, vec3 o, vec3 i) {
    FacetValue found = no_facet_value();
    vec3 h = refraction_half_vector(o, i, lobe.eta);
    real o_h = dot(o, h);
    real i_h = dot(i, h);
    if (!(o_h > 0.0f && i_h < 0.0f)) return found;
    real sum = o_h + lobe.eta * i_h;
    real change = -4.0f * o_h * i_h / (sum * sum);
    found.pdf =
        facet_density(lobe, o, h, 1.0f - facet_pick_reflection(lobe, o_h)) * (change * lobe.eta * lobe.eta);
    if (i.z < 0.0f)
        found.value = lobe.transmitted * ((1.0f - facet_kept(lobe, o_h)) * ggx_density(h, lobe.alpha) *
                                          ggx_visibility(o, i, lobe.alpha) * -i.z * change);
    return found;
}

GLINT_FN FacetValue facet_value(GLINT_IN(FacetLobe) lobe, vec3 o, vec3 i) {
    if (!(o.z > 0.0f)) return no_facet_value();
    FacetValue reflected = reflected_value(lobe, o, i);
    if (!lets_through(lobe)) return reflected;
    FacetValue found = lobe.thin ? passed_value(lobe, o, i) : refracted_value(lobe, o, i);
    found.value = found.value + reflected.value;
    found.pdf = found.pdf + reflected.pdf;
    return found;
}

GLINT_FN vec3 facet_sample(GLINT_IN(FacetLobe) lobe, vec3 o, real u_lobe, real u, real v) {
    vec3 h = ggx_facet(o, lobe.alpha, disk_sample(u, v));
    real cosine = dot(o, h);
    vec3 reflected = h * (2.0f * cosine) - o;
    if (u_lobe < facet_pick_reflection(lobe, cosine)) return reflected;
    if (lobe.thin) return vec3(reflected.x, reflected.y, -reflected.z);
    return refracted_at(h, o, lobe.eta);
}

// ── Asking it

/// The share of diffused light from l that enters the body.
GLINT_FN real body_share(GLINT_IN(Bsdf) b, vec3 l) {
    if (b.body == body_coated) return 1.0f - fresnel_dielectric(max(0.0f, dot(b.basis.n, l)), b.facets.eta);
    if (b.body == body_mixed) {
        vec3 sum = l + b.v;
        return 1.0f - facet_kept(b.facets, dot(sum, b.v) / sqrt(dot(sum, sum)));
    }
    return 1.0f;
}

/// Value and density of one direction.
struct BsdfAt {
    BsdfValue value;
    real pdf;
};

GLINT_FN BsdfAt lobes_at(GLINT_IN(Bsdf) b, vec3 l) {
    BsdfAt at;
    at.value = no_value();
    vec3 o = to_basis(b.basis, b.v);
    vec3 i = to_basis(b.basis, l);
    vec3 diffuse = vec3(0.0f);
    vec3 glossy = vec3(0.0f);
    at.pdf = b.pick_diffuse * (max(0.0f, i.z) * one_over_pi);
    if (b.pick_diffuse > 0.0f && i.z > 0.0f) {
        diffuse = b.diffuse * (body_share(b, l) * i.z * one_over_pi);
        if (max_channel(b.sheen) > 0.0f) glossy = b.sheen * sheen_value(o, i, b.sheen_alpha);
    }
    if (b.pick_gloss > 0.0f && b.gloss == gloss_facets) {
        FacetValue facets = facet_value(b.facets, o, i);
        glossy = glossy + facets.value;
        at.pdf = at.pdf + b.pick_gloss * facets.pdf;
    } else if (b.pick_gloss > 0.0f) {
        glossy = b.gloss_strength * (lobe_of(gloss_cosine(b, l), b.shininess) * i.z * one_over_pi);
        at.pdf = at.pdf + b.pick_gloss * gloss_pdf(b, l);
    }
    if (b.pick_coat > 0.0f) {
        FacetValue coat = facet_value(b.coat, o, i);
        glossy = glossy + coat.value;
        at.pdf = at.pdf + b.pick_coat * coat.pdf;
    }
    real side = dot(b.n_g, l);
    if (i.z > 0.0f && side > 0.0f) {
        at.value.diffuse = diffuse;
        at.value.specular = glossy;
    }
    if (i.z < 0.0f && side < 0.0f && lets_through(b.facets)) at.value.transmission = glossy;
    return at;
}

/// f |cos θ| for light from l, by layers; without the deltas.
GLINT_FN BsdfValue bsdf_value(GLINT_IN(Bsdf) b, vec3 l) { return lobes_at(b, l).value; }

/// The density with which bsdf_sample() finds l by the lobes that are not deltas.
GLINT_FN real bsdf_pdf(GLINT_IN(Bsdf) b, vec3 l) { return lobes_at(b, l).pdf; }

GLINT_FN BsdfSample sample_along(vec3 direction) {
    BsdfSample chosen;
    chosen.direction = direction;
    chosen.weight = no_value();
    chosen.pdf = 0.0f;
    chosen.delta = false;
    chosen.transmits = false;
    chosen.straight = false;
    chosen.radiance_scale = 1.0f;
    return chosen;
}

GLINT_FN BsdfSample mirror_sample(GLINT_IN(Bsdf) b) {
    BsdfSample chosen = sample_along(b.mirror_direction);
    chosen.weight.specular = b.mirror / b.pick_mirror;
    chosen.delta = true;
    return chosen;
}

GLINT_FN BsdfSample refracted_sample(GLINT_IN(Bsdf) b) {
    BsdfSample chosen = sample_along(b.refracted_direction);
    chosen.weight.transmission = b.refracted / b.pick_refracted;
    chosen.delta = true;
    chosen.transmits = true;
    chosen.straight = b.straight;
    chosen.radiance_scale = b.radiance_scale;
    return chosen;
}

GLINT_FN BsdfSample through_sample(GLINT_IN(Bsdf) b) {
    BsdfSample chosen = sample_along(-b.v);
    chosen.weight.transmission = vec3(b.through / b.pick_through);
    chosen.delta = true;
    chosen.transmits = true;
    chosen.straight = true;
    return chosen;
}

/// A direction of a lobe that is not a delta, weighted by all of them.
GLINT_FN BsdfSample spread_sample(GLINT_IN(Bsdf) b, vec3 direction) {
    BsdfSample chosen = sample_along(normalize(direction));
    chosen.transmits = dot(b.n_g, chosen.direction) < 0.0f;
    if (chosen.transmits) chosen.radiance_scale = b.radiance_scale;
    BsdfAt at = lobes_at(b, chosen.direction);
    chosen.pdf = at.pdf;
    if (!(at.pdf > 0.0f)) return chosen;
    chosen.weight.diffuse = at.value.diffuse / at.pdf;
    chosen.weight.specular = at.value.specular / at.pdf;
    chosen.weight.transmission = at.value.transmission / at.pdf;
    return chosen;
}

const int lobe_diffuse = 0;
const int lobe_gloss = 1;
const int lobe_coat = 2;
const int lobe_mirror = 3;
const int lobe_refracted = 4;
const int lobe_through = 5;

/// A lobe, and where u lies in its interval of probabilities, 0 … 1.
struct LobeChoice {
    int lobe;
    real u;
};

GLINT_FN LobeChoice or_lobe(LobeChoice chosen, int lobe, real begin, real probability, real u) {
    LobeChoice other;
    other.lobe = lobe;
    other.u = min(0.99999994f, (u - begin) / probability);
    if (probability > 0.0f && u >= begin) return other;
    return chosen;
}

/// The last lobe whose interval begins at or below u, so that rounding of their sum is of no consequence.
GLINT_FN LobeChoice chosen_lobe(GLINT_IN(Bsdf) b, real u) {
    LobeChoice chosen;
    chosen.lobe = lobe_diffuse;
    chosen.u = u;
    real begin = b.pick_diffuse;
    chosen = or_lobe(chosen, lobe_gloss, begin, b.pick_gloss, u);
    begin = begin + b.pick_gloss;
    chosen = or_lobe(chosen, lobe_coat, begin, b.pick_coat, u);
    begin = begin + b.pick_coat;
    chosen = or_lobe(chosen, lobe_mirror, begin, b.pick_mirror, u);
    begin = begin + b.pick_mirror;
    chosen = or_lobe(chosen, lobe_refracted, begin, b.pick_refracted, u);
    // Of a black surface the other probabilities are 0, but what is there ends the path.
    return or_lobe(chosen, lobe_through, 1.0f - b.pick_through, b.pick_through, u);
}

/// A direction, by three numbers in [0, 1).
GLINT_FN BsdfSample bsdf_sample(GLINT_IN(Bsdf) b, real u_lobe, real u, real v) {
    LobeChoice chosen = chosen_lobe(b, u_lobe);
    if (chosen.lobe == lobe_mirror) return mirror_sample(b);
    if (chosen.lobe == lobe_refracted) return refracted_sample(b);
    if (chosen.lobe == lobe_through) return through_sample(b);
    vec3 o = to_basis(b.basis, b.v);
    if (chosen.lobe == lobe_coat)
        return spread_sample(b, from_basis(b.basis, facet_sample(b.coat, o, chosen.u, u, v)));
    if (chosen.lobe == lobe_diffuse) return spread_sample(b, from_basis(b.basis, cosine_sample(u, v)));
    if (b.gloss != gloss_facets) return spread_sample(b, gloss_direction(b, u, v));
    return spread_sample(b, from_basis(b.basis, facet_sample(b.facets, o, chosen.u, u, v)));
}

GLINT_SHARED_END
#endif
