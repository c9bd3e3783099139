#pragma once
// Mesh files. Readers throw Error(input) with location, cause and cure; writers write the whole file or
// nothing and throw Error(output).

#include "glint/scene_files.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glint {

struct LoadedMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<Diagnostic> warnings;
};

/// Reads a PLY file: ASCII, binary little or big endian. A mesh far from zero compared with its size gets an
/// origin of its own, which is subtracted from its coordinates in double precision. Uses only `cancel` and
/// `progress` of the options.
LoadedMesh load_mesh(const std::string& path, const LoadOptions& options = {});

/// Reads a PLY file from memory; `name` is the file name for messages.
LoadedMesh parse_ply(std::span<const std::byte> bytes, const std::string& name,
                     const LoadOptions& options = {});

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
template <>
inline constexpr NamesUpTo<PlyFormat::binary_big_endian> enum_names<PlyFormat>{
    "ascii", "binary_little_endian", "binary_big_endian"};

/// Writes positions, normals, colours, texture coordinates and triangles as PLY; reading returns the same
/// bits. The coordinates of a mesh with an origin of its own are written in double precision.
void write_ply(const std::string& path, const Mesh& mesh, PlyFormat format = PlyFormat::binary_little_endian);

} // namespace glint
