// Limits on the sizes of files and functions.

#include "sources.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::house {
namespace {

const std::vector<std::string> everywhere = {"include", "src", "apps", "tools", "tests", "bench", "examples"};

/// Each language is measured separately: GLSL and JavaScript have few functions beside those of C++.
struct Language {
    std::string name;
    std::vector<std::string> folders;
    std::vector<std::string> extensions;
};

const std::vector<Language>& languages() {
    static const std::vector<Language> table = {
        {"C++", everywhere, {".h", ".cpp"}},
        {"GLSL", {"src"}, {".glsl"}},
        {"JavaScript", {"src"}, {".js"}},
    };
    return table;
}

struct Located {
    std::string path;
    Function function;
};

/// All functions of a language, longest first.
std::vector<Located> all_functions(const Language& language) {
    std::vector<Located> all;
    for (const Source& source : sources_under(language.folders, language.extensions))
        for (const Function& function : functions_of(source.text)) all.push_back({source.path, function});
    std::stable_sort(all.begin(), all.end(), [](const Located& a, const Located& b) {
        return a.function.lines() > b.function.lines();
    });
    return all;
}

/// The functions of more than `lines` lines, one a line of text.
std::string longer_than(const std::vector<Located>& functions, int lines) {
    std::string out;
    for (const Located& located : functions)
        if (located.function.lines() > lines)
            out += located.path + ":" + std::to_string(located.function.first) + ": " +
                   std::to_string(located.function.lines()) + " lines: " + located.function.name + "\n";
    return out;
}

TEST(Sizes, NoFileHasMoreThan500Lines) {
    for (const Language& language : languages())
        for (const Source& source : sources_under(language.folders, language.extensions))
            EXPECT_LE(lines_of(source.text).size(), 500u) << source.path;
}

TEST(Sizes, NineOfTenFunctionsHaveAtMost30Lines) {
    for (const Language& language : languages()) {
        const std::vector<Located> functions = all_functions(language);
        ASSERT_GT(functions.size(), 15u) << "the functions of " << language.name << " were not found";
        EXPECT_LE(functions[functions.size() / 10].function.lines(), 30) << longer_than(functions, 30);
    }
}

TEST(Sizes, OneFunctionInAHundredHasMoreThan60LinesAndNoneMoreThan100) {
    for (const Language& language : languages()) {
        const std::vector<Located> functions = all_functions(language);
        const auto long_ones = static_cast<std::size_t>(
            std::count_if(functions.begin(), functions.end(),
                          [](const Located& located) { return located.function.lines() > 60; }));
        EXPECT_LE(long_ones * 100, functions.size()) << longer_than(functions, 60);
        EXPECT_EQ(longer_than(functions, 100), "");
    }
}

// The scanner itself.

std::string shapes_of(const std::string& text) {
    std::string out;
    for (const Function& f : functions_of(text))
        out += f.name + " " + std::to_string(f.first) + "-" + std::to_string(f.last) + "\n";
    return out;
}

TEST(Sizes, TheScannerFindsFunctionsOfEveryForm) {
    EXPECT_EQ(shapes_of("namespace a {\n"
                        "int f(int x = {}) {\n    return [&] { return x; }();\n}\n"
                        "struct B : C<decltype(f(1))> {\n"
                        "    B() : a_{1}, b_(2) {\n    }\n"
                        "    bool operator==(const B& o) const { return true; }\n"
                        "  private:\n"
                        "    template <class T>\n    auto g() const -> T\n    {\n    }\n"
                        "    int a_ = 1, b_{2};\n"
                        "};\n"
                        "}\n"
                        "TEST(X, Y) {\n}\n"),
              "int f(int x = {}) 2-4\n"
              "B() : a_{1}, b_(2) 6-7\n"
              "bool operator==(const B& o) const 8-8\n"
              "template <class T> auto g() const -> T 10-13\n"
              "TEST(X, Y) 17-18\n");
}

TEST(Sizes, TheScannerIsNotMisledByLiteralsCommentsOrMacros) {
    EXPECT_EQ(shapes_of("const char* a = \"void f() {\"; // void g() {\n"
                        "const char* b = R\"x(void h() { )\" } )x\";\n"
                        "const char c = '{'; const int d = 1'000;\n"
                        "#define OPEN void i() { \\\n    {\n"
                        "/* void j() { */\n"
                        "void k() {\n    const char* s = \"}\\\"}\";\n}\n"),
              "void k() 7-9\n");
}

TEST(Sizes, TablesAreNoFunctionsButLambdasAre) {
    EXPECT_EQ(shapes_of("const Row table[] = {\n    {\"a\", [](int x) { return x; }},\n};\n"
                        "const auto f = [](int x) {\n    return x;\n};\n"),
              "const auto f = [](int x) 4-6\n");
}

TEST(Sizes, TheScannerReadsShaders) {
    EXPECT_EQ(shapes_of("layout(std140) uniform Settings {\n    vec4 eye;\n};\n"
                        "#if TERMS\nvoid main() {\n    if (x) { y(); }\n}\n#endif\n"),
              "void main() 5-7\n");
}

TEST(Sizes, TheScannerReadsScripts) {
    EXPECT_EQ(
        shapes_of("const table = { a: x => x, b: 1 };\nconst ready = unpack().then(() => {\n  go();\n});\n"
                  "async function f(x) { // `\n  return `{${x}\n`;\n}\n"
                  "const g = (a, b) => {\n  return a;\n};\n"),
        "const ready = unpack().then(() => 2-4\n"
        "async function f(x) 5-8\n"
        "const g = (a, b) => 9-11\n");
}

} // namespace
} // namespace glint::house
