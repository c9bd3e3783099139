// Writing meshes as PLY files.

#include "glint/mesh_files.h"
#include "glint/write_file.h"
#include "imaging/tone.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

namespace glint {
namespace {

/// Formats values for one of the PLY formats.
class Output {
  public:
    explicit Output(PlyFormat format) : format_(format) {}

    void line(const std::string& text) { text_ += text + "\n"; }

    void number(float value) {
        if (format_ == PlyFormat::ascii) return word(value);
        bytes(std::bit_cast<std::uint32_t>(value));
    }
    void number(double value) {
        if (format_ == PlyFormat::ascii) return word(value);
        bytes(std::bit_cast<std::uint64_t>(value));
    }
    void integer(std::uint32_t value) {
        if (format_ == PlyFormat::ascii) return word(value);
        bytes(value);
    }
    void byte(std::uint8_t value) {
        if (format_ == PlyFormat::ascii) return word(static_cast<std::uint32_t>(value));
        text_.push_back(static_cast<char>(value));
    }
    void end_row() {
        if (format_ == PlyFormat::ascii) text_.back() = '\n';
    }
    const std::string& text() const { return text_; }

  private:
    /// Shortest text that parses to the same value, in any locale.
    template <class Value>
    void word(Value value) {
        char buffer[32];
        text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
        text_ += ' ';
    }
    template <class Bits>
    void bytes(Bits bits) {
        constexpr int count = sizeof bits;
        for (int i = 0; i < count; ++i) {
            const int shift = 8 * (format_ == PlyFormat::binary_little_endian ? i : count - 1 - i);
            text_.push_back(static_cast<char>(static_cast<unsigned char>(bits >> shift & 0xffu)));
        }
    }

    PlyFormat format_;
    std::string text_;
};

/// Whether every colour equals an 8-bit sRGB code bit for bit. Then bytes are lossless, and more programs
/// read them.
bool are_codes(const std::vector<glm::vec3>& colors) {
    const auto is_code = [](float light) {
        return std::bit_cast<std::uint32_t>(imaging::linear_from_srgb8(imaging::srgb8_from_linear(light))) ==
               std::bit_cast<std::uint32_t>(light);
    };
    return std::all_of(colors.begin(), colors.end(),
                       [&](const glm::vec3& c) { return is_code(c.x) && is_code(c.y) && is_code(c.z); });
}

void write_header(Output& out, const Mesh& mesh, PlyFormat format, bool byte_colors) {
    const auto properties = [&](const char* type, std::initializer_list<const char*> names) {
        for (const char* name : names) out.line(std::string("property ") + type + " " + name);
    };
    out.line("ply");
    out.line("format " + std::string(name_of(format)) + " 1.0");
    out.line("element vertex " + std::to_string(mesh.positions.size()));
    properties(mesh.origin == Vec3(0) ? "float" : "double", {"x", "y", "z"});
    if (!mesh.normals.empty()) properties("float", {"nx", "ny", "nz"});
    if (!mesh.colors.empty()) properties(byte_colors ? "uchar" : "float", {"red", "green", "blue"});
    if (!mesh.uvs.empty()) properties("float", {"s", "t"});
    const bool wide = mesh.positions.size() > std::numeric_limits<std::int32_t>::max();
    out.line("element face " + std::to_string(mesh.triangles.size()));
    out.line(std::string("property list uchar ") + (wide ? "uint" : "int") + " vertex_indices");
    out.line("end_header");
}

void write_vertex(Output& out, const Mesh& mesh, std::size_t i, bool byte_colors) {
    const auto numbers = [&](const auto& values) {
        for (int k = 0; k < values.length(); ++k) out.number(values[k]);
    };
    if (mesh.origin == Vec3(0))
        numbers(mesh.positions[i]);
    else
        numbers(mesh.origin + Vec3(mesh.positions[i]));
    if (!mesh.normals.empty()) numbers(mesh.normals[i]);
    if (!mesh.colors.empty() && !byte_colors) numbers(mesh.colors[i]);
    if (!mesh.colors.empty() && byte_colors)
        for (int k = 0; k < 3; ++k) out.byte(imaging::srgb8_from_linear(mesh.colors[i][k]));
    if (!mesh.uvs.empty()) numbers(mesh.uvs[i]);
    out.end_row();
}

} // namespace

void write_ply(const std::string& path, const Mesh& mesh, PlyFormat format) {
    Output out(format);
    const bool byte_colors = are_codes(mesh.colors);
    write_header(out, mesh, format, byte_colors);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) write_vertex(out, mesh, i, byte_colors);
    for (const glm::uvec3& triangle : mesh.triangles) {
        out.byte(3);
        for (int k = 0; k < 3; ++k) out.integer(triangle[k]);
        out.end_row();
    }
    write_file(path, std::as_bytes(std::span(out.text())));
}

} // namespace glint
