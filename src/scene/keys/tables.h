#pragma once
// The key tables, one function for each struct that keys describe.

#include "glint/keys.h"

namespace glint::scene::keys {

TableSpec camera_table();
TableSpec render_table();
TableSpec whitted_table();
TableSpec path_table();
TableSpec ambient_occlusion_table();
TableSpec material_table();
TableSpec light_table();

/// Of each alternative of Shape: its own keys.
template <class ShapeType>
TableSpec shape_table();

/// The tables of all alternatives of Shape, in their order, with the keys that every object has.
std::vector<TableSpec> object_tables();

} // namespace glint::scene::keys
