#pragma once
// Scene files with too many objects to be written by hand, as text.

#include <string>

namespace glint::meshgen {

/// Spheres on spheres: each carries nine of a third of its size, `levels` times.
std::string sphere_flake_scene(int levels);

/// A city of cylinders at dusk: towers on `rings` rings about the middle.
std::string city_scene(int rings);

/// A sunflower's head of `count` instances of one mesh, meshes/shell.ply.
std::string spiral_scene(int count);

} // namespace glint::meshgen
