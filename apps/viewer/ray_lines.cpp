// Lines from rays and shadow rays, and how they are drawn.
#include "ray_lines.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::viewer {
namespace {

/// By LineKind.
constexpr std::array<LineStyle, line_kind_count> styles{{{"from the eye", {0.92f, 0.92f, 0.95f}},
                                                         {"reflected", {0.36f, 0.68f, 1.0f}},
                                                         {"refracted", {0.30f, 0.85f, 0.52f}},
                                                         {"light arrives", {1.0f, 0.82f, 0.25f}},
                                                         {"in shadow", {0.86f, 0.36f, 0.40f}}}};

void add_arrow(ImDrawList& draw, const ImVec2& from, const ImVec2& to, ImU32 color, float size) {
    const float dx = to.x - from.x;
    const float dy = to.y - from.y;
    const float length = std::hypot(dx, dy);
    if (length < 2 * size) return;
    const ImVec2 along(dx / length * size, dy / length * size);
    draw.AddTriangleFilled({to.x + along.x * 0.4f, to.y + along.y * 0.4f},
                           {to.x - along.x - along.y * 0.6f, to.y - along.y + along.x * 0.6f},
                           {to.x - along.x + along.y * 0.6f, to.y - along.y - along.x * 0.6f}, color);
}

/// Open lines are dashed.
void add_segment(ImDrawList& draw, const ImVec2& from, const ImVec2& to, ImU32 color, float thickness,
                 bool open) {
    if (!open) {
        draw.AddLine(from, to, color, thickness);
        return;
    }
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const int dashes = std::clamp(static_cast<int>(length / 12), 1, 200);
    for (int i = 0; i < dashes; ++i) {
        const auto at = [&](float t) {
            return ImVec2(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t);
        };
        const float first = static_cast<float>(i) / static_cast<float>(dashes);
        draw.AddLine(at(first), at(first + 0.6f / static_cast<float>(dashes)), color, thickness);
    }
}

} // namespace

LineKind kind_of(const ExplainedRay& ray) {
    return ray.kind == RayKind::reflected   ? LineKind::reflected
           : ray.kind == RayKind::refracted ? LineKind::refracted
                                            : LineKind::primary;
}

LineKind kind_of(const ExplainedLight& light) {
    return light.shadow > 0 && light.cosine > 0 ? LineKind::lit : LineKind::shadowed;
}

const LineStyle& style_of(LineKind kind) { return styles[static_cast<std::size_t>(kind)]; }

std::vector<RayLine> ray_lines(const ExplainedSample& sample, const Vec3& origin, double open_length) {
    std::vector<RayLine> lines;
    for (std::size_t i = 0; i < sample.rays.size(); ++i) {
        const ExplainedRay& ray = sample.rays[i];
        const int number = static_cast<int>(i);
        const Vec3 from = origin + Vec3(ray.origin);
        const Vec3 to = ray.hit ? origin + Vec3(ray.position) : from + Vec3(ray.direction) * open_length;
        lines.push_back({kind_of(ray), {number, -1}, from, to, !ray.hit});
        for (std::size_t j = 0; j < ray.lights.size(); ++j) {
            const ExplainedLight& light = ray.lights[j];
            if (!light.asked) continue;
            // A blocked shadow ray ends at its blocker; one to a directional light is open.
            double length = light.distance;
            for (const Blocker& blocker : light.blockers)
                if (blocker.share <= 0) length = std::min<double>(length, blocker.distance);
            const bool open = !std::isfinite(length);
            const Vec3 start = origin + Vec3(ray.position);
            const Vec3 end = start + Vec3(light.direction) * (open ? open_length : length);
            lines.push_back({kind_of(light), {number, static_cast<int>(j)}, start, end, open});
        }
    }
    return lines;
}

int draw_lines(const Area& picture, const Projection& projection, int width, int height,
               const std::vector<RayLine>& lines, const RayId& selected) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const auto screen = [&](const PixelPoint& p) {
        return ImVec2(picture.x + static_cast<float>(p.x / width) * picture.width,
                      picture.y + static_cast<float>(p.y / height) * picture.height);
    };
    int visible = 0;
    for (const RayLine& line : lines) {
        const auto ends = projection.line(line.from, line.to);
        if (!ends) continue;
        const ImVec2 from = screen(ends->first);
        const ImVec2 to = screen(ends->second);
        // From its own camera the primary ray is a point.
        if (std::hypot(to.x - from.x, to.y - from.y) < 1.5f) continue;
        const float thickness = line.id == selected ? 3.5f : 1.75f;
        // A dark edge keeps lines visible on a bright picture.
        add_segment(draw, from, to, IM_COL32(0, 0, 0, 110), thickness + 2, line.open);
        const ImU32 color = ImGui::GetColorU32(color_of(style_of(line.kind).tint));
        add_segment(draw, from, to, color, thickness, line.open);
        add_arrow(draw, from, to, color, 4 + thickness);
        ++visible;
    }
    return visible;
}

} // namespace glint::viewer
