#pragma once
// The command line of glint-meshgen, and the mesh that it requests.

#include "glint/mesh_files.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::meshgen {

enum class Kind { gyroid, knot, torus, shell, icosphere, terrain, flake, city, spiral };

struct Request {
    Kind kind = Kind::gyroid;
    std::string output;        ///< required for meshes; for scenes, empty means stdout
    double triangles = 100000; ///< approximate number of triangles
    bool colors = false;
    bool flat = false; ///< omit normals
    PlyFormat format = PlyFormat::binary_little_endian;
    int p = 2;         ///< knot
    int q = 3;         ///< knot
    unsigned seed = 1; ///< terrain
    int levels = 3;    ///< flake
    int rings = 9;     ///< city
    int count = 1500;  ///< spiral
};

/// Whether a kind is a scene file rather than a mesh.
bool is_scene(Kind kind);

/// Parses the command line; returns nothing if help was asked for. Throws Error(usage).
std::optional<Request> parse_request(const std::vector<std::string>& arguments);

/// The mesh of a request, with normals and colours if requested.
Mesh make_mesh(const Request& request);

} // namespace glint::meshgen
