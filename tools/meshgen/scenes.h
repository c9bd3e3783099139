#pragma once
// Scene files with too many objects to write by hand, as text.

#include <string>

namespace glint::meshgen {

/// Sphere flake: each sphere carries nine of a third of its size, `levels` times.
std::string sphere_flake_scene(int levels);

/// A city of cylinders at dusk: towers on `rings` concentric rings.
std::string city_scene(int rings);

/// A sunflower head of `count` instances of one mesh, meshes/shell.ply.
std::string spiral_scene(int count);

} // namespace glint::meshgen
