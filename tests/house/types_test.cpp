// One definition of each type (ISO C++ [basic.def.odr]): rooms are linked into one program, where two types
// of one name in one namespace are undefined behaviour that no compiler reports.

#include "sources.h"

#include <gtest/gtest.h>

#include <map>

namespace glint::house {
namespace {

/// Sources that the build takes in place of others if an optional part is off.
bool is_alternative(const std::string& path) {
    return path == "src/gpu/none.cpp" || path == "src/formats/picture/exr_none.cpp";
}

/// "name: path:line and path:line" for each type that several files define.
std::string doubles(const std::vector<Source>& sources) {
    std::map<std::string, std::string> definitions;
    std::string out;
    for (const Source& source : sources)
        for (const Type& type : types_of(source.text)) {
            if (is_alternative(source.path)) continue;
            const std::string location = source.path + ":" + std::to_string(type.line);
            const auto [found, is_new] = definitions.emplace(type.name, location);
            if (!is_new) out += type.name + ": " + found->second + " and " + location + "\n";
        }
    return out;
}

TEST(Types, NoTypeOfTheLibraryOrProgramsIsDefinedTwice) {
    const std::vector<Source> sources = sources_under({"include", "src", "apps"});
    ASSERT_GT(sources.size(), 30u) << "the sources were not found";
    EXPECT_EQ(doubles(sources), "");
}

// The check itself.

std::string names_of(const std::string& text) {
    std::string out;
    for (const Type& type : types_of(text)) out += type.name + " " + std::to_string(type.line) + "\n";
    return out;
}

TEST(Types, TheScannerNamesTypesWithTheirScopes) {
    EXPECT_EQ(
        names_of("namespace a::b {\n"
                 "struct alignas(32) A : Base<int> {\n    enum class E { x };\n    struct { int i; } n;\n};\n"
                 "class B;\nclass B::State {\n};\n"
                 "template <class T>\nstruct A<T*> {\n};\n"
                 "namespace {\nstruct Own {\n};\n} // namespace\n"
                 "}\nunion U {\n};\nvoid f() {\n    struct Local {};\n}\n"),
        "a::b::A 2\na::b::A::E 3\na::b::B::State 7\na::b::A<T*> 9\nU 17\n");
}

TEST(Types, ATypeOfTwoFilesIsFoundWithBoth) {
    const std::vector<Source> sources = {{"src/a.h", "namespace glint {\nstruct Range {\n};\n}\n"},
                                         {"src/b.h", "namespace glint {\n\nstruct Range {\n};\n}\n"},
                                         {"src/c.h", "namespace glint::c {\nstruct Range {\n};\n}\n"}};
    EXPECT_EQ(doubles(sources), "glint::Range: src/a.h:2 and src/b.h:3\n");
}

} // namespace
} // namespace glint::house
