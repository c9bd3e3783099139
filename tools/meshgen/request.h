#pragma once
// What the command line of glint-meshgen asks for.

#include "glint/formats.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::meshgen {

enum class Kind { gyroid, knot, torus, shell, icosphere, terrain, flake, city, spiral };

struct Request {
    Kind kind = Kind::gyroid;
    std::string output;        ///< meshes: required; scenes: empty is stdout
    double triangles = 100000; ///< about as many as the mesh shall have
    bool colors = false;
    bool flat = false; ///< leave the normals out
    PlyFormat format = PlyFormat::binary_little_endian;
    int p = 2;         ///< knot
    int q = 3;         ///< knot
    unsigned seed = 1; ///< terrain
    int levels = 3;    ///< flake
    int rings = 9;     ///< city
    int count = 1500;  ///< spiral
};

/// True for the kinds that are scene files.
bool is_scene(Kind kind);

/// The request, or nothing where help was asked for. Throws Error(usage) with what is wrong and what was
/// expected.
std::optional<Request> parse_request(const std::vector<std::string>& arguments);

/// What --help prints.
std::string help_text();

} // namespace glint::meshgen
