// Words that must not appear: banned ones with the reason, retired names with the replacement.

#include "sources.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::house {
namespace {

const std::vector<std::string> code_folders = {"include", "src",   "apps",    "tools",
                                               "tests",   "bench", "examples"};

/// A word that must not stand in the code (comments and literals aside) of some folders.
struct Ban {
    std::vector<std::string> words;
    std::vector<std::string> folders;
    std::string reason;
    std::vector<std::string> except; ///< files in which it may stand
};

const std::vector<Ban>& bans() {
    static const std::vector<Ban> table = {
        {{"printf", "fprintf", "puts", "std::cout", "std::cerr", "std::clog", "exit", "_exit", "quick_exit",
          "abort", "getenv", "setlocale"},
         {"src"},
         "nothing below the programs prints, exits or reads the environment",
         {}},
        {{"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "pow", "exp", "exp2", "log", "log2", "cbrt",
          "hypot", "fma"},
         {"src"},
         "the picture must not depend on the machine's mathematics",
         {"src/math/", "src/imaging/compare.cpp"}},
        {{"rand", "srand", "std::random_device", "std::mt19937", "std::shuffle"},
         {"src"},
         "random numbers are a function of seed, pixel, sample and dimension",
         {}},
        {{"virtual"}, {"src"}, "closed sets are values", {}},
        {{"std::unordered_map", "std::unordered_set"},
         {"src"},
         "the order of a hash table depends on the library",
         {}},
    };
    return table;
}

/// The position of a word, at or after `from`: whole, and neither a member nor of a namespace or class of
/// ours, unless the word itself names its namespace. With std:: and glm:: before it, it counts.
std::size_t find_word(const std::string& code, const std::string& word, std::size_t from) {
    for (std::size_t at = code.find(word, from); at != std::string::npos; at = code.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if (end < code.size() && is_word(code[end])) continue;
        if (at == 0) return at;
        const char before = code[at - 1];
        if (is_word(before) || before == '.' || before == '>') continue;
        const std::string space = at >= 5 ? code.substr(at - 5, 5) : "";
        if (before != ':' || space == "std::" || space == "glm::") return at;
    }
    return std::string::npos;
}

/// A name with a call after it, or one that needs none.
bool counts(const std::string& code, std::size_t end, const std::string& word) {
    if (word == "virtual" || word.find("::") != std::string::npos) return true;
    return end < code.size() && code[end] == '(';
}

bool excepted(const Ban& ban, const std::string& path) {
    return std::any_of(ban.except.begin(), ban.except.end(),
                       [&](const std::string& prefix) { return path.starts_with(prefix); });
}

/// "path:line: word: reason" for every breach of a ban.
std::string breaches(const Ban& ban, const Source& source) {
    std::string out;
    if (excepted(ban, source.path)) return out;
    const std::string code = code_only(source.text);
    for (const std::string& word : ban.words)
        for (std::size_t at = find_word(code, word, 0); at != std::string::npos;
             at = find_word(code, word, at + 1))
            if (counts(code, at + word.size(), word))
                out += source.path + ":" + std::to_string(line_at(code, at)) + ": " + word + ": " +
                       ban.reason + "\n";
    return out;
}

/// An identifier that had a home-made name, and the word of the field that replaced it.
struct Retired {
    std::string name; ///< whole, or all that begin with it: "most_*"
    std::string use;
    std::vector<std::string> except{}; ///< files in which it may stand
};

/// A row is added when the last use is gone, so that the name does not return. Sorted.
const std::vector<Retired>& retired_names() {
    static const std::vector<Retired> table = {
        {"Ahead", "CullMask"},
        {"Answered", "ExpectedHits"},
        {"Aspect", "Aov"},
        {"Claim", "Property"},
        {"Desk", "Backend"},
        {"DeviceRun", "DeviceExecutor"},
        {"Easel", "ViewSlot"},
        {"FieldOfViewAxis", "FovAxis"},
        {"FilterKind", "PixelFilter"},
        {"Flights", "PathStates"},
        {"FreezeOptions", "BuildSceneOptions"},
        {"FrozenLight", "LightRecord"},
        {"FrozenMaterial", "MaterialRecord"},
        {"FrozenObject", "ObjectData"},
        {"FrozenScene", "SceneData"},
        {"GpuStudio", "GpuDeviceState"},
        {"LoneRay", "SingleRay"},
        {"Media", "InteriorList"},
        {"NumberedPlane", "PlanePrim"},
        {"ObjectPlaces", "ObjectPositions"},
        {"Offence", "TextFault"},
        {"Pace", "DispatchBudget"},
        {"Painter", "ViewRenderer"},
        {"PixelPlace", "PixelCoord"},
        {"Place", "SourcePos, Pixel, or what it is"},
        {"PlacedMesh", "InstanceData"},
        {"Placement", "ScaledOffset"},
        {"Quad", "float4"},
        {"QuadBox", "SimdBounds"},
        {"QuadInts", "int4"},
        {"Reach", "PacketBounds"},
        {"Ref", "PrimRef"},
        {"Sameness", "VertexIdentity"},
        {"SamplePlaces", "CameraSampler"},
        {"Stage", "preview scene"},
        {"SurfaceName", "QuadricRef"},
        {"TroubleRays", "DifficultRays"},
        {"Wish", "RenderRequest"},
        {"Workbench", "SceneEditor"},
        {"ahead_of", "cull_mask"},
        {"aim", "the ray that it makes"},
        {"aspect_name", "aov_name"},
        {"bring", "add_to_parent"},
        {"crossings", "all_hits, or depth_complexity"},
        {"fewest_*", "min_*"},
        {"freeze", "build_scene"},
        {"frozen", "scene_data"},
        {"greatest_*", "max_*"},
        {"in_marks", "quoted"},
        {"largest_*", "max_*", {"apps/cli/json_output.cpp", "docs/cli.md", "tests/cli/backend_test.cpp"}},
        {"layings", "upload_count"},
        {"least_*", "min_*"},
        {"lone_kernels", "single_kernels"},
        {"most_*", "max_*"},
        {"no_child", "invalid_index"},
        {"no_instance", "invalid_index"},
        {"no_root", "invalid_index"},
        {"no_surface", "invalid_index"},
        {"no_triangle", "invalid_index"},
        {"nobody", "invalid_index"},
        {"politeness", "nice_level"},
        {"rays_told", "rays_reported"},
        {"refreeze", "update_scene"},
        {"return_room", "return_unused"},
        {"stage_mesh", "load_preview"},
        {"studio_light", "preview_light"},
        {"thrift", "leaf_memory_cost"},
        {"understand", "interpret_header"},
        {"wide_leaf", "max_leaf_size"},
    };
    return table;
}

/// Whether no English word looks like this: `FrozenScene`, `most_*`. Single words such as `freeze` and
/// `Reach` are good prose.
bool is_compound(const std::string& name) {
    return name.find('_') != std::string::npos ||
           std::any_of(name.begin() + 1, name.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// "path:line: name: use ..." for every use of a retired name in the text of a file.
std::string uses_of(const Retired& retired, const std::string& path, const std::string& text) {
    const bool is_prefix = retired.name.back() == '*';
    const std::string name = retired.name.substr(0, retired.name.size() - (is_prefix ? 1 : 0));
    std::string out;
    if (std::find(retired.except.begin(), retired.except.end(), path) != retired.except.end()) return out;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool begins = at == 0 || !is_word(text[at - 1]);
        const bool ends = is_prefix || end == text.size() || !is_word(text[end]);
        if (begins && ends)
            out += path + ":" + std::to_string(line_at(text, at)) + ": " + retired.name + ": use " +
                   retired.use + "\n";
    }
    return out;
}

/// Compound names are searched in the whole text, single words in code alone.
std::string retired_names_in(const Source& source, bool is_code) {
    const std::string code = is_code ? code_only(source.text) : "";
    std::string out;
    for (const Retired& retired : retired_names())
        out += uses_of(retired, source.path, is_compound(retired.name) ? source.text : code);
    return out;
}

TEST(Words, RetiredNamesDoNotReturn) {
    std::string all;
    for (const Source& source : sources_under(code_folders, {".h", ".cpp", ".glsl", ".js", ".css"}))
        if (source.path != "tests/house/words_test.cpp") all += retired_names_in(source, true);
    // Pages, build files and scripts, of which some have no extension.
    for (const std::vector<std::string>& folders : {code_folders, {"docs", "cmake", "scripts"}})
        for (const Source& source : sources_under(folders, {".md", ".txt", ".cmake", ""}))
            all += retired_names_in(source, false);
    for (const std::string path : {"README.md", "CHANGELOG.md", "CMakeLists.txt"})
        all += retired_names_in({path, read_project_file(path)}, false);
    EXPECT_EQ(all, "");
}

TEST(Words, CodeUsesNothingThatIsBannedInItsRoom) {
    std::string all;
    for (const Ban& ban : bans())
        for (const Source& source : sources_under(ban.folders)) all += breaches(ban, source);
    EXPECT_EQ(all, "");
}

TEST(Words, NothingIsMarkedAsUnfinished) {
    // Written in halves, so that this file does not name what it looks for.
    const std::vector<std::string> marks = {std::string("TO") + "DO", std::string("FIX") + "ME",
                                            std::string("not imple") + "mented"};
    for (const Source& source : sources_under(code_folders))
        for (const std::string& mark : marks) {
            const std::size_t at = source.text.find(mark);
            EXPECT_EQ(at, std::string::npos)
                << source.path << ":" << line_at(source.text, at) << ": " << mark;
        }
}

TEST(Words, NoPathOfOneMachineIsNamed) {
    for (const Source& source : sources_under(code_folders))
        for (const std::string folder : {"home", "root", "work", "Users"}) {
            const std::string path = "/" + folder + "/";
            const std::size_t at = source.text.find("\"" + path);
            EXPECT_EQ(at, std::string::npos)
                << source.path << ":" << line_at(source.text, at) << ": " << path;
        }
}

TEST(Words, EveryHeaderIsGuarded) {
    for (const Source& source : sources_under(code_folders)) {
        if (!source.path.ends_with(".h")) continue;
        // Headers that GLSL reads too have no #pragma, and those compiled once a SIMD target toggle their
        // guard.
        const std::string code = code_only(source.text);
        EXPECT_TRUE(code.find("#pragma once") != std::string::npos ||
                    code.find("#ifndef GLINT_") != std::string::npos ||
                    code.find("HWY_TARGET_TOGGLE") != std::string::npos)
            << source.path;
    }
}

// The check itself.

TEST(Words, ABrokenBanIsFoundWithItsLine) {
    const Ban ban{{"exp", "std::cout", "virtual"}, {"src"}, "why", {"src/math/"}};
    EXPECT_EQ(breaches(ban, {"src/a.cpp", "int a;\nfloat b = std::exp(c);\n"}), "src/a.cpp:2: exp: why\n");
    EXPECT_EQ(breaches(ban, {"src/a.cpp", "void f() { std::cout << 1; }\nvirtual void g();\n"}),
              "src/a.cpp:1: std::cout: why\nsrc/a.cpp:2: virtual: why\n");
    EXPECT_EQ(breaches(ban, {"src/a.cpp",
                             "// exp(1)\nauto s = \"exp(1)\"; o.exp(1); my_exp(1); exp2(1); Exp::exp(1);"}),
              "");
    EXPECT_EQ(breaches(ban, {"src/math/a.cpp", "exp(1)"}), "");
}

TEST(Words, ARetiredNameIsFoundWithItsLineAndReplacement) {
    const std::string code = code_only("int quad; // Quad\nQuad q = least(\"Quad\");\nfloat most_far;\n");
    EXPECT_EQ(uses_of({"Quad", "float4"}, "src/a.cpp", code), "src/a.cpp:2: Quad: use float4\n");
    EXPECT_EQ(uses_of({"most_*", "max_"}, "src/a.cpp", code), "src/a.cpp:3: most_*: use max_\n");
    EXPECT_EQ(uses_of({"least_*", "min_"}, "src/a.cpp", code), "");
    EXPECT_EQ(uses_of({"Quad", "float4", {"src/a.cpp"}}, "src/a.cpp", code), "");
}

TEST(Words, CompoundRetiredNamesAreFoundInCommentsAndPages) {
    EXPECT_EQ(retired_names_in({"a.cpp", "// FrozenScene out of Reach\n"}, true),
              "a.cpp:1: FrozenScene: use SceneData\n");
    EXPECT_EQ(retired_names_in({"a.md", "At `most_bytes`: freeze.\n"}, false), "a.md:1: most_*: use max_*\n");
    EXPECT_EQ(retired_names_in({"a.cpp", "freeze(); // freeze\n"}, true),
              "a.cpp:1: freeze: use build_scene\n");
}

} // namespace
} // namespace glint::house
