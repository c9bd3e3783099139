#pragma once
// The rays of an explained pixel as lines over the picture.

#include "projection.h"
#include "theme.h"
#include "ui_map.h"

#include "glint/explanation.h"

#include <vector>

namespace glint::viewer {

enum class LineKind { primary, reflected, refracted, lit, shadowed };
inline constexpr int line_kind_count = 5;

/// A ray of an explained sample, or one of its shadow rays.
struct RayId {
    int ray = 0;    ///< index into ExplainedSample::rays
    int light = -1; ///< index into its lights; −1: the ray itself

    friend bool operator==(const RayId&, const RayId&) = default;
};

struct RayLine {
    LineKind kind = LineKind::primary;
    RayId id;
    Vec3 from{0};
    Vec3 to{0};
    bool open = false; ///< continues beyond `to`: it hit nothing, or its light is infinitely far away
};

/// The lines of one sample, whose positions are relative to `origin`. Open ones are `open_length` long.
std::vector<RayLine> ray_lines(const ExplainedSample& sample, const Vec3& origin, double open_length);

LineKind kind_of(const ExplainedRay& ray);
LineKind kind_of(const ExplainedLight& light);

/// How lines, trees and legends show a kind.
struct LineStyle {
    const char* name;
    Tint tint;
};
const LineStyle& style_of(LineKind kind);

/// Draws lines over `picture`, the area of the projection's `width` × `height` pixels; the selected one is
/// thicker. Returns how many are visible.
int draw_lines(const Area& picture, const Projection& projection, int width, int height,
               const std::vector<RayLine>& lines, const RayId& selected);

} // namespace glint::viewer
