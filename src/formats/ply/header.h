#pragma once
// The header of a PLY file: format, elements and properties.
// Source: Turk, "The PLY Polygon File Format", 1994.

#include "formats/ply/source.h"
#include "glint/mesh_files.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glint::formats::ply {

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(Type type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}
constexpr bool is_integer(Type type) { return type < Type::float32; }
/// Canonical name of a type: "char" … "double".
const char* type_name(Type type);

struct Property {
    std::string name;
    Type type = Type::float32;
    std::optional<Type> count_type; ///< type of a list's length, an integer type; none if not a list
    std::size_t offset = 0;         ///< of the name in the file
    std::size_t type_offset = 0;    ///< of the type's name in the file

    bool is_list() const { return count_type.has_value(); }
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::size_t name_offset = 0;  ///< of the name in the file
    std::size_t count_offset = 0; ///< of the count in the file
    std::vector<Property> properties;
};

struct Header {
    PlyFormat format = PlyFormat::ascii;
    std::vector<Element> elements; ///< in file order
    std::size_t end_header = 0;    ///< offset of the word end_header
    std::size_t body = 0;          ///< offset of the first byte after the header
};

/// Parses the header. Lines may end in LF, CRLF or CR; blank lines, comments and a byte order mark are
/// accepted. Throws Error(input) with line and column.
Header parse_header(const Source& source);

} // namespace glint::formats::ply
