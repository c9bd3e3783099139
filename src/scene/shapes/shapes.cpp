#include "scene/shapes/shapes.h"

namespace glint {

bool is_solid(const Shape& shape) {
    return std::visit([](const auto& s) { return scene::has_inside(s); }, shape);
}

} // namespace glint
