#pragma once
// The explanation of a pixel as a value: for each sample its ray tree, and for each ray every term of the
// light model with its formula, operands and result. Made by explain() (glint/explain.h); written as text,
// JSON, SVG and HTML by glint/formats.h. docs/explain.md describes the numbers.

#include "glint/error.h"
#include "glint/term.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace glint {

/// A pixel of a picture: (0, 0) is top left.
struct PixelCoord {
    int x = 0; ///< from the left
    int y = 0; ///< from the top
};

enum class RayKind { primary, reflected, refracted };
template <>
inline constexpr NamesUpTo<RayKind::refracted> enum_names<RayKind>{"primary", "reflected", "refracted"};

/// How a path ends.
enum class RayEnd {
    bounced,     ///< it continues in one or two branches
    matte,       ///< the surface neither reflects nor transmits
    depth_limit, ///< maximum depth reached
    background,  ///< nothing was hit
    absorbed,    ///< nothing was hit from inside a solid: no light returns
    min_weight,  ///< its branches carry too little light to be followed
};
template <>
inline constexpr NamesUpTo<RayEnd::min_weight> enum_names<RayEnd>{"bounced",    "matte",    "depth_limit",
                                                                  "background", "absorbed", "min_weight"};

inline const char* ray_kind_name(RayKind kind) { return name_of(kind).data(); }
inline const char* ray_end_name(RayEnd end) { return name_of(end).data(); }

/// A number or a vector of three: colour, point or direction.
struct Quantity {
    Quantity() = default;
    Quantity(float number) : value(number, 0, 0), vector(false) {}   // NOLINT: implicit by intention
    Quantity(const glm::vec3& three) : value(three), vector(true) {} // NOLINT

    glm::vec3 value{0.0f}; ///< a number is stored in x
    bool vector = false;
};

/// One step of the calculation: a given quantity, or the result of a formula over preceding ones. Formulas
/// use mathematical notation and can be evaluated: + − · / ⊙ | | √ ² ^, max, min, normalize, arccos and
/// arcsin (degrees). a·b is the dot product of two vectors and otherwise a product; ⊙ multiplies by channel.
/// Evaluated in float from left to right, they give `result` bit for bit.
struct Step {
    std::string symbol;  ///< "E", "cosθ", "diffuse": unique within its light or ray
    std::string formula; ///< such as "I · (cosθ / r²)"; empty for given quantities
    Quantity result;
    const char* topic = "";   ///< what it belongs to: a term's name, "shadow", "refraction", "weight" …
    const char* meaning = ""; ///< "light arriving"
    const char* section = ""; ///< section of the report, such as "2.2"; empty if the report does not cover it
    const char* note = "";    ///< where the model adds or omits something, or why this formula is used
};

/// A surface crossed by a shadow ray.
struct Blocker {
    std::uint32_t object = 0; ///< index in SceneDescription::objects
    std::uint32_t number = 0; ///< within its type of table
    std::string label;        ///< object_label()
    std::string material;     ///< name
    float distance = 0;       ///< from the shaded point
    float transparency = 0;   ///< τ of its material
    float share = 0;          ///< transmitted fraction: τ, 0 with opaque shadows, or 1 if passed over
    bool passed_over = false; ///< hidden inside a solid that owns the space, so it has no effect
};

/// A light at a hit and its shadow ray, as traced.
struct TracedLight {
    glm::vec3 direction{0.0f}; ///< unit, to the light
    float distance = 0;        ///< infinite for directional lights
    float cosine = 0;          ///< n·l, 0 below the geometric horizon
    glm::vec3 arriving{0.0f};  ///< E before shadows
    bool asked = false; ///< whether a shadow ray was traced: not if no light arrives or none would be visible
    glm::vec3 shadow_origin{0.0f};
    std::vector<Blocker> blockers; ///< in order of distance, up to the light
    float shadow = 1;              ///< transmitted fraction
    glm::vec3 diffuse{0.0f};       ///< after shadow and clamp
    glm::vec3 highlight{0.0f};
};

struct ExplainedLight : TracedLight {
    std::uint32_t light = 0; ///< index in SceneDescription::lights
    std::string label;       ///< light_label()
    Location where;
    float degrees = 0;     ///< angle between normal and light
    float attenuation = 1; ///< 1/r², times the spot's falloff; 1 for directional lights
    std::vector<Step> steps;
};

/// A ray and its hit, as traced. Children and parent are indices into the rays of its sample, −1 for none.
struct TracedRay {
    RayKind kind = RayKind::primary;
    RayEnd end = RayEnd::matte;
    int parent = -1;
    int reflected = -1;
    int refracted = -1;
    int left_out = 0; ///< branches below min_weight, which were not followed
    int depth = 0;    ///< number of bounces before it
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f};     ///< unit
    glm::vec3 transmittance{1.0f}; ///< of the path to the hit
    glm::vec3 radiance{0.0f};      ///< along the ray: the sum of its terms

    // Valid if something was hit:
    glm::vec3 position{0.0f};
    glm::vec3 geometric_normal{0.0f}; ///< toward the viewer
    glm::vec3 shading_normal{0.0f};
    glm::vec3 color{0.0f};
    bool entering = true; ///< hit from outside the object

    // Valid at the surface of a transparent solid:
    float index_before = 1; ///< n₁
    float index_after = 1;  ///< n₂
    bool total_reflection = false;
};

struct ExplainedRay : TracedRay {
    std::string why;        ///< `end` as a sentence
    glm::vec3 weight{1.0f}; ///< contribution to the sample of unit radiance along the ray

    bool hit = false;         ///< the following fields up to `lights` are valid only if something was hit
    std::uint32_t object = 0; ///< index in SceneDescription::objects
    std::uint32_t number = 0; ///< within its type of table
    std::string label;        ///< object_label()
    Location where;
    std::string material; ///< name
    float distance = std::numeric_limits<float>::infinity();
    float gain = 0; ///< (1 − τ) · max(c) · k_d + ρ + τ: above 1, more light leaves than arrives
    std::vector<ExplainedLight> lights; ///< all lights except ambient ones, in file order
    /// refraction at the surface of a solid was computed; the following fields are valid:
    bool crosses = false;
    float degrees_before = 0;    ///< θ₁, to the normal
    float degrees_after = 0;     ///< θ₂; 90 for total reflection
    float critical_degrees = 90; ///< angle of total reflection; 90: never

    std::vector<std::string> inside; ///< labels of the solids around the ray, the owner of the space first
    /// surfaces skipped because they are hidden inside a solid that owns the space
    std::vector<std::string> passed_over;
    std::vector<Step> given;                   ///< given quantities of the scene and the hit
    std::vector<Step> steps;                   ///< terms, branches and their sum, after the lights' own steps
    std::array<glm::vec3, term_count> terms{}; ///< by Term; weighted, including absorption
};

/// One sample of the pixel.
struct ExplainedSample {
    float dx = 0;     ///< pixels to the right of the pixel's centre
    float dy = 0;     ///< pixels below the pixel's centre
    float weight = 1; ///< +1, or −1 where the pixel filter is negative
    /// false for negative samples that are ignored because there are few (docs/explain.md)
    bool counts = true;
    std::array<glm::vec3, term_count> terms{};
    glm::vec3 radiance{0.0f};
    std::vector<ExplainedRay> rays; ///< the first is the primary ray; parents precede their children
};

/// The pixel as rendered by a graphics card.
struct OtherPixel {
    std::string device;
    glm::vec3 color{0.0f}; ///< linear RGB
};

/// The explanation of a pixel. `color` equals the pixel of the float picture rendered by the CPU, bit for
/// bit.
struct Explanation {
    int x = 0; ///< from the left
    int y = 0; ///< from the top
    int width = 0;
    int height = 0;
    /// What must be added to positions here for those of the scene: zero, unless that lies far from zero
    /// compared with its size and is traced about a point of its own.
    glm::dvec3 origin{0};
    std::string scene;  ///< name of the scene, such as its file; empty unless set by the caller
    std::string filter; ///< such as "mitchell"; unused with one sample, which is at the pixel's centre
    std::string rule;   ///< how samples are combined, as a sentence
    std::vector<ExplainedSample> samples;
    std::array<glm::vec3, term_count> terms{}; ///< by Term; their sum in order is `color`
    glm::vec3 color{0.0f};                     ///< linear RGB
    std::optional<OtherPixel> gpu; ///< for comparison, if the caller has rendered it on a graphics card
};

} // namespace glint
