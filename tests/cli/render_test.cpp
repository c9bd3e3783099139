// What render writes, and where it says what.

#include "cli_test.h"

#include <nlohmann/json.hpp>

#include <set>
#include <unistd.h>

namespace glint::test {
namespace {

const std::string png_signature = "\x89PNG\r\n\x1a\n";

/// Every run of digits, with its points, told as one #: what a line says, whatever it measured.
std::string without_numbers(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        const bool digit = (c >= '0' && c <= '9') || (c == '.' && !plain.empty() && plain.back() == '#');
        if (!digit)
            plain += c;
        else if (plain.empty() || plain.back() != '#')
            plain += '#';
    }
    return plain;
}

/// The pixels' hash in the closing line: 32 hexadecimal digits, or "none".
std::string hash_of(const Outcome& outcome) {
    const std::string word = "hash ", digits = "0123456789abcdef";
    const std::size_t at = outcome.err.rfind(word);
    if (at == std::string::npos) return "none";
    const std::size_t begin = at + word.size(), end = outcome.err.find_first_not_of(digits, begin);
    return end == begin + 32 && outcome.err[end] == '\n' ? outcome.err.substr(begin, 32) : "none";
}

class Render : public CliTest {};

TEST_F(Render, WarnsOfABlackPicture) {
    const Outcome dim = glint("good.toml -D light.0.intensity=1e-9 -o a.png");
    EXPECT_EQ(dim.exit, 0);
    EXPECT_NE(dim.err.find("warning: the picture is all but black"), std::string::npos) << dim.err;
    EXPECT_EQ(glint("good.toml -o a.png").err.find("black"), std::string::npos);
    EXPECT_EQ(glint("good.toml -D light.0.intensity=1e-9 --show normal -o a.png").err.find("black"),
              std::string::npos);
}

TEST_F(Render, TurnsABareMeshSixWays) {
    std::set<std::string> pictures;
    for (const char* up : {"x", "y", "z", "-x", "-y", "-z"}) {
        const std::string options = std::string(" --up ") + up + " --size 32x24 --spp 1 -q -o ";
        const Outcome outcome = glint("mesh.ply" + options + "a.pfm");
        ASSERT_EQ(outcome.exit, 0) << up << ": " << outcome.err;
        pictures.insert(content("a.pfm"));
        Setting setting;
        setting.input = content("mesh.ply");
        ASSERT_EQ(glint("-" + options + "b.pfm", setting).exit, 0) << up;
        EXPECT_EQ(content("b.pfm"), content("a.pfm")) << up << ", from stdin";
    }
    EXPECT_EQ(pictures.size(), 6u);
}

TEST_F(Render, WithoutACommandIsRender) {
    EXPECT_EQ(glint("good.toml -o a.png").exit, 0);
    EXPECT_EQ(glint("render good.toml -o b.png").exit, 0);
    EXPECT_EQ(content("a.png").substr(0, 8), png_signature);
    EXPECT_EQ(content("a.png"), content("b.png"));
}

TEST_F(Render, ClosesWithOneLineThatSaysWhatWasDone) {
    const Outcome outcome = glint("good.toml --spp 4 -o a.png");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.out, "");
    const std::string hash = hash_of(outcome);
    EXPECT_EQ(hash.size(), 32u) << outcome.err;
    const std::string end = ", hash " + hash + "\n";
    ASSERT_GT(outcome.err.size(), end.size());
    const std::string measured = outcome.err.substr(0, outcome.err.size() - end.size());
    EXPECT_EQ(without_numbers(measured), "a.png: #×#, # spp, # object, # s, # Mrays/s");
    EXPECT_EQ(measured.rfind("a.png: 16×12, 4 spp, 1 object, ", 0), 0u) << outcome.err;
}

TEST_F(Render, TakesMoreSamplesWhereNeighboursDiffer) {
    const Outcome outcome = glint("good.toml --spp 1..16 --stats s.json -o a.pfm");
    EXPECT_NE(outcome.err.find("a.pfm: 16×12, 1..16 spp, "), std::string::npos) << outcome.err;
    const auto stats = nlohmann::json::parse(content("s.json"));
    EXPECT_GT(stats["samples_per_pixel"], 1.0);
    EXPECT_LT(stats["samples_per_pixel"], 16.0);
    ASSERT_EQ(glint("good.toml --spp 16 -o b.pfm -D render.max_spp=64").exit, 0);
    EXPECT_EQ(hash_of(glint("good.toml --spp 16 -o c.pfm")),
              hash_of(glint("good.toml --spp 16..16 -o d.pfm")));
    EXPECT_EQ(content("b.pfm"), content("c.pfm")) << "a fixed number ends adaptive samples";
    EXPECT_EQ(hash_of(glint("good.toml --spp 1..8 -o e.pfm")),
              hash_of(glint("good.toml -D render.spp=auto -o e.pfm")));
    EXPECT_EQ(hash_of(glint("good.toml -D render.spp=16 -o e.pfm")),
              hash_of(glint("good.toml --spp 16 -o e.pfm")));
}

TEST_F(Render, ShowsMoreThanTheLight) {
    const std::string light = hash_of(glint("good.toml -o a.png"));
    EXPECT_EQ(hash_of(glint("good.toml --show final -o a.png")), light);
    EXPECT_NE(hash_of(glint("good.toml --show normal -o a.png")), light);
    const Outcome unknown = glint("good.toml --show normla -o a.png");
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_NE(unknown.err.find("did you mean \"normal\"?"), std::string::npos) << unknown.err;
    EXPECT_EQ(glint("good.toml --show depth --alpha -o a.png").exit, 2);
}

TEST_F(Render, KernelsAndVectorsShowInNoBit) {
    const std::string hash = hash_of(glint("good.toml -o a.png"));
    EXPECT_EQ(hash.size(), 32u);
    for (const std::string option : {"--kernel scalar", "--kernel single", "--kernel stream", "--simd plain",
                                     "--kernel packet --simd plain"})
        EXPECT_EQ(hash_of(glint("good.toml " + option + " -o a.png")), hash) << option;
}

TEST_F(Render, CountsTheTrianglesOfAMesh) {
    const Outcome outcome = glint("mesh.ply --size 8x8 --spp 1");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("mesh.png: 8×8, 1 spp, 4 triangles, "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("note: "), std::string::npos) << "the guess of the up axis is said\n"
                                                             << outcome.err;
}

TEST_F(Render, NamesThePictureAfterTheSceneInTheWorkingFolder) {
    write("empty/nested.toml", content("good.toml"));
    const Outcome outcome = glint("empty/nested.toml");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_TRUE(exists("nested.png"));
    EXPECT_EQ(outcome.err.rfind("nested.png: ", 0), 0u) << outcome.err;
}

TEST_F(Render, ReadsASceneFromStdin) {
    Setting setting;
    setting.input = content("good.toml");
    EXPECT_EQ(glint("-", setting).exit, 0);
    EXPECT_EQ(content("stdin.png").substr(0, 8), png_signature);
}

TEST_F(Render, ReadsAMeshFromStdinWithTheUpAxisThatItsNoteNames) {
    Setting setting;
    setting.input = content("mesh.ply");
    const Outcome guessed = glint("- --size 8x8", setting);
    EXPECT_EQ(guessed.exit, 0) << guessed.err;
    const std::size_t flag = guessed.err.find("--up ");
    ASSERT_NE(flag, std::string::npos) << guessed.err;
    const Outcome chosen = glint("- --size 8x8 " + guessed.err.substr(flag, 6), setting);
    EXPECT_EQ(chosen.exit, 0) << chosen.err;
    setting.input = content("good.toml");
    EXPECT_EQ(glint("- --up y", setting).exit, 2);
}

TEST_F(Render, WritesNothingButThePictureToStdout) {
    EXPECT_EQ(glint("good.toml -o a.png").exit, 0);
    const Outcome outcome = glint("good.toml -v -o -");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.out, content("a.png"));
    EXPECT_NE(outcome.err.find("stdout: 16×12"), std::string::npos) << outcome.err;
}

TEST_F(Render, FailsWhenStdoutIsFull) {
    Setting setting;
    setting.out_file = "/dev/full";
    const Outcome outcome = glint("good.toml -o -", setting);
    EXPECT_EQ(outcome.exit, 4);
    EXPECT_NE(outcome.err.find("error: "), std::string::npos) << outcome.err;
}

TEST_F(Render, RefusesAnEmptyName) {
    const Outcome outcome = run_glint({""}, {});
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_NE(outcome.err.find("a name is empty"), std::string::npos) << outcome.err;
}

TEST_F(Render, TakesAFileNamedLikeACommand) {
    write("check", content("good.toml"));
    const Outcome outcome = glint("./check -o a.png");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_TRUE(exists("a.png"));
}

TEST_F(Render, OverwritesAnOlderPictureAndLeavesNoOtherFile) {
    const std::string before = listing();
    write("good.png", "older");
    EXPECT_EQ(glint("good.toml").exit, 0);
    EXPECT_EQ(content("good.png").substr(0, 8), png_signature);
    std::filesystem::remove(path("good.png"));
    EXPECT_EQ(listing(), before);
}

TEST_F(Render, IsSilentWhenQuiet) {
    const Outcome outcome = glint("dark.toml -q");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_TRUE(exists("dark.png"));
}

TEST_F(Render, WarnsOfDarkness) {
    const Outcome outcome = glint("dark.toml");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_NE(outcome.err.find("warning: "), std::string::npos) << outcome.err;
}

TEST_F(Render, SaysMoreWhenVerbose) {
    const Outcome outcome = glint("good.toml -v");
    EXPECT_NE(outcome.err.find("rays: 192 primary, "), std::string::npos) << outcome.err;
}

TEST_F(Render, MakesTheSamePictureOnAnyNumberOfThreadsAndTiles) {
    const std::string hash = hash_of(glint("good.toml --size 64x48 --spp 4 -t 1"));
    EXPECT_NE(hash, "none");
    EXPECT_EQ(hash_of(glint("good.toml --size 64x48 --spp 4 --threads 64 --tile-size 3")), hash);
    EXPECT_NE(hash_of(glint("good.toml --size 64x48 --spp 4 --seed 1")), hash);
}

TEST_F(Render, RunsAsManyThreadsAsAsked) {
    ASSERT_EQ(glint("good.toml --size 64x64 --tile-size 4 --threads 64 --stats s.json").exit, 0);
    EXPECT_EQ(nlohmann::json::parse(content("s.json"))["threads"], 64);
}

TEST_F(Render, CropsAPartOfTheWhole) {
    EXPECT_EQ(glint("good.toml -o a.pfm --crop 4,3,8,6").exit, 0);
    EXPECT_EQ(content("a.pfm").rfind("PF\n8 6\n", 0), 0u);
}

TEST_F(Render, TellsItsStatisticsAsJson) {
    ASSERT_EQ(glint("good.toml --spp 4 --max-depth 3 --stats s.json").exit, 0);
    const auto stats = nlohmann::json::parse(content("s.json"));
    EXPECT_EQ(stats["file"], "good.toml");
    EXPECT_EQ(stats["output"], "good.png");
    EXPECT_EQ(stats["width"], 16);
    EXPECT_EQ(stats["height"], 12);
    EXPECT_EQ(stats["complete"], true);
    EXPECT_EQ(stats["scene"]["spheres"], 1);
    EXPECT_EQ(stats["rays"]["primary"], 16 * 12 * 4);
    EXPECT_EQ(stats["left_out"]["rays"], 0);
    EXPECT_EQ(stats["left_out"]["share"], 0.0);
    EXPECT_EQ(stats["settings"]["max_depth"], 3);
    EXPECT_EQ(stats["settings"]["min_weight"], 1e-5);
    EXPECT_EQ(stats["hash"].get<std::string>().size(), 32u);
    EXPECT_GE(stats["seconds"]["total"].get<double>(), stats["seconds"]["render"].get<double>());
}

TEST_F(Render, PrintsStatisticsToStdout) {
    const Outcome outcome = glint("good.toml --stats -");
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["hash"], hash_of(outcome));
}

TEST_F(Render, PutsTheTermsIntoLayers) {
    if (!GLINT_EXR) GTEST_SKIP() << "built without OpenEXR";
    EXPECT_EQ(glint("good.toml -o a.exr --layers --alpha").exit, 0);
    const std::string file = content("a.exr");
    for (const char* layer :
         {"ambient.R", "diffuse.R", "highlight.R", "clamp.R", "reflection.R", "transmission.R", "emission.R"})
        EXPECT_NE(file.find(layer), std::string::npos) << layer;
}

TEST_F(Render, PutsTheCoverageIntoAlpha) {
    EXPECT_EQ(glint("good.toml -o a.png --alpha --bits 16").exit, 0);
    // IHDR: 16 bits, colour type 6 is RGB with alpha.
    EXPECT_EQ(content("a.png").substr(24, 2), "\x10\x06");
    // A bare mesh then stands on no floor.
    const auto objects = [&](const std::string& options) {
        return nlohmann::json::parse(
            glint("mesh.ply --size 16x12 --stats - " + options).out)["scene"]["objects"];
    };
    EXPECT_EQ(objects(""), 2);
    EXPECT_EQ(objects("--alpha"), 1);
}

TEST_F(Render, ReportsProgressAsJson) {
    const Outcome outcome = glint("good.toml --progress json");
    const std::string first = outcome.err.substr(0, outcome.err.find('\n'));
    EXPECT_EQ(nlohmann::json::parse(first)["event"], "progress") << outcome.err;
    const std::string last = outcome.err.substr(outcome.err.rfind('\n', outcome.err.size() - 2) + 1);
    const auto picture = nlohmann::json::parse(last);
    EXPECT_EQ(picture["event"], "picture");
    EXPECT_EQ(picture["output"], "good.png");
    EXPECT_EQ(picture["complete"], true);
    EXPECT_EQ(picture["hash"].get<std::string>().size(), 32u);
}

TEST_F(Render, SetsValuesOfTheScene) {
    const std::string hash = hash_of(glint("good.toml"));
    EXPECT_NE(hash_of(glint("good.toml -D light.0.intensity=10")), hash);
    EXPECT_EQ(hash_of(glint("good.toml -D light.0.intensity=10 -D light.0.intensity=30")), hash);
}

TEST_F(Render, PaintsMessagesOnlyWhenWanted) {
    const std::string escape = "\x1b[";
    EXPECT_EQ(glint("bad.toml").err.find(escape), std::string::npos) << "not on a pipe";
    EXPECT_NE(glint("bad.toml --color always").err.find(escape), std::string::npos);
}

TEST_F(Render, RefusesAKindOfPictureThatWasNotBuilt) {
    if (GLINT_EXR) GTEST_SKIP() << "built with OpenEXR";
    const Outcome outcome = glint("long.toml -o a.exr");
    EXPECT_EQ(outcome.exit, 4);
    EXPECT_NE(outcome.err.find("built without OpenEXR"), std::string::npos) << outcome.err;
}

TEST_F(Render, RefusesAPictureBeyondTheMemory) {
    const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
    const double memory = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (!GLINT_EXR || memory > 96.0 * (1 << 30)) GTEST_SKIP() << "no picture is too large for this machine";
    const Outcome outcome = glint("good.toml --size 65536x16384 --layers -o a.exr");
    EXPECT_EQ(outcome.exit, 5) << outcome.err;
    EXPECT_NE(outcome.err.find("render in parts with --crop"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace glint::test
