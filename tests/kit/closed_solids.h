#pragma once
// Scenes within and around every kind of closed solid, whose light is known exactly unless a ray leaks.

#include "gallery.h"

namespace glint::kit {

/// Seen from inside each solid, whose walls are mirrors: black everywhere, though the sky is white.
std::vector<Exhibit> mirror_rooms();

/// Each solid as glass of index 1 before a white sky: white everywhere.
std::vector<Exhibit> invisible_solids();

} // namespace glint::kit
