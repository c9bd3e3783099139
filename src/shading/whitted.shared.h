#ifndef GLINT_SHADING_WHITTED_SHARED_H
#define GLINT_SHADING_WHITTED_SHARED_H
#include "math/elementary.shared.h"
#include "math/offset.shared.h"
#include "math/shared.h"
#include "shading/records.shared.h"

// The light model: every term of it, and the steps of one bounce that are made of them, in the order in which
// a hit is shaded. Each is written once, for single rays (render/estimators/), vectors of them, the GPU and
// the explanation of a pixel. Tracing the rays between the steps is the caller's.
//
// Glass is shaded by single rays only: the functions under "Refraction" are not compiled for vectors, whose
// caller hands the surfaces that light passes through to the code for one ray.
//
// Symbols: n_g geometric unit normal turned toward the viewer, n shading normal on the side of n_g, v and l
// unit vectors to viewer and light, r distance to the light, c colour, A ambient light, I intensity of a
// light (colour included), E light arriving. Colours are linear and unbounded. "Report" is the course report
// that the model follows; section numbers are its.

GLINT_SHARED_BEGIN

// ── Rays that leave a surface

/// tmax of a ray without an end.
GLINT_FN real infinite_t() { return intBitsToFloat(0x7f800000); }

struct SpawnedRay {
    vec3 origin;
    vec3 direction;
    real tmax;
};

/// A ray from the surface along `direction`, which has any length.
GLINT_FN SpawnedRay spawn_ray(GLINT_IN(SurfaceRecord) s, vec3 direction) {
    SpawnedRay ray;
    ray.origin = offset_ray_origin(s.p, s.p_error, s.n_g, direction);
    ray.direction = direction;
    ray.tmax = infinite_t();
    return ray;
}

// ── Light that arrives from a light

GLINT_FN truth is_dark(vec3 light) { return light.x == 0.0f && light.y == 0.0f && light.z == 0.0f; }

/// max(0, n·l), and 0 unless the light is also above the geometric surface: n_g·l > 0.
GLINT_FN real light_cosine(vec3 n, vec3 n_g, vec3 l) {
    return pick(dot(n_g, l) <= 0.0f, 0.0f, max(0.0f, dot(n, l)));
}

/// Light arriving from a point light: E = I · cosine / r². (Report 2.2.) Nothing arrives from r = 0.
GLINT_FN vec3 point_light_arriving(vec3 intensity, real cosine, real r_squared) {
    return pick(r_squared > 0.0f, intensity * (cosine / r_squared), vec3(0.0f));
}

/// Position of a direction between a spot light's outer cone (0) and inner cone (1), by cosines; not clamped.
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

/// Light at a point, without shadows.
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

/// Light of a light at the surface, without shadows. A directional light's distance is infinite.
GLINT_FN LightArrival light_arrival(GLINT_IN(LightRecord) light, GLINT_IN(SurfaceRecord) s) {
    vec3 n = s.n * s.lit_side;
    vec3 n_g = s.n_g * s.lit_side;
    vec3 strength = vec3(light.strength);
    LightArrival arrival;
    if (light.kind == light_directional) {
        arrival.direction = vec3(-light.direction);
        arrival.distance = infinite_t();
        arrival.cosine = light_cosine(n, n_g, arrival.direction);
        arrival.arriving = strength * arrival.cosine;
        return arrival;
    }
    arrival = arrival_from_point(vec3(light.position), strength, s.p, n, n_g);
    if (light.kind == light_spot) {
        real cos_angle = -dot(arrival.direction, vec3(light.direction));
        arrival.arriving = arrival.arriving * spot_falloff(cos_angle, light.cos_outer, light.cos_inner);
    }
    return arrival;
}

/// True if light arrives and the material reflects light, in whatever direction.
GLINT_FN truth reflects_light(GLINT_IN(MaterialRecord) m, GLINT_IN(LightArrival) arrival) {
    return (m.diffuse > 0.0f || m.highlight > 0.0f) && !is_dark(arrival.arriving);
}

/// The ray to a light. It ends at t = 1 for a light with a position, so that "between" needs no tolerance.
GLINT_FN SpawnedRay shadow_ray(GLINT_IN(LightRecord) light, GLINT_IN(SurfaceRecord) s,
                               GLINT_IN(LightArrival) arrival) {
    SpawnedRay ray = spawn_ray(s, arrival.direction);
    if (light.kind != light_directional) {
        ray.direction = vec3(light.position) - ray.origin;
        ray.tmax = 1.0f;
    }
    return ray;
}

/// The share of light that passes a surface between it and the light: τ, not bent and not absorbed.
/// (docs/light-model.md, "Shadows".)
GLINT_FN real shadow_transmittance(GLINT_IN(WhittedModes) modes, real transparency) {
    return pick(transparency > 0.0f, modes.opaque_shadows != 0 ? 0.0f : transparency, 0.0f);
}

/// The same by channel: tinted.
GLINT_FN vec3 shadow_transmittance(GLINT_IN(WhittedModes) modes, GLINT_IN(MaterialRecord) m) {
    return m.transmitted_tint * shadow_transmittance(modes, m.transparency);
}

// ── Light that the surface reflects

/// Diffuse reflection: E ⊙ c · k_d. (Report 2.2.)
GLINT_FN vec3 diffuse_term(vec3 arriving, vec3 color, real k_d) { return arriving * color * k_d; }

/// A lobe's cosine, limited to 0 … 1, to the power m: rounded to just above 1, it would overflow with a large
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

/// The cosine of the highlight's lobe.
GLINT_FN real highlight_cosine(GLINT_IN(WhittedModes) modes, vec3 n, vec3 l, vec3 v) {
    if (modes.highlight == highlight_blinn) return blinn_cosine(n, l, v);
    return phong_cosine(n, l, v);
}

/// Highlight: E ⊙ t · k · lobe. It has the light's colour, not the material's (t = 1), except on metals, and
/// carries n·l and 1/r² as the report's figures do, though neither its formula nor textbook Blinn-Phong has
/// them. (Report 2.5.)
GLINT_FN vec3 highlight_term(vec3 arriving, vec3 tint, real k, real lobe) {
    return arriving * tint * (k * lobe);
}

/// The highlight of one light, without shadows.
GLINT_FN vec3 highlight_of(GLINT_IN(WhittedModes) modes, GLINT_IN(SurfaceRecord) s,
                           GLINT_IN(MaterialRecord) m, GLINT_IN(LightArrival) arrival) {
    real lobe = lobe_of(highlight_cosine(modes, s.n * s.lit_side, arrival.direction, s.v), m.shininess);
    return highlight_term(arrival.arriving, m.reflected_tint, m.highlight, lobe);
}

/// True if the surface reflects light to the viewer: only then is a shadow ray traced. What is not diffuse
/// does so where the highlight is, since far from it the lobe is 0.
GLINT_FN truth is_worth_shadow_ray(GLINT_IN(WhittedModes) modes, GLINT_IN(SurfaceRecord) s,
                                   GLINT_IN(MaterialRecord) m, GLINT_IN(LightArrival) arrival) {
    truth reflects = reflects_light(m, arrival);
    truth only_glossy = reflects && !(m.diffuse > 0.0f);
    if (!any_lane(only_glossy)) return reflects;
    return reflects && !(only_glossy && is_dark(highlight_of(modes, s, m, arrival)));
}

/// Each channel limited to 2^22: enough if the sum will be limited to 1, and so small that subtracting the
/// rest leaves exactly 1.
GLINT_FN vec3 limit_to_range(vec3 color) { return min(color, vec3(4194304.0f)); }

/// Each channel limited to 1.
GLINT_FN vec3 limit_to_one(vec3 color) { return min(color, vec3(1.0f)); }

/// Reflected light of one light.
struct ShownLight {
    vec3 diffuse;
    vec3 highlight;
};

/// `passing` is the share of the light that passes the blockers of the shadow ray, by channel.
GLINT_FN truth is_lit(GLINT_IN(LightArrival) arrival, vec3 passing) {
    return !is_dark(passing) && !is_dark(arrival.arriving);
}

GLINT_FN ShownLight shown_light(GLINT_IN(WhittedModes) modes, GLINT_IN(SurfaceRecord) s,
                                GLINT_IN(MaterialRecord) m, GLINT_IN(LightArrival) arrival, vec3 passing) {
    ShownLight shown;
    shown.diffuse = vec3(0.0f);
    shown.highlight = vec3(0.0f);
    truth lit = is_lit(arrival, passing);
    if (!any_lane(lit)) return shown;
    vec3 diffuse = diffuse_term(arrival.arriving, s.color, m.diffuse) * passing;
    if (modes.clamp != 0) diffuse = limit_to_one(diffuse);
    shown.diffuse = pick(lit, diffuse, vec3(0.0f));

    truth glossy = lit && m.highlight > 0.0f;
    if (!any_lane(glossy)) return shown;
    vec3 highlight = highlight_of(modes, s, m, arrival) * passing;
    shown.highlight = pick(glossy, highlight, vec3(0.0f));
    return shown;
}

// ── The sum of local light

/// The terms that a surface shows without bounces, beside its emission.
struct LocalTerms {
    vec3 ambient;
    vec3 diffuse;
    vec3 highlight;
    vec3 clamp; ///< what the clamp takes: 0 or less
};

/// The sum before the clamp.
GLINT_FN vec3 local_sum(GLINT_IN(LocalTerms) local) {
    return (local.ambient + local.diffuse) + local.highlight;
}

/// Ambient light: A ⊙ c · k_a. (Report 2.2, which prints a sum; its figures are products.)
GLINT_FN vec3 ambient_term(vec3 ambient_light, vec3 color, real k_a) { return ambient_light * color * k_a; }

/// The terms without lights.
GLINT_FN LocalTerms ambient_terms(vec3 ambient_light, GLINT_IN(SurfaceRecord) s, GLINT_IN(MaterialRecord) m) {
    LocalTerms local;
    local.ambient = ambient_term(ambient_light, s.color, m.ambient);
    local.diffuse = vec3(0.0f);
    local.highlight = vec3(0.0f);
    local.clamp = vec3(0.0f);
    return local;
}

/// With what the surface shows of one more light.
GLINT_FN LocalTerms with_light(GLINT_IN(LocalTerms) local, GLINT_IN(ShownLight) shown) {
    LocalTerms more = local;
    more.diffuse = local.diffuse + shown.diffuse;
    more.highlight = local.highlight + shown.highlight;
    return more;
}

/// The terms with their sum limited to 1, if the model clamps.
GLINT_FN LocalTerms limited_terms(GLINT_IN(WhittedModes) modes, GLINT_IN(LocalTerms) local) {
    LocalTerms limited = local;
    if (modes.clamp == 0) return limited;
    limited.ambient = limit_to_range(local.ambient);
    limited.highlight = limit_to_range(local.highlight);
    vec3 sum = local_sum(limited);
    limited.clamp = limit_to_one(sum) - sum;
    return limited;
}

GLINT_FN LocalTerms weighted_terms(GLINT_IN(LocalTerms) local, real weight) {
    LocalTerms weighted;
    weighted.ambient = local.ambient * weight;
    weighted.diffuse = local.diffuse * weight;
    weighted.highlight = local.highlight * weight;
    weighted.clamp = local.clamp * weight;
    return weighted;
}

// ── Light that arrives along mirror and refracted rays

/// True if the surface reflects or transmits.
GLINT_FN truth has_bounces(GLINT_IN(MaterialRecord) m) {
    return m.reflectivity > 0.0f || m.transparency > 0.0f;
}

/// True if a ray is followed: a share `weight` of its light reaches the sample, by channel. What others would
/// add is less than min_weight times their light.
GLINT_FN truth is_worth_following(vec3 weight, real min_weight) {
    return !(max(weight.x, max(weight.y, weight.z)) < min_weight);
}

/// The weight of the local terms if the bounce is followed: 1 − τ, or 1 − ρ − τ if energy is balanced. If it
/// is not followed, their weight is 1.
GLINT_FN real local_weight(real reflectivity, real transparency, bool balanced) {
    real kept = 1.0f - transparency;
    return balanced ? max(0.0f, kept - reflectivity) : kept;
}

GLINT_FN real local_weight(GLINT_IN(WhittedModes) modes, GLINT_IN(MaterialRecord) m) {
    return local_weight(m.reflectivity, m.transparency, modes.balanced != 0);
}

/// The direction of the mirror ray: by the geometric normal if it would go below the surface otherwise.
GLINT_FN vec3 mirror_ray_direction(vec3 v, vec3 n, vec3 n_g) {
    vec3 direction = normalize(mirror_direction(v, n));
    return pick(dot(direction, n_g) > 0.0f, direction, normalize(mirror_direction(v, n_g)));
}

GLINT_FN SpawnedRay reflected_ray(GLINT_IN(SurfaceRecord) s) {
    return spawn_ray(s, mirror_ray_direction(s.v, s.n, s.n_g));
}

/// The discriminant of Snell's law: 1 − (η₁/η₂)² (1 − (n·v)²). Below 0 the reflection is total.
GLINT_FN real snell_discriminant(real n_dot_v, real eta) {
    return 1.0f - eta * eta * max(0.0f, 1.0f - n_dot_v * n_dot_v);
}

/// The refracted direction T = (η n·v − √(1 − η² (1 − (n·v)²))) n − η v with η = η₁/η₂. (Report 2.4.)
/// `discriminant` is snell_discriminant(n·v, η) and must not be negative. Equal indices go straight on.
GLINT_FN vec3 refracted_direction(vec3 v, vec3 n, real eta, real discriminant) {
    vec3 bent = normalize(n * (eta * dot(n, v) - sqrt(discriminant)) - v * eta);
    return pick(eta == 1.0f, -v, bent);
}

/// Fresnel's amplitude for light polarised across the plane of incidence, from the cosines on both sides and
/// the indices. (Born and Wolf, Principles of Optics, section 1.5.2.)
GLINT_FN real fresnel_s(real cos_1, real cos_2, real index_1, real index_2) {
    return (index_1 * cos_1 - index_2 * cos_2) / (index_1 * cos_1 + index_2 * cos_2);
}

/// Fresnel's amplitude for light polarised in the plane of incidence.
GLINT_FN real fresnel_p(real cos_1, real cos_2, real index_1, real index_2) {
    return (index_2 * cos_1 - index_1 * cos_2) / (index_2 * cos_1 + index_1 * cos_2);
}

/// Fresnel's reflectance of a dielectric for unpolarised light.
GLINT_FN real fresnel_reflectance(real cos_1, real cos_2, real index_1, real index_2) {
    real s = fresnel_s(cos_1, cos_2, index_1, index_2);
    real p = fresnel_p(cos_1, cos_2, index_1, index_2);
    return 0.5f * (s * s + p * p);
}

/// The transmittance of an absorbing medium over a distance: e^(−σ d). (Beer and Lambert.)
GLINT_FN vec3 transmittance(vec3 sigma, real d) {
    return vec3(exp_of(-(sigma.x * d)), exp_of(-(sigma.y * d)), exp_of(-(sigma.z * d)));
}

#ifndef GLINT_LANES
/// The light of its own that the surface sends to the viewer, who is in front of it or behind.
GLINT_FN vec3 emitted(GLINT_IN(MaterialRecord) m, bool in_front) {
    return (m.flags & material_front) != 0 && !in_front ? vec3(0.0f) : m.emission;
}

// ── Refraction, for single rays only

/// A ray through the surface of a solid by Snell's law.
struct Refraction {
    vec3 n;            ///< the normal that bends it: the shading normal, or n_g where that cannot serve
    vec3 direction;    ///< of the refracted ray, unless the reflection is total
    real eta;          ///< η₁/η₂
    real cosine;       ///< n·v
    real discriminant; ///< of Snell's law
    truth total;       ///< all light is reflected
};

GLINT_FN Refraction refraction_by(vec3 n, vec3 v, real eta) {
    Refraction r;
    r.n = n;
    r.eta = eta;
    r.cosine = dot(n, v);
    r.discriminant = snell_discriminant(r.cosine, eta);
    r.total = r.discriminant < 0.0f;
    r.direction = -v;
    if (!r.total) r.direction = refracted_direction(v, n, eta, r.discriminant);
    return r;
}

/// Refraction by the shading normal; by the geometric normal if the viewer is below the former or the
/// refracted ray would stay above the surface.
GLINT_FN Refraction refraction_at(GLINT_IN(SurfaceRecord) s, real eta) {
    truth seen = dot(s.n, s.v) > 0.0f;
    Refraction r = refraction_by(seen ? s.n : s.n_g, s.v, eta);
    if (seen && !r.total && !(dot(r.direction, s.n_g) < 0.0f)) r = refraction_by(s.n_g, s.v, eta);
    return r;
}

/// The two rays that go on from a surface, and their shares of the light.
struct Split {
    real reflected; ///< weight of the mirror ray
    real refracted; ///< weight of the refracted ray
    vec3 direction; ///< of the refracted ray
};

/// At an opaque surface or a thin pane: the refracted ray goes straight on.
GLINT_FN Split split_at_sheet(GLINT_IN(SurfaceRecord) s, GLINT_IN(MaterialRecord) m) {
    Split split;
    split.reflected = m.reflectivity;
    split.refracted = m.transparency;
    split.direction = -s.v;
    return split;
}

/// At the surface of a transparent solid: by Fresnel's equations if the material has them; the mirror ray
/// gets both shares if the reflection is total.
GLINT_FN Split split_at_solid(GLINT_IN(MaterialRecord) m, GLINT_IN(Refraction) r, real index_before,
                              real index_after) {
    real both = m.reflectivity + m.transparency;
    Split split;
    split.reflected = m.reflectivity;
    split.refracted = m.transparency;
    split.direction = r.direction;
    if (r.total) {
        split.reflected = both;
        split.refracted = 0.0f;
    } else if ((m.flags & material_fresnel) != 0) {
        real share = fresnel_reflectance(r.cosine, sqrt(r.discriminant), index_before, index_after);
        split.reflected = both * share;
        split.refracted = both * (1.0f - share);
    }
    return split;
}
#endif

GLINT_SHARED_END
#endif
