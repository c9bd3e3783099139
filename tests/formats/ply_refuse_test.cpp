// What is no PLY file, or none that can be trusted: each refused with its place, its cause and a cure.

#include "ply_files.h"

#include <cmath>
#include <filesystem>
#include <limits>

namespace glint::formats {
namespace {

using namespace ply_test;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

/// A header that goes wrong after its format line, which is line 2.
std::string broken(const std::string& rest) { return "ply\nformat ascii 1.0\n" + rest; }

// ── The header ─────────────────────────────────────────────────────────────────────────────────────────────

TEST(PlyRefuse, WhatIsNoPly) {
    expect_refused("", {"not a PLY file", "the file is empty", 1, 1, {}});
    expect_refused("hello\n", {"not a PLY file", "begins with a line that says 'ply'", 1, 1, {}});
    expect_refused("plywood\nformat ascii 1.0\n", {"not a PLY file", "begins with a line", 1, 1, {}});
    expect_refused("\x1f\x8b\x08 ply", {"compressed with gzip", "gunzip", 0, 0, {}});
    expect_refused("solid cube\n", {"not a PLY file", "STL", 1, 1, {}});
    expect_refused(std::string("\xff\xfep\0l\0y\0", 8), {"not a PLY file", "UTF-16", 1, 1, {}});
    expect_refused("glTF\2", {"not a PLY file", "glTF", 1, 1, {}});
}

TEST(PlyRefuse, AHeaderThatEndsEarly) {
    expect_refused("ply", {"the file ends within its header", "end_header", 1, 4, {}});
    expect_refused(broken("element vertex 3\nproperty float x\n"),
                   {"the file ends within its header", "end_header", 5, 1, {}});
}

TEST(PlyRefuse, AMisspeltKeywordWithTheOneThatWasMeant) {
    expect_refused(broken("elment vertex 3\n"),
                   {"unknown header line 'elment'", "did you mean 'element'?", 3, 1, {}});
    expect_refused(broken("  end_heade\n"),
                   {"unknown header line 'end_heade'", "did you mean 'end_header'?", 3, 3, {}});
    expect_refused(broken("\x01\x02garbage of a binary body\n"),
                   {"unknown header line '\?\?garbage'", "expected format, element", 3, 1, {}});
}

TEST(PlyRefuse, AnUnknownFormatOrVersion) {
    expect_refused("ply\nformat asci 1.0\n", {"unknown format 'asci'", "did you mean 'ascii'?", 2, 8, {}});
    expect_refused(
        "ply\nformat binary_little_endain 1.0\n",
        {"unknown format 'binary_little_endain'", "did you mean 'binary_little_endian'?", 2, 8, {}});
    expect_refused("ply\nformat xml 1.0\n", {"unknown format 'xml'", "expected ascii", 2, 8, {}});
    expect_refused("ply\nformat ascii 2.0\n", {"unknown PLY version '2.0'", "1.0", 2, 14, {}});
}

TEST(PlyRefuse, AFormatLineThatIsMissingOrComesTwice) {
    expect_refused("ply\nelement vertex 1\n" + xyz + "end_header\n0 0 0\n",
                   {"no format line", "format ascii 1.0", 6, 1, {}});
    expect_refused(broken("format ascii 1.0\n"), {"a second format line", "remove", 3, 1, {}});
}

TEST(PlyRefuse, HeaderLinesWithTooFewOrTooManyWords) {
    expect_refused("ply\nformat ascii\n", {"too short", "expected: format ascii", 2, 13, {}});
    expect_refused(broken("element vertex\n"), {"too short", "expected: element NAME COUNT", 3, 15, {}});
    expect_refused(broken("element vertex 3 4\n"), {"unexpected '4'", "element NAME COUNT", 3, 18, {}});
    expect_refused(broken("element vertex 3\nproperty float\n"),
                   {"too short", "property TYPE NAME", 4, 15, {}});
    expect_refused(broken("element vertex 3\nproperty list uchar int\n"),
                   {"too short", "property list COUNT_TYPE TYPE NAME", 4, 24, {}});
    expect_refused(broken("element vertex 3\n" + xyz + "end_header 1\n"),
                   {"unexpected '1'", "end_header", 7, 12, {}});
}

TEST(PlyRefuse, CountsThatAreNoCounts) {
    expect_refused(broken("element vertex -3\n"),
                   {"'-3' is not a number of elements", "whole number", 3, 16, {}});
    expect_refused(broken("element vertex 3.5\n"),
                   {"'3.5' is not a number of elements", "whole number", 3, 16, {}});
    expect_refused(broken("element vertex 99999999999999999999\n"),
                   {"is not a number of elements", "", 3, 16, {}});
    expect_refused(broken("element vertex many\n"),
                   {"'many' is not a number of elements", "0 or more", 3, 16, {}});
}

TEST(PlyRefuse, PropertiesBeforeAnyElementTwiceOrOfUnknownType) {
    expect_refused(broken("property float x\n"),
                   {"a property stands before any element", "element NAME", 3, 1, {}});
    expect_refused(broken("element vertex 1\nproperty float x\nproperty int x\n"),
                   {"element 'vertex' has a second property 'x'", "must differ", 5, 14, {}});
    expect_refused(broken("element vertex 1\nproperty flaot x\n"),
                   {"unknown type 'flaot'", "did you mean 'float'?", 4, 10, {}});
    expect_refused(broken("element vertex 1\nproperty quaternion x\n"),
                   {"unknown type 'quaternion'", "expected char, uchar", 4, 10, {}});
    expect_refused(broken("element face 1\nproperty list float int vertex_indices\n"),
                   {"a list cannot be counted in 'float'", "integer type", 4, 15, {}});
}

TEST(PlyRefuse, AHeaderWithoutVertices) {
    expect_refused(broken("end_header\n"), {"no element 'vertex'", "a mesh needs vertices", 3, 1, {}});
    expect_refused(broken("element vertices 3\n" + xyz + "end_header\n" + corners),
                   {"no element 'vertex'", "did you mean 'vertex' by 'vertices'?", 3, 9, {}});
    expect_refused(ascii("0", "0", ""), {"the file has no vertices", "nothing to draw", 3, 16, {}});
    expect_refused(
        broken("element vertex 1\n" + xyz + "element vertex 1\n" + xyz + "end_header\n0 0 0\n0 0 0\n"),
        {"a second element 'vertex'", "remove", 7, 9, {}});
    expect_refused(
        broken(
            "element vertex 1\nproperty float x\nproperty float z\nproperty list uchar int y\nend_header\n"),
        {"a vertex has no number 'y'", "these have: 'x', 'z', 'y'", 3, 9, {}});
}

TEST(PlyRefuse, FacesWithoutAListOfWholeNumbers) {
    const std::string head = "element vertex 1\n" + xyz + "element face 1\n";
    expect_refused(broken(head + "property list uchar int vertices\nend_header\n"),
                   {"element 'face' has no list of corners", "it has: 'vertices'", 7, 9, {}});
    expect_refused(broken(head + "property int vertex_indices\nend_header\n"),
                   {"'vertex_indices' is not a list", "property list uchar int", 8, 14, {}});
    expect_refused(broken(head + "property list uchar float vertex_index\nend_header\n"),
                   {"vertex indices cannot be of type 'float'", "integer type", 8, 21, {}});
    expect_refused(broken(head +
                          "property list uchar int vertex_index\nproperty list uchar int vertex_indices\n"
                          "end_header\n"),
                   {"element 'face' lists its corners twice", "keep one", 9, 25, {}});
}

// ── Text ───────────────────────────────────────────────────────────────────────────────────────────────────

TEST(PlyRefuse, AnIndexOutOfRange) {
    expect_refused(ascii("3", "2", corners + "3 0 1 2\n3 0 1 5000\n"),
                   {"vertex index 5000 in face 1 is out of range",
                    "has 3 vertices, so indices go from 0 to 2",
                    14,
                    7,
                    {}});
    expect_refused(ascii("3", "1", corners + "4 0 1 2 3\n"),
                   {"vertex index 3 in face 0 is out of range", "from 0 to 2", 13, 9, {}});
    expect_refused(ascii("3", "1", corners + "3 0 -1 2\n"),
                   {"vertex index -1 in face 0 is out of range", "", 13, 5, {}});
    expect_refused(ascii("1", "1", "0 0 0\n3 0 0 1\n"),
                   {"vertex index 1 in face 0 is out of range", "the only index is 0", 11, 7, {}});
    expect_refused(broken("element vertex 3\n" + xyz +
                          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                          corners + "5 0 1 2 -1 -2\n"),
                   {"vertex index -2 in tristrips 0 is out of range", "", 13, 12, {}});
}

TEST(PlyRefuse, ATextThatIsCut) {
    // The last word may lack its line end, not more.
    expect_refused(ascii("3", "2", corners + "3 0 1 2\n3 0 1"),
                   {"list 'vertex_indices' of face 1 claims 3 values",
                    "the file is cut, or this length is wrong",
                    14,
                    1,
                    {}});
    expect_refused(ascii("3", "1", corners + "3 0 1  \n"),
                   {"the file ends within face 0", "promises 1; the file seems to be cut", 13, 6, {}});
    expect_refused(ascii("4", "0", corners + "0.12 0.53\n\n\n"),
                   {"the file ends within vertex 3", "cut", 13, 10, {}});
}

TEST(PlyRefuse, CountsThatTheFileCannotHold) {
    expect_refused(ascii("4000000000", "1", corners + "3 0 1 2\n"),
                   {"promises 4000000000 rows of 'vertex', but the file has room for at most 4",
                    "header is wrong",
                    3,
                    16,
                    {}});
    expect_refused(ascii("3", "18446744073709551615", corners + "3 0 1 2\n"),
                   {"promises 18446744073709551615 rows of 'face'", "", 7, 14, {}});
    expect_refused(ascii("4294967296", "1", corners), {"more than 4294967295 vertices", "split", 3, 16, {}});
    expect_refused(ascii("3", "1", corners + "200 0 1 2\n"),
                   {"list 'vertex_indices' of face 0 claims 200 values", "room for at most 4", 13, 1, {}});
}

TEST(PlyRefuse, WordsThatAreNoNumbersOfTheirType) {
    expect_refused(ascii("3", "1", "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"),
                   {"'zero' in vertex 1 is not a number", "expected a number like", 11, 3, {}});
    expect_refused(ascii("3", "1", "0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n"),
                   {"'0,5' in vertex 1 is not a number", "", 11, 3, {}});
    expect_refused(ascii("3", "1", corners + "3 0 1.0 2\n"),
                   {"'1.0' in face 0 is not a whole number", "value of type int", 13, 5, {}});
    expect_refused(ascii("3", "1", corners + "-3 0 1 2\n"),
                   {"'-3' in face 0 does not fit its type uchar", "from 0 to 255", 13, 1, {}});
    expect_refused(ascii("3", "1", corners + "3 0 1 99999999999999999999\n"),
                   {"does not fit its type int", "from -2147483648 to 2147483647", 13, 7, {}});
}

TEST(PlyRefuse, ANegativeLength) {
    expect_refused(broken("element vertex 3\n" + xyz +
                          "element face 1\nproperty list char int vertex_indices\nend_header\n" + corners +
                          "-3 0 1 2\n"),
                   {"list 'vertex_indices' of face 0 claims -3 values", "cannot be negative", 13, 1, {}});
}

TEST(PlyRefuse, RowsWithMoreOrFewerValuesThanProperties) {
    expect_refused(
        ascii("3", "1", "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n"),
        {"unexpected '7' after the end of vertex 1", "more values than its header lists", 11, 7, {}});
    expect_refused(ascii("3", "1", "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"),
                   {"unexpected '1' after the end of vertex 1", "a value may be missing", 12, 3, {}});
}

TEST(PlyRefuse, AVertexThatIsNotFiniteOrTooFarAndThatAFaceUses) {
    expect_refused(ascii("3", "1", "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
                   {"vertex 1 is not finite, and a face uses it", "correct this coordinate", 11, 3, {}});
    expect_refused(ascii("3", "1", "0 0 0\n1 0 0\n0 1 -1e500\n3 0 1 2\n"),
                   {"vertex 2 is not finite, and a face uses it", "", 12, 5, {}});
    expect_refused(ascii("4", "1", "0 0 0\n1 1e13 0\n0 1 0\n0 0 1\n4 3 2 1 0\n"),
                   {"vertex 1 lies beyond 10^12", "scale the mesh down", 11, 3, {}});
    expect_refused(
        broken("element vertex 1\nproperty double x\nproperty float y\nproperty float z\nelement face 1\n"
               "property list uchar int vertex_index\nend_header\n-1e300 0 0\n3 0 0 0\n"),
        {"vertex 0 lies beyond 10^12", "", 10, 1, {}});
    expect_refused(ascii("2", "0", "nan 0 0\n0 0 inf\n"),
                   {"no vertex of the file is finite", "nothing to draw", 10, 1, {}});
}

TEST(PlyRefuse, AConcaveFaceOfMoreCornersThanCanBeSplit) {
    std::string points, face = "11000";
    for (int i = 0; i < 11000; ++i) {
        points += std::to_string(i) + (i == 0 ? " -50 0\n" : i % 2 ? " 1 0\n" : " 0 0\n");
        face += " " + std::to_string(i);
    }
    expect_refused(broken("element vertex 11000\n" + xyz +
                          "element face 1\nproperty list int int vertex_index\nend_header\n" + points + face +
                          "\n"),
                   {"a concave face of 11000 corners is too large", "up to 10000 corners", 11010, 1, {}});
}

TEST(PlyRefuse, NamesTheLineWhateverEndsLines) {
    std::string file = ascii("3", "1", corners + "3 0 1 9\n");
    std::string crlf, cr;
    for (const char c : file) {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
    }
    const Refusal expected{"vertex index 9 in face 0 is out of range", "from 0 to 2", 13, 7, {}};
    expect_refused(file, expected);
    expect_refused(crlf, expected);
    expect_refused(cr, expected);
}

TEST(PlyRefuse, ShowsTheLineWithACaret) {
    try {
        parse(ascii("3", "1", corners + "3 0 1 9\n"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "test.ply:13:7: error: vertex index 9 in face 0 is out of range\n"
                                   "    3 0 1 9\n"
                                   "          ^\n"
                                   "    the file has 3 vertices, so indices go from 0 to 2");
    }
}

// ── Bytes ──────────────────────────────────────────────────────────────────────────────────────────────────

/// A binary file with a header of its own, and the byte at which the body begins.
struct Binary {
    std::string head;
    std::uint64_t body = head.size();
};

Binary binary(const std::string& vertices, const std::string& faces, const std::string& list = "uchar int") {
    std::string head = header(binary_format(std::endian::little), vertices, faces);
    head.replace(head.find("uchar int"), 9, list);
    return {head};
}

const std::string triangle = Bytes().vertex(0, 0, 0).vertex(1, 0, 0).vertex(0, 1, 0);

TEST(PlyRefuse, AnIndexOutOfRangeInBytes) {
    const Binary file = binary("3", "1");
    expect_refused(file.head + triangle + std::string(Bytes().u8(3).i32(0).i32(7).i32(1)),
                   {"vertex index 7 in face 0 is out of range", "from 0 to 2", 0, 0, file.body + 36 + 5});
    expect_refused(file.head + triangle + std::string(Bytes().u8(4).i32(0).i32(1).i32(2).i32(-1)),
                   {"vertex index -1 in face 0 is out of range", "from 0 to 2", 0, 0, file.body + 36 + 13});
}

TEST(PlyRefuse, BytesThatAreCut) {
    const Binary file = binary("3", "2");
    const std::string whole =
        file.head + triangle + std::string(Bytes().u8(3).i32(0).i32(1).i32(2).u8(3).i32(0).i32(2).i32(1));
    expect_refused(whole.substr(0, whole.size() - 1), {"list 'vertex_indices' of face 1 claims 3 values",
                                                       "room for at most 2", 0, 0, whole.size() - 13});
    expect_refused(
        whole.substr(0, file.body + 20),
        {"promises 3 rows of 'vertex', but the file has room for at most 1", "cut", 0, 0, file.body + 20});
}

TEST(PlyRefuse, BytesThatAreCutWithinARow) {
    std::string head = header(binary_format(std::endian::big), "3", "1");
    head.insert(head.find("end_header"), "property int tag\n");
    const std::string body = Bytes(std::endian::big)
                                 .vertex(0, 0, 0)
                                 .vertex(1, 0, 0)
                                 .vertex(0, 1, 0)
                                 .u8(3)
                                 .i32(0)
                                 .i32(1)
                                 .i32(2)
                                 .i16(7);
    expect_refused(head + body,
                   {"the file ends within face 0", "promises 1", 0, 0, head.size() + body.size()});
}

TEST(PlyRefuse, CountsThatTheBytesCannotHold) {
    const Binary vertices = binary("4000000000", "0");
    expect_refused(vertices.head + triangle,
                   {"promises 4000000000 rows of 'vertex', but the file has room for at most 3",
                    "header is wrong", 0, 0, vertices.body + 36});
    const Binary faces = binary("3", "4000000000");
    expect_refused(faces.head + triangle + std::string(Bytes().u8(3).i32(0).i32(1).i32(2)),
                   {"promises 4000000000 rows of 'face', but the file has room for at most 13", "", 0, 0,
                    faces.body + 49});
    const Binary list = binary("3", "1", "uint int");
    expect_refused(list.head + triangle + std::string(Bytes().i32(0xffffffff).i32(0).i32(1).i32(2)),
                   {"list 'vertex_indices' of face 0 claims 4294967295 values", "room for at most 3", 0, 0,
                    list.body + 36});
}

TEST(PlyRefuse, ANegativeLengthInBytes) {
    const Binary file = binary("3", "1", "int int");
    expect_refused(
        file.head + triangle + std::string(Bytes().i32(-3).i32(0).i32(1).i32(2)),
        {"list 'vertex_indices' of face 0 claims -3 values", "cannot be negative", 0, 0, file.body + 36});
}

TEST(PlyRefuse, AVertexInBytesThatIsNotFiniteAndThatAFaceUses) {
    const Binary file = binary("3", "1");
    const float infinity = std::numeric_limits<float>::infinity();
    const std::string body =
        Bytes().vertex(0, 0, 0).vertex(1, 0, infinity).vertex(0, NAN, 0).u8(3).i32(0).i32(1).i32(2);
    expect_refused(file.head + body,
                   {"vertex 1 is not finite, and a face uses it", "remove the faces", 0, 0, file.body + 20});
}

TEST(PlyRefuse, AFileThatCannotBeRead) {
    for (const std::string& path :
         {std::string(GLINT_SOURCE_DIR) + "/no-such.ply", std::string(GLINT_SOURCE_DIR)}) {
        try {
            load_mesh(path);
            ADD_FAILURE() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_EQ(error.diagnostics().at(0).location.file, path);
            EXPECT_NE(error.diagnostics().at(0).message.find("cannot read the file"), std::string::npos);
        }
    }
}

} // namespace
} // namespace glint::formats
