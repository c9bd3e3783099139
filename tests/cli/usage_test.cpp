// What the command line takes and refuses. A new case is a line of the table.

#include "cli_test.h"

#include <algorithm>
#include <sstream>

namespace glint::test {
namespace {

struct Case {
    const char* name; ///< the claim
    const char* line; ///< what follows `glint`
    int exit;
    const char* says; ///< must stand in what it prints: on stdout for exit 0 and 1, else on stderr
};

void PrintTo(const Case& c, std::ostream* out) { *out << "glint " << c.line; }

class CommandLine : public CliTest, public testing::WithParamInterface<Case> {};

TEST_P(CommandLine, EndsAsItShould) {
    const Case& c = GetParam();
    const Outcome outcome = glint(c.line);
    EXPECT_EQ(outcome.exit, c.exit) << outcome.out << outcome.err;
    EXPECT_NE((c.exit <= 1 ? outcome.out : outcome.err).find(c.says), std::string::npos)
        << "expected: " << c.says << "\nstdout: " << outcome.out << "\nstderr: " << outcome.err;
    if (c.exit >= 2) {
        EXPECT_EQ(outcome.out, "") << "a failure leaves stdout empty";
        EXPECT_NE(outcome.err.find("error:"), std::string::npos) << outcome.err;
    }
}

const Case cases[] = {
    // Help and version.
    {"PrintsItsVersion", "--version", 0, "glint 0.1.0\n"},
    {"PrintsHelp", "--help", 0, "usage: glint FILE"},
    {"PrintsHelpByLetter", "-h", 0, "usage: glint FILE"},
    {"PrintsHelpBehindAScene", "good.toml --help", 0, "usage: glint FILE"},
    {"PrintsHelpOfRender", "render --help", 0, "usage: glint render FILE"},
    {"PrintsHelpOfDiff", "diff -h", 0, "within the tolerance"},
    {"NeedsAScene", "", 2, "no scene given"},
    {"NeedsASceneBesideOptions", "--spp 4", 2, "no scene given"},
    {"TakesOneScene", "good.toml dark.toml", 2, "more than one scene"},
    {"WantsTheCommandFirst", "-q render good.toml", 2, "the command comes first"},

    // Unknown names.
    {"SuggestsAnOption", "good.toml --sise 4x4", 2, "did you mean \"--size\"?"},
    {"SuggestsAnOptionWithItsValue", "good.toml --sise=4x4", 2, "unknown option \"--sise\""},
    {"SuggestsTheSecondDash", "good.toml -size 4x4", 2, "did you mean \"--size\"?"},
    {"SuggestsHelp", "-help", 2, "did you mean \"--help\"?"},
    {"SuggestsTheWholeWord", "-version", 2, "unknown option \"-version\""},
    {"SuggestsACommand", "chekc good.toml", 2, "did you mean \"check\"?"},
    {"SuggestsNothingFar", "good.toml --wireframe", 2, "see glint render --help"},
    {"KnowsNoUnbuiltShards", "good.toml --shard 1/2", 2, "unknown option \"--shard\""},
    {"KnowsNoUnbuiltTime", "good.toml --time 30s", 2, "unknown option \"--time\"\n    see glint"},
    {"KnowsNoUnbuiltCheckpoint", "good.toml --checkpoint x", 2, "unknown option \"--checkpoint\""},
    {"RefusesAnUnknownBackend", "good.toml --backend vulkan", 2, "expected cpu, gpu, auto"},
    {"KnowsNoUnbuiltMerge", "merge a b", 2, "neither a command"},
    {"KnowsNoUnbuiltConvert", "convert a b", 2, "neither a command"},
    {"KnowsOptionsOfTheCommandOnly", "check good.toml --spp 4", 2, "see glint check --help"},

    // Values.
    {"RefusesASizeOfOneNumber", "good.toml --size 64", 2, "WxH such as 1280x720"},
    {"RefusesAnEmptySize", "good.toml --size 0x4", 2, "from 1 to 65536"},
    {"RefusesAHugeSize", "good.toml --size 65536x65536", 2, "1,073,741,824 pixels"},
    {"RefusesWordsForNumbers", "good.toml --spp many", 2, "--spp \"many\""},
    {"RefusesNoSamples", "good.toml --spp 0", 2, "from 1 to 1048576"},
    {"RefusesAFractionOfASample", "good.toml --spp 1.5", 2, "a whole number"},
    {"RefusesFewerSamplesThanTheFewest", "good.toml --spp 16..4", 2, "such as 1..16"},
    {"RefusesSamplesWithoutAnEnd", "good.toml --spp 16..", 2, "such as 1..16"},
    {"RefusesANegativeDepth", "good.toml --max-depth -1", 2, "from 0 to 1000"},
    {"RefusesANegativeSeed", "good.toml --seed -1", 2, "at least 0"},
    {"RefusesTooManyThreads", "good.toml -t 5000", 2, "from 0 to 1024"},
    {"RefusesAnUnknownIntegrator", "good.toml --integrator radiosity", 2, "expected whitted"},
    {"SuggestsAnIntegrator", "good.toml --integrator whited", 2, "did you mean \"whitted\"?"},
    {"RefusesAnUnknownView", "good.toml --view rw", 2, "did you mean \"raw\"?"},
    {"RefusesAnUnknownKernel", "good.toml --kernel singel", 2, "did you mean \"single\"?"},
    {"RefusesOddBits", "good.toml --bits 12", 2, "expected 8, 16"},
    {"RefusesACropOfThreeNumbers", "good.toml --crop 1,2,3", 2, "X,Y,W,H"},
    {"RefusesACropOutside", "good.toml --crop 10,0,7,1", 2, "the picture has 16×12 pixels"},
    {"RefusesAnEmptyCrop", "good.toml --crop 0,0,0,1", 2, "holds no pixel"},
    {"RefusesAnOptionWithoutItsValue", "good.toml -o", 2, "-o needs a value: FILE"},
    {"RefusesAnOptionForAValue", "good.toml -o --spp 4", 2, "\"--spp\" after it is an option"},
    {"RefusesAnOverrideThatSetsNothing", "good.toml -D x", 2, "expected path=value"},
    {"RefusesUpForAScene", "good.toml --up y", 2, "--up is for bare meshes"},
    {"RefusesANegativeTolerance", "diff a.pfm b.pfm --tolerance -1", 2, "not below 0"},

    // Outputs, before anything is rendered: long.toml would take hours.
    {"RefusesAnUnknownPicture", "long.toml -o x.jpg", 2, ".png, .exr or .pfm"},
    {"RefusesAPictureWithoutExtension", "long.toml -o x", 2, ".png, .exr or .pfm"},
    {"RefusesLayersInPng", "long.toml --layers", 2, "--layers is for .exr"},
    {"RefusesAlphaInPfm", "long.toml -o x.pfm --alpha", 2, "--alpha is for .png and .exr"},
    {"RefusesBitsInPfm", "long.toml -o x.pfm --bits 16", 2, "--bits is for .png"},
    {"RefusesTwoResultsInOneFile", "long.toml -o x.png --stats x.png", 2, "both go to x.png"},
    {"RefusesTwoResultsOnStdout", "long.toml -o - --stats -", 2, "both go to stdout"},
    {"RefusesTwoNamesOfOneFile", "long.toml -o x.png --stats empty/../x.png", 2, "-o and --stats both go to"},
    {"RefusesToOverwriteTheScene", "long.toml --stats long.toml", 2, "would overwrite long.toml"},
    {"RefusesOtherNamesOfTheScene", "long.toml --stats ./long.toml", 2, "would overwrite long.toml"},
    {"RefusesToOverwriteAMesh", "mesh.ply --stats empty/../mesh.ply", 2, "would overwrite mesh.ply"},
    {"RefusesToExplainIntoTheScene", "explain good.toml --pixel 8,6 -o ./good.toml", 2,
     "would overwrite good"},
    {"RefusesHeatForAPicture", "diff garbage.png empty -o ./garbage.png", 2, "would overwrite garbage.png"},
    {"RefusesAMissingFolder", "long.toml -o no/x.png", 4, "create the folder 'no'"},
    {"RefusesAFolderForAFile", "long.toml -o good.toml/x.png", 4, "Not a directory"},
    {"RefusesAFolderThatTakesNothing", "long.toml -o /proc/x.png", 4, "write to another one; -o names"},
    {"RefusesAMissingFolderForStats", "long.toml --stats no/x.json", 4, "create the folder 'no'"},
    {"RefusesAMissingFolderForHeat", "diff a.pfm b.pfm -o no/x.png", 4, "create the folder 'no'"},

    // Inputs.
    {"RefusesAMissingScene", "missing.toml", 3, "missing.toml"},
    {"RefusesAMissingMesh", "missing.ply", 3, "missing.ply"},
    {"RefusesABadScene", "bad.toml", 3, "bad.toml:5"},
    {"TellsAllErrorsOfMeaning", "bad.toml", 3, "did you mean \"white\"?"},
    {"RefusesAFolderForAScene", "empty", 3, "empty"},
    {"RefusesAFolderForAMesh", "info ./empty", 3, "empty"},
    {"RefusesAMissingPicture", "diff no.png no.png", 3, "no.png"},
    {"RefusesAPictureThatIsNone", "diff garbage.png garbage.png", 3, "garbage.png"},
    {"RefusesAnUnknownOverride", "good.toml -D sphere.0.radios=1", 3, "radius"},

    // Other commands.
    {"ChecksNothingWithoutFiles", "check", 2, "glint check FILE..."},
    {"ComparesTwoPictures", "diff a.png", 2, "two pictures are needed"},
    {"KnowsItsTemplates", "new nosuchtemplate", 2, "unknown template \"nosuchtemplate\""},
    {"ExplainsNothingWithoutAPixel", "explain good.toml", 2, "--pixel X,Y"},
    {"ExplainsNoPixelOutside", "explain good.toml --pixel 16,0", 2, "the picture has 16×12 pixels"},
    {"RefusesAPixelOfOneNumber", "explain good.toml --pixel 8", 2, "X,Y such as 320,240"},
    {"ExplainsAPixel", "explain good.toml --pixel 8,6", 0, "primary → sphere.0"},
    {"SuggestsAFormatOfExplanations", "explain good.toml --pixel 8,6 --format jsn", 2,
     "did you mean \"json\""},
    {"ListsTemplates", "new --list", 0, "\n"},
};

INSTANTIATE_TEST_SUITE_P(, CommandLine, testing::ValuesIn(cases),
                         [](const auto& tested) { return std::string(tested.param.name); });

class Help : public CliTest, public testing::WithParamInterface<const char*> {};

/// Characters, not bytes.
std::size_t width(const std::string& line) {
    return static_cast<std::size_t>(std::count_if(
        line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

TEST_P(Help, FitsAScreen) {
    const Outcome outcome = glint(GetParam() + std::string(" --help"));
    ASSERT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.err, "");
    std::istringstream lines(outcome.out);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(width(line), 100u) << line;
    EXPECT_LE(count, 24) << outcome.out;
}

TEST_P(Help, SaysNothingOfWhatIsNotBuilt) {
    const std::string text = glint(GetParam() + std::string(" --help")).out;
    for (const char* word : {"shard", "checkpoint", "resume", "--time", "merge", "convert"})
        EXPECT_EQ(text.find(word), std::string::npos) << word;
}

INSTANTIATE_TEST_SUITE_P(, Help,
                         testing::Values("", "render", "view", "check", "info", "explain", "diff", "new"),
                         [](const auto& tested) {
                             return *tested.param ? std::string(tested.param) : "top";
                         });

} // namespace
} // namespace glint::test
