// Lines from rays and shadow rays, with their names and colours.
#include "ray_lines.h"

#include <algorithm>
#include <cmath>

namespace glint::viewer {

LineKind kind_of(const ExplainedRay& ray) {
    switch (ray.kind) {
    case RayKind::reflected:
        return LineKind::reflected;
    case RayKind::refracted:
        return LineKind::refracted;
    case RayKind::primary:
        break;
    }
    return LineKind::primary;
}

LineKind kind_of(const ExplainedLight& light) {
    return light.shadow > 0 && light.cosine > 0 ? LineKind::lit : LineKind::shadowed;
}

std::vector<RayLine> ray_lines(const ExplainedSample& sample, double open_length) {
    std::vector<RayLine> lines;
    for (std::size_t i = 0; i < sample.rays.size(); ++i) {
        const ExplainedRay& ray = sample.rays[i];
        const int number = static_cast<int>(i);
        const Vec3 from(ray.origin);
        const Vec3 to = ray.hit ? Vec3(ray.position) : from + Vec3(ray.direction) * open_length;
        lines.push_back({kind_of(ray), {number, -1}, from, to, !ray.hit});
        for (std::size_t j = 0; j < ray.lights.size(); ++j) {
            const ExplainedLight& light = ray.lights[j];
            if (!light.asked) continue;
            // A blocked shadow ray ends at its blocker; one to a directional light is open.
            double length = light.distance;
            for (const Blocker& blocker : light.blockers)
                if (blocker.share <= 0) length = std::min<double>(length, blocker.distance);
            const bool open = !std::isfinite(length);
            const Vec3 start(ray.position);
            lines.push_back({kind_of(light),
                             {number, static_cast<int>(j)},
                             start,
                             start + Vec3(light.direction) * (open ? open_length : length),
                             open});
        }
    }
    return lines;
}

const char* line_name(LineKind kind) {
    switch (kind) {
    case LineKind::primary:
        return "from the eye";
    case LineKind::reflected:
        return "reflected";
    case LineKind::refracted:
        return "refracted";
    case LineKind::lit:
        return "light arrives";
    case LineKind::shadowed:
        break;
    }
    return "in shadow";
}

Tint line_tint(LineKind kind) {
    switch (kind) {
    case LineKind::primary:
        return {0.92f, 0.92f, 0.95f};
    case LineKind::reflected:
        return {0.36f, 0.68f, 1.0f};
    case LineKind::refracted:
        return {0.30f, 0.85f, 0.52f};
    case LineKind::lit:
        return {1.0f, 0.82f, 0.25f};
    case LineKind::shadowed:
        break;
    }
    return {0.86f, 0.36f, 0.40f};
}

} // namespace glint::viewer
