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
    real diffuse;      ///< k_d
    vec3 absorption;   ///< σ, per unit of length
    real highlight;    ///< k
    real shininess;    ///< m
    real reflectivity; ///< ρ
    real transparency; ///< τ
    real index;        ///< of refraction
    integer flags;     ///< bits: material_fresnel, …
    // What follows is read as light paths need it (shading/bsdf.shared.h). What precedes is the reading by
    // Whitted's model of all models of materials.
    integer model; ///< model_whitted, …
    real roughness;
    real opacity;
    vec3 metal_n; ///< the index of refraction of a metal, n + k i
    real metallic;
    vec3 metal_k;
    real transmission;
    vec3 specular_color;
    real specular;
    vec3 sheen_color; ///< times its strength
    real sheen_roughness;
    vec3 reflected_tint; ///< of the highlight and the mirror ray, by Whitted's model
    real clearcoat;
    vec3 transmitted_tint; ///< of the refracted ray, by Whitted's model
    real clearcoat_roughness;
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
    use(m.reflected_tint.x);
    use(m.reflected_tint.y);
    use(m.reflected_tint.z);
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
const int material_front = 2;   ///< emits from its front alone
const int material_metal = 4;   ///< a conductor with metal_n and metal_k; else one with a colour

// MaterialRecord::model
const int model_whitted = 0;
const int model_diffuse = 1;
const int model_conductor = 2;
const int model_dielectric = 3;
const int model_plastic = 4;
const int model_principled = 5;

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
              offsetof(MaterialRecord, metal_n) == 80 && sizeof(MaterialRecord) == 176);
static_assert(offsetof(LightRecord, direction) == 16 && offsetof(LightRecord, strength) == 32 &&
              sizeof(LightRecord) == 48);
static_assert(sizeof(WhittedModes) == 16);
#endif

#endif
GLINT_SHARED_END
#endif
