// Files and functions stay small enough to be read at once.

#include "sources.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::house {
namespace {

const std::vector<std::string> everywhere = {"include", "src", "apps", "tools", "tests", "bench", "examples"};

struct Placed {
    std::string path;
    Function function;
};

/// All functions but the excused ones, longest first.
std::vector<Placed> all_functions() {
    std::vector<Placed> all;
    for (const Source& source : sources_under(everywhere))
        for (const Function& function : functions_of(source.text))
            if (!function.excused) all.push_back({source.path, function});
    std::stable_sort(all.begin(), all.end(), [](const Placed& a, const Placed& b) {
        return a.function.lines() > b.function.lines();
    });
    return all;
}

/// The functions of more than `lines` lines, one a line of text.
std::string longer_than(const std::vector<Placed>& functions, int lines) {
    std::string out;
    for (const Placed& placed : functions)
        if (placed.function.lines() > lines)
            out += placed.path + ":" + std::to_string(placed.function.first) + ": " +
                   std::to_string(placed.function.lines()) + " lines: " + placed.function.name + "\n";
    return out;
}

TEST(Sizes, NoFileHasMoreThan500Lines) {
    for (const Source& source : sources_under(everywhere))
        EXPECT_LE(lines_of(source.text).size(), 500u) << source.path;
}

TEST(Sizes, NineOfTenFunctionsHaveAtMost30Lines) {
    const std::vector<Placed> functions = all_functions();
    ASSERT_GT(functions.size(), 100u) << "the functions were not found";
    EXPECT_LE(functions[functions.size() / 10].function.lines(), 30) << longer_than(functions, 30);
}

TEST(Sizes, OneFunctionInFiftyHasMoreThan60LinesAndNoneMoreThan100) {
    const std::vector<Placed> functions = all_functions();
    const auto long_ones = static_cast<std::size_t>(std::count_if(
        functions.begin(), functions.end(), [](const Placed& p) { return p.function.lines() > 60; }));
    EXPECT_LE(long_ones * 50, functions.size()) << longer_than(functions, 60);
    EXPECT_EQ(longer_than(functions, 100), "");
}

// The scanner itself.

std::string shapes_of(const std::string& text) {
    std::string out;
    for (const Function& f : functions_of(text))
        out += f.name + " " + std::to_string(f.first) + "-" + std::to_string(f.last) +
               (f.excused ? " excused" : "") + "\n";
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

TEST(Sizes, AReasonRightAboveExcusesAFunctionAndOnlyThat) {
    EXPECT_EQ(
        shapes_of(
            "/// Adds.\n// long: one line an axis reads better than a loop\nint f() {\n}\n\nint g() {\n}\n"),
        "int f() 3-4 excused\nint g() 6-7\n");
}

} // namespace
} // namespace glint::house
