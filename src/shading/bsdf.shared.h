#ifndef GLINT_SHADING_BSDF_SHARED_H
#define GLINT_SHADING_BSDF_SHARED_H
#include "math/shared.h"
#include "shading/records.shared.h"
#include "shading/sampling.shared.h"
#include "shading/whitted.shared.h"

// What a path tracer asks of a material at one point of a surface, for single rays:
//
//     Bsdf b = bsdf_at(material, surface, sides, modes);  // once at each vertex
//     bsdf_value(b, l), bsdf_pdf(b, l)                    // of a direction that a light was sampled in
//     bsdf_sample(b, u_lobe, u, v)                        // the next direction of the path
//
// A Bsdf is a sum of lobes. Deltas (mirrors, smooth refraction) are met by bsdf_sample() alone: the other two
// functions speak of the rest. Densities are over solid angle, and those of bsdf_sample() include the choice
// of the lobe, so that pdfs of both functions are the same function. Values hold |cos θ|. Directions are unit
// vectors that point away from the surface: v to the viewer (SurfaceRecord::v, which holds for the whole
// Bsdf), l to the light.
//
// Light counts if it is on the same side of the geometric surface as of the shading normal's. A sampled
// direction that is not has the value 0, and ends its path; its density stays.

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

/// The media on both sides of a surface.
struct BsdfSides {
    real index_before; ///< of refraction, on the viewer's side
    real index_after;  ///< behind the surface; of solids only
    truth solid;       ///< it bounds a transparent solid and bends light; else it is a sheet, or opaque
};

// Bsdf::gloss
const int gloss_none = 0;
const int gloss_blinn = 1;
const int gloss_phong = 2;

/// A material at one point, seen from one direction.
struct Bsdf {
    vec3 v;
    vec3 n_g; ///< both normals on the viewer's side
    vec3 n;

    vec3 diffuse; ///< albedo of the Lambertian lobe

    int gloss;           ///< the glossy lobe's kind
    vec3 gloss_strength; ///< Blinn and Phong: k
    real shininess;      ///< Blinn and Phong: m

    vec3 mirror; ///< weight of the mirror direction's delta
    vec3 mirror_direction;
    vec3 refracted; ///< weight of the refracted direction's delta
    vec3 refracted_direction;
    real radiance_scale; ///< the factor of `refracted` that roulette must not see: (η₁/η₂)², or 1

    // Probabilities of the lobes; their sum is 1, or 0 for a black surface.
    real pick_diffuse;
    real pick_gloss;
    real pick_mirror;
    real pick_refracted;
};

struct BsdfSample {
    vec3 direction;
    BsdfValue weight; ///< f |cos θ| / pdf; 0 ends the path
    real pdf;         ///< bsdf_pdf() of the direction; 0 for a delta
    truth delta;
    truth transmits;     ///< the direction leaves on the other side
    truth straight;      ///< it goes through a sheet unbent
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
GLINT_FN truth has_spread(GLINT_IN(Bsdf) b) { return b.pick_diffuse > 0.0f || b.pick_gloss > 0.0f; }

// ── Making one

/// Without lobes.
GLINT_FN Bsdf black_bsdf(GLINT_IN(SurfaceRecord) s) {
    Bsdf b;
    b.v = s.v;
    b.n_g = s.n_g;
    b.n = s.n;
    b.diffuse = vec3(0.0f);
    b.gloss = gloss_none;
    b.gloss_strength = vec3(0.0f);
    b.shininess = 0.0f;
    b.mirror = vec3(0.0f);
    b.mirror_direction = s.n_g;
    b.refracted = vec3(0.0f);
    b.refracted_direction = -s.v;
    b.radiance_scale = 1.0f;
    b.pick_diffuse = 0.0f;
    b.pick_gloss = 0.0f;
    b.pick_mirror = 0.0f;
    b.pick_refracted = 0.0f;
    return b;
}

/// With probabilities in proportion to estimates of what the lobes reflect: of the glossy one `gloss_albedo`.
GLINT_FN Bsdf with_choice(GLINT_IN(Bsdf) lobes, real gloss_albedo) {
    Bsdf b = lobes;
    b.pick_diffuse = max_channel(b.diffuse);
    b.pick_gloss = gloss_albedo;
    b.pick_mirror = max_channel(b.mirror);
    b.pick_refracted = max_channel(b.refracted);
    real sum = b.pick_diffuse + b.pick_gloss + b.pick_mirror + b.pick_refracted;
    real scale = sum > 0.0f ? 1.0f / sum : 0.0f;
    b.pick_diffuse = b.pick_diffuse * scale;
    b.pick_gloss = b.pick_gloss * scale;
    b.pick_mirror = b.pick_mirror * scale;
    b.pick_refracted = b.pick_refracted * scale;
    return b;
}

/// Whitted's model as a BSDF: f = w (c k_d + k lobe^m)/π + ρ δ_mirror + τ δ_refracted, w and the shares of
/// both deltas as for Whitted's rays. (docs/light-model.md.)
GLINT_FN Bsdf whitted_bsdf(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides,
                           GLINT_IN(WhittedModes) modes) {
    Bsdf b = black_bsdf(s);
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
    b.mirror_direction = mirror_ray_direction(s.v, s.n, s.n_g);
    b.refracted = vec3(split.refracted);
    b.refracted_direction = split.direction;
    return with_choice(b, b.gloss_strength.x * (8.0f / (m.shininess + 8.0f)));
}

/// Lambert's: f = c/π.
GLINT_FN Bsdf diffuse_bsdf(GLINT_IN(SurfaceRecord) s) {
    Bsdf b = black_bsdf(s);
    b.diffuse = s.color;
    return with_choice(b, 0.0f);
}

/// `modes` are read for materials of the model `whitted`.
GLINT_FN Bsdf bsdf_at(GLINT_IN(MaterialRecord) m, GLINT_IN(SurfaceRecord) s, GLINT_IN(BsdfSides) sides,
                      GLINT_IN(WhittedModes) modes) {
    if (m.model == model_diffuse) return diffuse_bsdf(s);
    return whitted_bsdf(m, s, sides, modes);
}

// ── Glossy lobes of Blinn and Phong

const float one_over_pi = 0.318309886f;

/// The cosine whose power is the lobe.
GLINT_FN real gloss_cosine(GLINT_IN(Bsdf) b, vec3 l) {
    return b.gloss == gloss_phong ? phong_cosine(b.n, l, b.v) : blinn_cosine(b.n, l, b.v);
}

/// Density (m + 1)/(2π) cos^m of half vectors h about n, or of l about the mirror direction. That of l is a
/// (4 |h·v|)th of h's. (M. Pharr, G. Humphreys, Physically Based Rendering, 1st edition, section 14.5.)
GLINT_FN real gloss_pdf(GLINT_IN(Bsdf) b, vec3 l) {
    real scale = (b.shininess + 1.0f) * (0.5f * one_over_pi);
    if (b.gloss == gloss_phong) return scale * lobe_of(phong_cosine(b.n, l, b.v), b.shininess);
    vec3 h = l + b.v;
    real size = sqrt(dot(h, h));
    real cosine = abs(dot(h, b.v));
    if (!(cosine > 0.0f)) return 0.0f;
    return scale * lobe_of(abs(dot(h, b.n)) / size, b.shininess) * size / (4.0f * cosine);
}

/// A unit vector about +z with density (m + 1)/(2π) cos^m θ.
GLINT_FN vec3 power_cosine_sample(real m, real u, real v) {
    vec3 around = disk_sample(u, v);
    real squared = around.x * around.x + around.y * around.y; // uniform in 0 … 1
    real cosine = pow_of(max(0.0f, 1.0f - squared), 1.0f / (m + 1.0f));
    real scale = squared > 0.0f ? sqrt(max(0.0f, 1.0f - cosine * cosine) / squared) : 0.0f;
    return vec3(around.x * scale, around.y * scale, cosine);
}

GLINT_FN vec3 gloss_direction(GLINT_IN(Bsdf) b, real u, real v) {
    vec3 d = power_cosine_sample(b.shininess, u, v);
    if (b.gloss == gloss_phong) return normalize(turned_to(normalize(mirror_direction(b.v, b.n)), d));
    return normalize(mirror_direction(b.v, turned_to(b.n, d)));
}

// ── Asking it

/// f |cos θ| for light from l, by layers; without the deltas.
GLINT_FN BsdfValue bsdf_value(GLINT_IN(Bsdf) b, vec3 l) {
    BsdfValue value = no_value();
    real cosine = light_cosine(b.n, b.n_g, l);
    if (!(cosine > 0.0f)) return value;
    value.diffuse = b.diffuse * (cosine * one_over_pi);
    if (b.gloss != gloss_none)
        value.specular = b.gloss_strength * (lobe_of(gloss_cosine(b, l), b.shininess) * cosine * one_over_pi);
    return value;
}

/// The density with which bsdf_sample() finds l by the lobes that are not deltas.
GLINT_FN real bsdf_pdf(GLINT_IN(Bsdf) b, vec3 l) {
    real pdf = b.pick_diffuse * (max(0.0f, dot(b.n, l)) * one_over_pi);
    if (b.pick_gloss > 0.0f) pdf = pdf + b.pick_gloss * gloss_pdf(b, l);
    return pdf;
}

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
    chosen.straight = b.refracted_direction == -b.v;
    chosen.radiance_scale = b.radiance_scale;
    return chosen;
}

/// A direction of a lobe that is not a delta, weighted by all of them.
GLINT_FN BsdfSample spread_sample(GLINT_IN(Bsdf) b, vec3 direction) {
    BsdfSample chosen = sample_along(direction);
    chosen.pdf = bsdf_pdf(b, direction);
    if (!(chosen.pdf > 0.0f)) return chosen;
    BsdfValue value = bsdf_value(b, direction);
    chosen.weight.diffuse = value.diffuse / chosen.pdf;
    chosen.weight.specular = value.specular / chosen.pdf;
    chosen.weight.transmission = value.transmission / chosen.pdf;
    return chosen;
}

const int lobe_diffuse = 0;
const int lobe_gloss = 1;
const int lobe_mirror = 2;
const int lobe_refracted = 3;

/// The last lobe whose interval of probabilities begins at or below u, so that rounding of their sum is of no
/// consequence.
GLINT_FN int chosen_lobe(GLINT_IN(Bsdf) b, real u) {
    int lobe = lobe_diffuse;
    real begin = b.pick_diffuse;
    if (b.pick_gloss > 0.0f && u >= begin) lobe = lobe_gloss;
    begin = begin + b.pick_gloss;
    if (b.pick_mirror > 0.0f && u >= begin) lobe = lobe_mirror;
    begin = begin + b.pick_mirror;
    if (b.pick_refracted > 0.0f && u >= begin) lobe = lobe_refracted;
    return lobe;
}

/// A direction, by three numbers in [0, 1).
GLINT_FN BsdfSample bsdf_sample(GLINT_IN(Bsdf) b, real u_lobe, real u, real v) {
    int lobe = chosen_lobe(b, u_lobe);
    if (lobe == lobe_mirror) return mirror_sample(b);
    if (lobe == lobe_refracted) return refracted_sample(b);
    if (lobe == lobe_gloss) return spread_sample(b, gloss_direction(b, u, v));
    return spread_sample(b, normalize(turned_to(b.n, cosine_sample(u, v))));
}

GLINT_SHARED_END
#endif
