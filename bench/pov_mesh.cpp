// glint-pov-mesh IN.ply OUT.ply OUT.inc: writes a mesh with z up, size 24, and centred in the report's room
// as PLY for glint and as `room_mesh` for POV-Ray. Drops normals and colours.

#include "glint/mesh_files.h"
#include "math/bounds.h"

#include <algorithm>
#include <fstream>
#include <iostream>

namespace {

void write_povray(const std::string& path, const glint::Mesh& mesh) {
    std::ofstream out(path);
    out.precision(9);
    out << "#declare room_mesh = mesh2 {\nvertex_vectors { " << mesh.positions.size();
    for (const glint::vec3& p : mesh.positions) out << ",\n<" << p.x << ',' << p.y << ',' << p.z << '>';
    out << " }\nface_indices { " << mesh.triangles.size();
    for (const glint::uvec3& t : mesh.triangles) out << ",\n<" << t.x << ',' << t.y << ',' << t.z << '>';
    out << " }\n}\n";
    if (!out.flush()) throw glint::Error(glint::ErrorKind::output, path + " cannot be written");
}

void run(const std::string& in, const std::string& ply, const std::string& inc) {
    const auto loaded = glint::load_mesh(in).mesh;
    glint::Mesh mesh;
    mesh.triangles = loaded->triangles;
    glint::Bounds bounds;
    for (const glint::vec3& p : loaded->positions) bounds.grow(p);
    const glint::vec3 middle = (bounds.lo + bounds.hi) * 0.5f;
    const glint::vec3 extent = bounds.extent();
    const float scale = 24.0f / std::max({extent.x, extent.y, extent.z});
    for (const glint::vec3& p : loaded->positions) {
        const glint::vec3 q = (p - middle) * scale;
        mesh.positions.push_back(glint::vec3(q.x - 25.0f, 20.0f - q.z, q.y));
    }
    glint::write_ply(ply, mesh);
    write_povray(inc, mesh);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: glint-pov-mesh IN.ply OUT.ply OUT.inc\n";
        return 2;
    }
    try {
        run(argv[1], argv[2], argv[3]);
    } catch (const std::exception& error) {
        std::cerr << "glint-pov-mesh: " << error.what() << '\n';
        return 3;
    }
}
