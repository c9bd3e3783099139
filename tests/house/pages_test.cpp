// README.md, CHANGELOG.md and the pages of docs/: what they name exists, and lines keep their width.

#include "sources.h"

#include "formats/explain/page.h"
#include "glint/formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace glint::house {
namespace {

namespace fs = std::filesystem;

/// README.md, CHANGELOG.md and all pages under docs/, from the project's root.
std::vector<std::string> pages() {
    const fs::path root = GLINT_SOURCE_DIR;
    std::vector<std::string> paths = {"README.md", "CHANGELOG.md"};
    for (const auto& entry : fs::recursive_directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md")
            paths.push_back(fs::relative(entry.path(), root).generic_string());
    return paths;
}

/// The targets of Markdown links and pictures within the project: "[text](target)", without "#section".
std::vector<std::string> links_of(const std::string& text) {
    std::vector<std::string> targets;
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
        const std::string target = text.substr(at + 2, text.find_first_of("#)", at + 2) - at - 2);
        if (!target.empty() && target.find(':') == std::string::npos) targets.push_back(target);
    }
    return targets;
}

/// The text between a line that starts with `opening` and the next ``` after it.
std::string block_of(const std::string& text, const std::string& opening) {
    const std::size_t at = text.find("\n" + opening + "\n");
    if (at == std::string::npos) return {};
    const std::size_t begin = at + opening.size() + 2;
    return text.substr(begin, text.find("```", begin) - begin);
}

/// The paths in backquotes: those with a slash. Not formulas and patterns, nor what is run as `./NAME`.
std::vector<std::string> named_paths(const std::string& text) {
    std::vector<std::string> paths;
    for (std::size_t at = text.find('`'); at != std::string::npos;) {
        const std::size_t end = text.find('`', at + 1);
        if (end == std::string::npos) break;
        const std::string code = text.substr(at + 1, end - at - 1);
        if (code.find('/') != std::string::npos && !code.starts_with("./") &&
            std::all_of(code.begin(), code.end(),
                        [](char c) { return is_word(c) || c == '/' || c == '.' || c == '-'; }))
            paths.push_back(code);
        at = text.find('`', end + 1);
    }
    return paths;
}

TEST(Pages, LinksLeadToFilesThatAreThere) {
    for (const std::string& page : pages())
        for (const std::string& target : links_of(read_project_file(page))) {
            const fs::path path = fs::path(GLINT_SOURCE_DIR) / fs::path(page).parent_path() / target;
            EXPECT_TRUE(fs::exists(path)) << page << " links to " << target;
        }
}

TEST(Pages, PathsInBackquotesExist) {
    for (const std::string& page : pages())
        for (const std::string& path : named_paths(read_project_file(page))) {
            const fs::path root = GLINT_SOURCE_DIR;
            EXPECT_TRUE(fs::exists(root / path) || fs::exists(root / "src" / path) ||
                        fs::exists(root / "include" / path))
                << page << " names " << path;
        }
}

TEST(Pages, TheTourNamesWholePaths) {
    const std::vector<std::string> paths = named_paths(read_project_file("docs/reading.md"));
    EXPECT_GT(paths.size(), 50u);
    for (const std::string& path : paths)
        EXPECT_TRUE(fs::exists(fs::path(GLINT_SOURCE_DIR) / path)) << "docs/reading.md names " << path;
}

/// Code points of UTF-8.
std::ptrdiff_t width(const std::string& line) {
    return std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; });
}

TEST(Pages, LinesHaveAtMost110CharactersButRowsOfTables) {
    for (const std::string& page : pages()) {
        int number = 0;
        for (const std::string& line : lines_of(read_project_file(page))) {
            ++number;
            if (line.starts_with('|')) continue;
            EXPECT_LE(width(line), 110) << page << ":" << number;
        }
    }
}

TEST(Pages, TheSceneOfTheReadmeIsGood) {
    const std::string scene = block_of(read_project_file("README.md"), "```toml");
    ASSERT_NE(scene, "");
    const LoadedScene loaded = parse_scene(scene, "README.md");
    EXPECT_TRUE(loaded.warnings.empty()) << to_string(loaded.warnings.front());
    const std::vector<Diagnostic> found = warnings(build_scene(loaded.description));
    EXPECT_TRUE(found.empty()) << to_string(found.front());
}

TEST(Pages, TheExplainPageEmbedsItsStyleAndScript) {
    EXPECT_EQ(formats::page_style(), read_project_file("src/formats/explain/page.css"));
    EXPECT_EQ(formats::page_script(), read_project_file("src/formats/explain/page.js"));
}

TEST(Pages, TheReadmeNamesAllScriptsAndNoOthers) {
    const std::string text = read_project_file("README.md");
    for (std::size_t at = text.find("scripts/"); at != std::string::npos;
         at = text.find("scripts/", at + 1)) {
        const std::string name = text.substr(at, text.find_first_of("` \n", at) - at);
        EXPECT_TRUE(fs::exists(fs::path(GLINT_SOURCE_DIR) / name)) << name;
    }
    for (const auto& entry : fs::directory_iterator(std::string(GLINT_SOURCE_DIR) + "/scripts"))
        EXPECT_NE(text.find("scripts/" + entry.path().filename().string()), std::string::npos)
            << entry.path();
}

} // namespace
} // namespace glint::house
