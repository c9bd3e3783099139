#pragma once
// PLY files made in memory, and what tests expect of them.

#include "glint/mesh_files.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <string>

namespace glint::ply_test {

inline constexpr const char* name = "test.ply";

inline LoadedMesh parse(const std::string& file) { return parse_ply(std::as_bytes(std::span(file)), name); }

/// The values of a binary body, appended one after another.
class Bytes {
  public:
    explicit Bytes(std::endian order = std::endian::little) : order_(order) {}
    template <class Bits>
    Bytes& bits(Bits value) {
        for (std::size_t i = 0; i < sizeof(Bits); ++i) {
            const std::size_t k = order_ == std::endian::little ? i : sizeof(Bits) - 1 - i;
            text_.push_back(static_cast<char>(static_cast<unsigned char>(value >> 8 * k & 0xffu)));
        }
        return *this;
    }
    Bytes& u8(int value) { return bits(static_cast<std::uint8_t>(value)); }
    Bytes& i16(int value) { return bits(static_cast<std::uint16_t>(value)); }
    Bytes& i32(std::int64_t value) { return bits(static_cast<std::uint32_t>(value)); }
    Bytes& f32(float value) { return bits(std::bit_cast<std::uint32_t>(value)); }
    Bytes& f64(double value) { return bits(std::bit_cast<std::uint64_t>(value)); }
    Bytes& vertex(float x, float y, float z) { return f32(x).f32(y).f32(z); }
    operator std::string() const { return text_; }

  private:
    std::endian order_;
    std::string text_;
};

/// "format binary_…_endian 1.0" for the order.
inline std::string binary_format(std::endian order) {
    return order == std::endian::little ? "format binary_little_endian 1.0\n"
                                        : "format binary_big_endian 1.0\n";
}

/// A header of float vertices and faces of uchar and int.
inline std::string header(const std::string& format, const std::string& vertices, const std::string& faces) {
    return "ply\n" + format + "element vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ascii(const std::string& vertices, const std::string& faces, const std::string& body) {
    return header("format ascii 1.0\n", vertices, faces) + body;
}

/// Three corners of a triangle, as rows of text.
inline const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";

/// Where and why a file is refused.
struct Refusal {
    std::string message; ///< a part of it
    std::string hint;    ///< a part of it
    int line = 0;
    int column = 0;
    std::optional<std::uint64_t> byte;
};

inline void expect_refused(const std::string& file, const Refusal& expected) {
    try {
        parse(file);
        ADD_FAILURE() << "accepted, though expected: " << expected.message;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        ASSERT_EQ(error.diagnostics().size(), 1u);
        const Diagnostic& d = error.diagnostics().front();
        EXPECT_EQ(d.severity, Severity::error);
        EXPECT_NE(d.message.find(expected.message), std::string::npos) << d.message;
        EXPECT_NE(d.hint.find(expected.hint), std::string::npos) << d.hint;
        EXPECT_EQ(d.location, (Location{name, expected.line, expected.column, expected.byte}))
            << error.what();
    }
}

/// The one warning of a file.
inline void expect_warned(const LoadedMesh& loaded, const std::string& message, const std::string& hint) {
    ASSERT_EQ(loaded.warnings.size(), 1u);
    const Diagnostic& d = loaded.warnings.front();
    EXPECT_EQ(d.severity, Severity::warning);
    EXPECT_EQ(d.location.file, name);
    EXPECT_NE(d.message.find(message), std::string::npos) << d.message;
    EXPECT_NE(d.hint.find(hint), std::string::npos) << d.hint;
}

} // namespace glint::ply_test
