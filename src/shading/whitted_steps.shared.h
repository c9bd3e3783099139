#ifndef GLINT_SHADING_WHITTED_STEPS_SHARED_H
#define GLINT_SHADING_WHITTED_STEPS_SHARED_H
#include "math/offset.shared.h"
#include "math/shared.h"
#include "shading/records.shared.h"
#include "shading/whitted.shared.h"

// The steps of one bounce of Whitted's model, in the order in which a hit is shaded: light of each light,
// local sum, split between mirror and refracted ray. Each is written once, for single rays
// (render/estimators/), vectors of them, the GPU and the explanation of a pixel. Tracing the rays between the
// steps is the caller's.
//
// Glass is shaded by single rays only: the functions under "Refraction" are not compiled for vectors, whose
// caller hands the surfaces that light passes through to the code for one ray.
//
// Symbols as in shading/whitted.shared.h.

GLINT_SHARED_BEGIN

GLINT_FN truth is_dark(vec3 light) { return light.x == 0.0f && light.y == 0.0f && light.z == 0.0f; }

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

/// What a light sends to the surface where nothing stands between. A directional light's distance is
/// infinite.
GLINT_FN LightArrival light_arrival(GLINT_IN(LightRecord) light, GLINT_IN(SurfaceRecord) s) {
    vec3 n = s.n * s.lit_side;
    vec3 n_g = s.n_g * s.lit_side;
    vec3 strength = vec3(light.strength);
    LightArrival arrival;
    if (light.kind == light_directional) {
        arrival.direction = vec3(-light.direction);
        arrival.distance = infinite_t();
        arrival.cosine = light_cosine(n, n_g, arrival.direction);
        arrival.arriving = directional_light_arriving(strength, arrival.cosine);
        return arrival;
    }
    arrival = arrival_from_point(vec3(light.position), strength, s.p, n, n_g);
    if (light.kind == light_spot) {
        real cos_angle = -dot(arrival.direction, vec3(light.direction));
        arrival.arriving = arrival.arriving * spot_falloff(cos_angle, light.cos_outer, light.cos_inner);
    }
    return arrival;
}

/// True where light arrives and the material shows it: only then is a shadow ray sent.
GLINT_FN truth is_worth_shadow_ray(GLINT_IN(MaterialRecord) m, GLINT_IN(LightArrival) arrival) {
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

/// The cosine of the highlight's lobe.
GLINT_FN real highlight_cosine(GLINT_IN(WhittedModes) modes, vec3 n, vec3 l, vec3 v) {
    if (modes.highlight == highlight_blinn) return blinn_cosine(n, l, v);
    return phong_cosine(n, l, v);
}

/// What the surface shows of one light.
struct ShownLight {
    vec3 diffuse;
    vec3 highlight;
};

/// `passing` is the share of the light that passes what the shadow ray met.
GLINT_FN ShownLight shown_light(GLINT_IN(WhittedModes) modes, GLINT_IN(SurfaceRecord) s,
                                GLINT_IN(MaterialRecord) m, GLINT_IN(LightArrival) arrival, real passing) {
    ShownLight shown;
    shown.diffuse = vec3(0.0f);
    shown.highlight = vec3(0.0f);
    truth lit = passing > 0.0f && !is_dark(arrival.arriving);
    if (!any_lane(lit)) return shown;
    vec3 diffuse = diffuse_term(arrival.arriving, s.color, m.diffuse) * passing;
    if (modes.clamp != 0) diffuse = limit_to_one(diffuse);
    shown.diffuse = pick(lit, diffuse, vec3(0.0f));

    truth glossy = lit && m.highlight > 0.0f;
    if (!any_lane(glossy)) return shown;
    real lobe = lobe_of(highlight_cosine(modes, s.n * s.lit_side, arrival.direction, s.v), m.shininess);
    vec3 highlight = highlight_term(arrival.arriving, m.highlight, lobe) * passing;
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

/// Without the lights.
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

/// With the sum of all lights limited to 1 where the model clamps.
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

/// True where the surface reflects or transmits. Where its bounces are followed, the local terms weigh
/// local_weight(), else 1.
GLINT_FN truth has_bounces(GLINT_IN(MaterialRecord) m) {
    return m.reflectivity > 0.0f || m.transparency > 0.0f;
}

GLINT_FN real local_weight(GLINT_IN(WhittedModes) modes, GLINT_IN(MaterialRecord) m) {
    return local_weight(m.reflectivity, m.transparency, modes.balanced != 0);
}

GLINT_FN SpawnedRay reflected_ray(GLINT_IN(SurfaceRecord) s) {
    return spawn_ray(s, mirror_ray_direction(s.v, s.n, s.n_g));
}

#ifndef GLINT_LANES
// ── Refraction

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

/// By the shading normal, unless the viewer is below that or the refracted ray would stay above the surface:
/// then by the geometric normal.
GLINT_FN Refraction refraction_at(GLINT_IN(SurfaceRecord) s, real eta) {
    if (dot(s.n, s.v) > 0.0f) {
        Refraction r = refraction_by(s.n, s.v, eta);
        if (r.total || dot(r.direction, s.n_g) < 0.0f) return r;
    }
    return refraction_by(s.n_g, s.v, eta);
}

/// How light is shared between the two rays that go on from a surface.
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

/// At the surface of a transparent solid: with Fresnel's equations where the material asks for them; the
/// mirror ray has both shares where the reflection is total.
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
