// Which room may include which. The linker checks it too: a room is linked only with the rooms it names.

#include "rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace glint::house {
namespace {

std::string joined(const std::vector<std::string>& lines, const std::string& separator = "\n") {
    std::string out;
    for (const std::string& line : lines) out += (out.empty() ? "" : separator) + line;
    return out;
}

TEST(Layers, EveryIncludeIsOneThatTheTableAllows) {
    const std::vector<Source> sources = sources_under({"src", "include", "apps"});
    ASSERT_GT(sources.size(), 30u) << "the sources were not found";
    std::vector<std::string> all;
    for (const Source& source : sources)
        for (const std::string& complaint : complaints(source)) all.push_back(complaint);
    EXPECT_TRUE(all.empty()) << joined(all);
}

TEST(Layers, NoFilesIncludeEachOtherInACycle) {
    EXPECT_EQ(
        joined(include_cycle(sources_under({"src", "include", "apps", "tests", "tools", "bench"})), " -> "),
        "");
}

TEST(Layers, EveryRoomStandsAboveAllThatItMayInclude) {
    std::map<std::string, int> floors;
    for (const Room& room : rooms()) floors[room.name] = room.floor;
    for (const Room& room : rooms())
        for (const std::string& below : room.below) {
            ASSERT_EQ(floors.count(below), 1u) << room.name << " names " << below;
            EXPECT_LT(floors[below], room.floor) << below << " is not below " << room.name;
        }
}

TEST(Layers, EveryFolderOfTheSourcesIsARoom) {
    std::set<std::string> folders;
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GLINT_SOURCE_DIR) + "/src"))
        if (entry.is_directory()) folders.insert(entry.path().filename().string());
    for (const Room& room : rooms()) names.insert(room.name);
    EXPECT_EQ(folders, names);
}

TEST(Layers, EveryPublicHeaderHasAnOwner) {
    for (const Source& source : sources_under({"include"}))
        EXPECT_NE(room_of_public_header(source.path.substr(std::string("include/").size())), "")
            << source.path;
}

TEST(Layers, TheDesignPageShowsTheSameTable) {
    const std::string page = read_project_file("docs/design.md");
    for (const Room& room : rooms()) {
        const std::string below = room.below.empty() ? "nothing" : joined(room.below, ", ");
        const std::string row =
            "| `" + room.name + "` | " + std::to_string(room.floor) + " | " + below + " |";
        EXPECT_NE(page.find("\n" + row), std::string::npos) << "docs/design.md has no row\n" << row;
    }
}

TEST(Layers, TheDesignPageNamesThePublicHeadersOfEachRoom) {
    std::map<std::string, std::vector<std::string>> headers;
    for (const Source& source : sources_under({"include"})) {
        const std::string name = source.path.substr(std::string("include/").size());
        headers[room_of_public_header(name)].push_back("`" + name.substr(name.rfind('/') + 1) + "`");
    }
    const std::string page = read_project_file("docs/design.md");
    for (const auto& [room, names] : headers) {
        const std::string row = "| `" + room + "` | " + joined(names, ", ") + " |\n";
        EXPECT_NE(page.find("\n" + row), std::string::npos) << "docs/design.md has no row\n" << row;
    }
}

// The checks themselves, on sources that break a rule each.

TEST(Layers, AnIncludeFromAHigherFloorIsFoundWithItsLine) {
    const Source source{"src/trace/a.cpp", "#include \"math/vec.h\"\n\n#include \"glint/scene.h\"\n"};
    EXPECT_EQ(joined(complaints(source)),
              "src/trace/a.cpp:3: trace may not include scene: \"glint/scene.h\"");
}

TEST(Layers, AnIncludeInACommentOrAStringIsNone) {
    const Source source{"src/math/a.cpp",
                        "// #include \"scene/scene_data.h\"\n/*\n#include \"scene/scene_data.h\"\n*/\n"
                        "const char* text = R\"(\n#include \"scene/scene_data.h\"\n)\";\n"};
    EXPECT_EQ(joined(complaints(source)), "");
}

TEST(Layers, AForeignHeaderInAHeaderOrInTheWrongRoomIsFound) {
    EXPECT_EQ(joined(complaints({"src/formats/a.h", "#include <png.h>\n"})),
              "src/formats/a.h:1: <png.h> belongs in a .cpp, not in a header");
    EXPECT_EQ(joined(complaints({"src/trace/a.cpp", "#include <fmt/format.h>\n"})),
              "src/trace/a.cpp:1: <fmt/format.h> is not for trace");
    EXPECT_EQ(
        joined(complaints({"src/render/a.cpp", "#  include <boost/any.hpp>\n"})),
        "src/render/a.cpp:1: <boost/any.hpp> is no standard header and not in the table of foreign ones");
    EXPECT_EQ(joined(complaints({"src/formats/a.cpp", "#include <png.h>\n#include <vector>\n"})), "");
}

TEST(Layers, AProgramThatLooksBehindThePublicHeadersIsFound) {
    EXPECT_EQ(joined(complaints({"apps/cli/a.cpp", "#include \"text.h\"\n#include \"glint/render.h\"\n"})),
              "");
    EXPECT_EQ(joined(complaints({"apps/cli/a.cpp", "#include \"scene/scene_data.h\"\n"})),
              "apps/cli/a.cpp:1: programs use public headers and their own, not \"scene/scene_data.h\"");
}

TEST(Layers, ProgramsDoNotIncludeEachOther) {
    EXPECT_EQ(joined(complaints({"apps/cli/pages/a.cpp", "#include \"../text.h\"\n"})), "");
    EXPECT_EQ(joined(complaints({"apps/cli/a.cpp", "#include \"../common/text.h\"\n"})), "");
    EXPECT_EQ(joined(complaints({"apps/cli/a.cpp", "#include \"../viewer/text.h\"\n"})),
              "apps/cli/a.cpp:1: programs use public headers and their own, not \"../viewer/text.h\"");
}

TEST(Layers, APublicHeaderThatNeedsAPrivateOneIsFound) {
    EXPECT_EQ(joined(complaints({"include/glint/scene.h", "#include \"math/vec.h\"\n"})),
              "include/glint/scene.h:1: a public header includes the private \"math/vec.h\"");
}

TEST(Layers, ACycleOfIncludesIsFound) {
    const std::vector<Source> cycle = {{"src/math/a.h", "#include \"math/b.h\"\n"},
                                       {"src/math/b.h", "#include \"math/c.h\"\n"},
                                       {"src/math/c.h", "#include \"math/b.h\"\n"}};
    EXPECT_EQ(joined(include_cycle(cycle), " "), "src/math/b.h src/math/c.h src/math/b.h");
}

} // namespace
} // namespace glint::house
