#ifndef GLINT_SHADING_RECORDS_SHARED_H
#define GLINT_SHADING_RECORDS_SHARED_H
#include "math/shared.h"
#ifndef GLINT_GLSL
#include <cstddef>
#endif

// Materials, lights and surfaces as shading sees them. Each vec3 of a MaterialRecord or LightRecord is
// followed by a scalar of four bytes, so that arrays of them have the same bytes in C++ and in GLSL's buffers
// (std430).

GLINT_SHARED_BEGIN

struct MaterialRecord {
    vec3 color;   ///< c
    real ambient; ///< k_a
    vec3 emission;
    real diffuse;        ///< k_d
    vec3 absorption;     ///< σ, per unit of length
    real highlight;      ///< k
    real shininess;      ///< m
    real reflectivity;   ///< ρ
    real transparency;   ///< τ
    real index;          ///< of refraction
    integer flags;       ///< bits: material_fresnel
    integer model;       ///< model_whitted, …; read by path tracers
    integer reserved[2]; ///< 0; std430 rounds the size up to a multiple of 16 bytes
};

#ifndef GLINT_GLSL
/// Calls use() for the numbers of a material, for one ray or for a vector of them, that the steps for vectors
/// of rays need for each light.
template <class Material, class Use>
constexpr GLINT_FN void for_shading_numbers(Material& m, const Use& use) {
    use(m.diffuse);
    use(m.highlight);
    use(m.shininess);
    use(m.reflectivity);
    use(m.transparency);
}
#endif

/// A hit, ready to be shaded.
struct SurfaceRecord {
    vec3 p;
    vec3 p_error;  ///< absolute bound, per axis
    vec3 v;        ///< to the viewer
    vec3 n_g;      ///< geometric normal toward the viewer
    vec3 n;        ///< shading normal on the side of n_g
    vec3 color;    ///< the material's, or interpolated from a mesh's vertices
    real lit_side; ///< 1; −1: lights find both normals turned away from the viewer (Facing::stored)
};

// Vectors of rays have MaterialRecord and SurfaceRecord as vectors, but share what follows with single rays:
// a light or a setting is one for all of them.
#ifndef GLINT_LANES

// MaterialRecord::flags
const int material_fresnel = 1; ///< Fresnel's equations share the light between reflection and transmission

// MaterialRecord::model
const int model_whitted = 0;
const int model_diffuse = 1;

// LightRecord::kind
const int light_point = 0;
const int light_directional = 1;
const int light_spot = 2;

struct LightRecord {
    vec3 position; ///< of a point or spot light
    int kind;
    vec3 direction;  ///< unit, the way a directional or spot light travels
    float cos_outer; ///< of a spot light's cones
    vec3 strength;   ///< colour × intensity, or × irradiance of a directional light
    float cos_inner;
};

// WhittedModes::highlight
const int highlight_blinn = 0;
const int highlight_phong = 1;

/// The settings of the light model for its steps; 0 or 1 unless noted.
struct WhittedModes {
    int opaque_shadows; ///< 0: light passes glass, unbent
    int clamp;          ///< limit each light's diffuse light, and the local sum, to 1 a channel
    int balanced;       ///< weight local light so that no more leaves than arrives
    int highlight;      ///< highlight_blinn or highlight_phong
};

#ifndef GLINT_GLSL
static_assert(offsetof(MaterialRecord, emission) == 16 && offsetof(MaterialRecord, absorption) == 32 &&
              offsetof(MaterialRecord, shininess) == 48 && offsetof(MaterialRecord, flags) == 64 &&
              sizeof(MaterialRecord) == 80);
static_assert(offsetof(LightRecord, direction) == 16 && offsetof(LightRecord, strength) == 32 &&
              sizeof(LightRecord) == 48);
static_assert(sizeof(WhittedModes) == 16);
#endif

#endif
GLINT_SHARED_END
#endif
