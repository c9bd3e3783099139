// Each room's names live in the room's own namespace.

#include "rooms.h"

#include <gtest/gtest.h>

namespace glint::house {
namespace {

/// Headers whose text is compiled for several vocabularies: shared equations, and their vectors.
bool is_shared(const std::string& path) { return path.ends_with(".shared.h") || path.ends_with("-inl.h"); }

/// "path:line: opens X, not Y" for each namespace that a header of src/ opens but that is not its room's.
std::string wrong_namespaces(const Source& source) {
    const std::string room = source.path.substr(4, source.path.find('/', 4) - 4);
    const std::string own = namespace_of(room);
    const std::string head = "namespace ";
    const std::string code = code_only(source.text);
    std::string out;
    int depth = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i] == '{') ++depth;
        if (code[i] == '}') --depth;
        if (depth > 0 || code.compare(i, head.size(), head) != 0) continue;
        const std::size_t first = i + head.size();
        const std::string name = code.substr(first, code.find_first_of(" {;", first) - first);
        const std::size_t inside = code.find_first_not_of(" {\n", first + name.size());
        // Specializations of a public template must stand where it does.
        if (inside != std::string::npos && code.compare(inside, 11, "template <>") == 0) continue;
        if (name == own || (own != "glint" && name.starts_with(own + "::"))) continue;
        out +=
            source.path + ":" + std::to_string(line_at(code, i)) + ": opens " + name + ", not " + own + "\n";
    }
    return out;
}

TEST(Namespaces, EveryHeaderOpensThatOfItsRoomOnly) {
    const std::vector<Source> sources = sources_under({"src"}, {".h"});
    ASSERT_GT(sources.size(), 30u) << "the sources were not found";
    std::string all;
    for (const Source& source : sources)
        if (!is_shared(source.path)) all += wrong_namespaces(source);
    EXPECT_EQ(all, "");
}

TEST(Namespaces, TheDesignPageNamesThoseThatAreNotNamedLikeTheRoom) {
    const std::string page = read_project_file("docs/design.md");
    for (const Room& room : rooms()) {
        const std::string name = namespace_of(room.name);
        if (name == "glint::" + room.name) continue;
        EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << "docs/design.md does not name " << name;
    }
}

// The check itself.

TEST(Namespaces, AHeaderThatOpensAnotherNamespaceIsFound) {
    EXPECT_EQ(wrong_namespaces({"src/scene/a.h", "namespace glint::scene {\n}\nnamespace glint {\n}\n"}),
              "src/scene/a.h:3: opens glint, not glint::scene\n");
    EXPECT_EQ(wrong_namespaces({"src/render/a.h", "namespace glint::render {\n}\n"}),
              "src/render/a.h:1: opens glint::render, not glint::rendering\n");
    EXPECT_EQ(wrong_namespaces({"src/math/a.h", "namespace glint::math {\n}\n"}),
              "src/math/a.h:1: opens glint::math, not glint\n");
}

TEST(Namespaces, AHeaderThatStaysInItsRoomIsNotFound) {
    EXPECT_EQ(wrong_namespaces({"src/render/a.h", "namespace glint::rendering {\nnamespace {\n}\n}\n"}), "");
    EXPECT_EQ(
        wrong_namespaces({"src/scene/a.h", "// namespace glint {\nnamespace glint::scene::keys {\n}\n"}), "");
    EXPECT_EQ(wrong_namespaces({"src/errors/a.h", "namespace glint {\n}\n"}), "");
    EXPECT_EQ(wrong_namespaces({"src/scene/a.h", "namespace glint {\n\ntemplate <>\nint names<int>{};\n}\n"}),
              "");
}

} // namespace
} // namespace glint::house
