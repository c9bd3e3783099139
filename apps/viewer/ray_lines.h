#pragma once
// The rays of an explained pixel as lines in the scene.

#include "theme.h"

#include "glint/explanation.h"
#include "glint/scene.h"

#include <vector>

namespace glint::viewer {

enum class LineKind { primary, reflected, refracted, lit, shadowed };
inline constexpr int line_kind_count = 5;

/// In the explanation: a ray of the sample, and one of its lights or −1.
struct RayPlace {
    int ray = 0;
    int light = -1;

    friend bool operator==(const RayPlace&, const RayPlace&) = default;
};

struct RayLine {
    LineKind kind = LineKind::primary;
    RayPlace place;
    Vec3 from{0};
    Vec3 to{0};
    bool open = false; ///< it goes on beyond `to`: it met nothing, or its light is infinitely far
};

/// The lines of one sample. Open ones are drawn `reach` long.
std::vector<RayLine> ray_lines(const ExplainedSample& sample, double reach);

LineKind kind_of(const ExplainedRay& ray);
LineKind kind_of(const ExplainedLight& light);
/// "reflected ray", "light arrives", …
const char* line_name(LineKind kind);
/// Each kind has a colour of its own, in lines, trees and legends alike.
Tint line_tint(LineKind kind);

} // namespace glint::viewer
