// Fixed heights and widths, scaled for the screen.
#include "layout.h"

#include <algorithm>
#include <cmath>

namespace glint::viewer {

Layout lay_out(const WindowSize& window, float scale, bool panel, bool timeline) {
    const auto width = static_cast<float>(window.width);
    const auto height = static_cast<float>(window.height);
    const float status_height = std::round(28 * scale);
    // The picture keeps at least half of a narrow window.
    const float panel_width = panel ? std::round(std::min(372 * scale, width / 2)) : 0;
    const float timeline_height = timeline ? std::round(44 * scale) : 0;
    const float below = status_height + timeline_height;
    Layout layout;
    layout.space = {0, 0, width - panel_width, std::max(height - below, 1.0f)};
    layout.timeline = {0, height - below, width - panel_width, timeline_height};
    layout.panel = {width - panel_width, 0, panel_width, height - status_height};
    layout.status = {0, height - status_height, width, status_height};
    return layout;
}

Area fit(const Area& space, double width, double height, float pixels_per_unit) {
    const double ratio = pixels_per_unit;
    const double factor = std::min(space.width / width, space.height / height);
    const auto whole = [&](double units) {
        return static_cast<float>(std::max(1.0, std::round(units * ratio)) / ratio);
    };
    Area area;
    area.width = whole(width * factor);
    area.height = whole(height * factor);
    area.x = static_cast<float>(std::floor((space.x + (space.width - area.width) / 2) * ratio) / ratio);
    area.y = static_cast<float>(std::floor((space.y + (space.height - area.height) / 2) * ratio) / ratio);
    return area;
}

} // namespace glint::viewer
