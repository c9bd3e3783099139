#pragma once
// Why a pixel has its colour, as a value: for each sample of the pixel its ray tree, and for each ray every
// term of the light model with its formula, the numbers in it and what comes out. Made by explain()
// (glint/explain.h), written as text, JSON, SVG and HTML by glint/formats.h. docs/explain.md says what the
// numbers mean.

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

/// Why a ray's way ends where it does.
enum class RayEnd {
    bounced,     ///< it goes on in one or two branches
    matte,       ///< the surface neither reflects nor transmits
    depth_limit, ///< no more bounces allowed
    background,  ///< nothing was hit
    absorbed,    ///< nothing was hit from inside a solid: nothing comes back
};

/// "primary", "reflected", "refracted".
const char* ray_kind_name(RayKind kind);
/// "bounced", "matte", "depth_limit", "background", "absorbed".
const char* ray_end_name(RayEnd end);

/// A number or a vector of three: a colour, a place, a direction.
struct Quantity {
    Quantity() = default;
    Quantity(float number) : value(number, 0, 0), vector(false) {}   // NOLINT: both read as values
    Quantity(const glm::vec3& three) : value(three), vector(true) {} // NOLINT

    glm::vec3 value{0.0f}; ///< a number stands in x
    bool vector = false;
};

/// One line of the working: a quantity that is given, or what a formula makes of those before it.
///
/// Formulas are written as people write them and can be evaluated as they stand: + − · / ⊙ | | √ ² ^, max,
/// min, normalize, arccos and arcsin (degrees). a·b is the dot product of two vectors and a product
/// otherwise; ⊙ multiplies channel by channel. Evaluated in float from left to right they give `result` to
/// the bit.
struct Step {
    std::string symbol;  ///< "E", "cosθ", "diffuse": unique within its light and ray
    std::string formula; ///< "I · (cosθ / r²)"; empty: given
    Quantity result;
    const char* topic = "";   ///< what it belongs to: a term's name, "shadow", "refraction", "weight" …
    const char* meaning = ""; ///< "light arriving"
    const char* section = ""; ///< of the report: "2.2"; empty where the report is silent
    const char* note = ""; ///< where the model invents or omits something, or why this formula and no other
};

/// A surface on the way of a shadow ray.
struct Blocker {
    std::uint32_t object = 0; ///< index in SceneDescription::objects
    std::string label;        ///< sphere "ball"
    std::string material;     ///< name
    float distance = 0;       ///< from the point that is lit
    float transparency = 0;   ///< τ of its material
    float share = 0; ///< what it lets through: τ, or 0 where shadows are opaque, or 1 if passed over
    bool passed_over = false; ///< hidden inside a solid that owns the space: it does not count
};

/// One light at one hit, with its shadow ray.
struct ExplainedLight {
    std::uint32_t light = 0;   ///< index in SceneDescription::lights
    std::string label;         ///< point light 1 (numbers count all lights, from 1)
    glm::vec3 direction{0.0f}; ///< unit, to the light
    float distance = 0;        ///< infinite for directional lights
    float cosine = 0;          ///< n·l, 0 below the geometric horizon
    float degrees = 0;         ///< angle between normal and light
    float attenuation = 1;     ///< 1/r², times the spot's falloff; 1 for directional lights
    glm::vec3 arriving{0.0f};  ///< E, before shadows
    bool asked = false;        ///< was a shadow ray sent? Not where nothing arrives or nothing would be shown
    glm::vec3 shadow_origin{0.0f};
    std::vector<Blocker> blockers; ///< in the order of the way, up to the light
    float shadow = 1;              ///< the share that gets through
    glm::vec3 diffuse{0.0f};       ///< after shadow and clamp
    glm::vec3 highlight{0.0f};
    std::vector<Step> steps;
};

/// One ray with what it met. Children and parent are indices into ExplainedSample::rays, −1 for none.
struct ExplainedRay {
    RayKind kind = RayKind::primary;
    RayEnd end = RayEnd::matte;
    std::string why; ///< `end` in a sentence
    int parent = -1;
    int reflected = -1;
    int refracted = -1;
    int depth = 0; ///< bounces before it
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f}; ///< unit
    glm::vec3 weight{1.0f};    ///< what a light of 1 along it adds to the sample

    bool hit = false; ///< the rest up to `lights` holds where something was hit
    std::uint32_t object = 0;
    std::string label;    ///< sphere "ball", or sphere #3 (numbers count all objects, from 1)
    std::string material; ///< name
    float distance = std::numeric_limits<float>::infinity();
    glm::vec3 position{0.0f};
    glm::vec3 geometric_normal{0.0f}; ///< toward the viewer
    glm::vec3 shading_normal{0.0f};
    glm::vec3 color{0.0f};
    bool entering = true; ///< hit from the object's outer side
    float gain = 0;       ///< (1 − τ) · max(c) · k_d + ρ + τ: above 1, more light leaves than arrives
    std::vector<ExplainedLight> lights; ///< all but ambient ones, in the order of the file
    bool crosses = false;               ///< the light's way through the surface of a solid was asked for:
    float index_before = 1;             ///< n₁
    float index_after = 1;              ///< n₂
    float degrees_before = 0;           ///< θ₁, to the normal
    float degrees_after = 0;            ///< θ₂; 90 and meaningless where the reflection is total
    float critical_degrees = 90;        ///< beyond it the reflection is total; 90: never
    bool total_reflection = false;

    std::vector<std::string>
        inside; ///< labels of the solids around the ray's way, the owner of the space first
    std::vector<std::string> passed_over; ///< surfaces on the way hidden inside a solid that owns the space
    glm::vec3 transmittance{1.0f};        ///< what absorption on the way leaves
    std::vector<Step> given;              ///< what the scene and the hit say
    std::vector<Step> steps;              ///< terms, branches, their sum; after the lights' own
    std::array<glm::vec3, term_count> terms{}; ///< by Term; weighted, absorption included
    glm::vec3 radiance{0.0f};                  ///< their sum: what comes back along the ray
};

/// One sample of the pixel.
struct ExplainedSample {
    float dx = 0;       ///< pixels from the pixel's centre, to the right
    float dy = 0;       ///< pixels from the pixel's centre, downward
    float weight = 1;   ///< +1, or −1 where the pixel filter is negative
    bool counts = true; ///< negative samples are left out where there are few (docs/explain.md)
    std::array<glm::vec3, term_count> terms{};
    glm::vec3 radiance{0.0f};
    std::vector<ExplainedRay> rays; ///< the first is the primary ray; parents stand before their children
};

/// The same pixel as a graphics card renders it.
struct OtherPixel {
    std::string device;
    glm::vec3 color{0.0f}; ///< linear RGB
};

/// One pixel. `color` is the pixel of the float picture that the CPU renders, to the bit.
struct Explanation {
    int x = 0; ///< from the left
    int y = 0; ///< from the top
    int width = 0;
    int height = 0;
    std::string scene;  ///< what to call the scene: its file; empty unless the caller names it
    std::string filter; ///< "mitchell" …; of no effect with one sample, which is the pixel's centre
    std::string rule;   ///< how the samples make the pixel, in a sentence
    std::vector<ExplainedSample> samples;
    std::array<glm::vec3, term_count> terms{}; ///< by Term; their sum in order is `color`
    glm::vec3 color{0.0f};                     ///< linear RGB
    std::optional<OtherPixel> gpu; ///< to be told beside it, where the caller has rendered it there
};

} // namespace glint
