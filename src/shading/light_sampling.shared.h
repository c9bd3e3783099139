#ifndef GLINT_SHADING_LIGHT_SAMPLING_SHARED_H
#define GLINT_SHADING_LIGHT_SAMPLING_SHARED_H
#include "math/shared.h"
#include "shading/records.shared.h"
#include "shading/whitted.shared.h"

// Light that arrives from the lights of a scene, for path tracers.

GLINT_SHARED_BEGIN

const float pi_float = 3.14159265f;

/// Irradiance from a light without extent on a surface that faces it: π times Whitted's E, so that a surface
/// of albedo 1 shows E. (docs/light-model.md, "Paths".)
GLINT_FN vec3 facing_irradiance(GLINT_IN(LightRecord) light, GLINT_IN(LightArrival) arrival) {
    vec3 strength = vec3(light.strength) * pi_float;
    if (light.kind == light_directional) return strength;
    real squared = arrival.distance * arrival.distance;
    if (!(squared > 0.0f)) return vec3(0.0f);
    strength = strength / squared;
    if (light.kind != light_spot) return strength;
    real cos_angle = -dot(arrival.direction, vec3(light.direction));
    return strength * spot_falloff(cos_angle, light.cos_outer, light.cos_inner);
}

/// The weight of a sample drawn with density `own` > 0 that another way would have drawn with density
/// `other`: the power heuristic with exponent 2. (E. Veach, Robust Monte Carlo Methods for Light Transport
/// Simulation, 1997, section 9.2.4.)
GLINT_FN real mis_weight(real own, real other) {
    real ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

GLINT_SHARED_END
#endif
