#pragma once
// What is drawn over the picture: the rays of the explained pixel, messages, the list of keys.

#include "projection.h"
#include "ray_lines.h"
#include "widgets.h"

#include "glint/error.h"

#include <string>
#include <vector>

namespace glint::viewer {

/// Draws the lines over `picture`, which shows all of `width` × `height` pixels of the projection. The chosen
/// one stands out. Returns how many can be seen.
int draw_rays(const Area& picture, const Projection& projection, int width, int height,
              const std::vector<RayLine>& lines, const RayPlace& chosen);

/// A mark around the pixel that is explained.
void draw_mark(const Ui& ui, const Area& picture, double across, double down);

/// A stripe along the top of `space` that says what is wrong with the file, with the line it stands in.
/// `title`: what the picture shows meanwhile.
void draw_errors(Ui& ui, const Area& space, const std::vector<Diagnostic>& errors, const std::string& title);

/// A box in the middle: a file on its way in. A share below 0 is not known. True if Cancel was pressed.
bool draw_loading(Ui& ui, const Area& space, const std::string& what, double share);

/// A line in the middle, where there is nothing else to see.
void draw_hint(Ui& ui, const Area& space, const std::string& text);

/// A word in a small box at the picture's corner: which of two settings is shown there.
void draw_label(Ui& ui, const Area& area, const std::string& text, bool at_right);

/// A line at the bottom of the picture that says what was just done.
void draw_notice(Ui& ui, const Area& space, const std::string& text, float strength);

/// All keys and gestures, within the window; they scroll where it is too small. False once it is closed.
bool draw_help(Ui& ui, const Area& window);

} // namespace glint::viewer
