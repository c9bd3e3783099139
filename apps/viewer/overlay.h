#pragma once
// Draws over the picture: rays of the explained pixel, messages, the list of keys.

#include "projection.h"
#include "ray_lines.h"
#include "widgets.h"

#include "glint/error.h"

#include <string>
#include <vector>

namespace glint::viewer {

/// Draws lines over `picture`, the area of the projection's `width` × `height` pixels; the selected one is
/// thicker. Returns how many are visible.
int draw_rays(const Area& picture, const Projection& projection, int width, int height,
              const std::vector<RayLine>& lines, const RayId& selected);

/// A circle around the explained pixel, at fractions of the picture's width and height.
void draw_mark(const Ui& ui, const Area& picture, double u, double v);

/// Errors of the file along the top of `space`, with the lines they are in. `footer`: what the picture shows
/// meanwhile.
void draw_errors(Ui& ui, const Area& space, const std::vector<Diagnostic>& errors, const std::string& footer);

/// The progress of loading, in the middle. A negative fraction is unknown. True if Cancel was pressed.
bool draw_loading(Ui& ui, const Area& space, const std::string& activity, double fraction);

/// A line in the middle of an empty space.
void draw_hint(Ui& ui, const Area& space, const std::string& text);

/// A small label in a corner of the picture.
void draw_label(Ui& ui, const Area& area, const std::string& text, bool at_right);

/// A line at the bottom of the picture.
void draw_notice(Ui& ui, const Area& space, const std::string& text, float opacity);

/// All keys and gestures, scrolling if the window is too small. False once it is closed.
bool draw_help(Ui& ui, const Area& window);

} // namespace glint::viewer
