// The man page and the completions of shells, as the build made them.

#include "cli_test.h"

#include <fstream>
#include <sstream>

namespace glint::test {
namespace {

std::string generated(const std::string& name) {
    std::ifstream file(std::string(GLINT_GENERATED_DOCS) + "/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

class GeneratedDocs : public CliTest {
  public:
    /// What bash offers for the last of the words.
    std::string offered(const std::string& words) const {
        Setting setting;
        setting.folder = path("");
        setting.input = "PATH=$(dirname " GLINT_PROGRAM "):$PATH\nsource " GLINT_GENERATED_DOCS
                        "/glint.bash\n"
                        "COMP_WORDS=(" +
                        words +
                        ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_glint\n"
                        "for word in \"${COMPREPLY[@]}\"; do printf '%s ' \"$word\"; done\n";
        const Outcome outcome = run_program({"/bin/bash", "-s"}, setting);
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }
};

TEST_F(GeneratedDocs, ManPageNamesEveryOptionThatHelpNames) {
    const std::string page = generated("glint.1");
    EXPECT_EQ(page.rfind(".TH GLINT 1", 0), 0u);
    for (const char* option :
         {"\\-\\-size", "\\-\\-keep\\-partial", "\\-\\-metric", "\\-\\-force", "\\-\\-json"})
        EXPECT_NE(page.find(option), std::string::npos) << option;
    EXPECT_NE(page.find("NO_COLOR"), std::string::npos);
}

TEST_F(GeneratedDocs, BashCompletesCommandsOptionsWordsAndFiles) {
    EXPECT_EQ(offered("glint rend"), "render ");
    EXPECT_EQ(offered("glint goo"), "good.toml ");
    EXPECT_EQ(offered("glint good.toml --max"), "--max-depth ");
    EXPECT_EQ(offered("glint good.toml --view ''"), "srgb raw ");
    EXPECT_EQ(offered("glint diff --max"), "") << "options of other commands are not offered";
    EXPECT_EQ(offered("glint diff --metric p"), "psnr ");
}

TEST_F(GeneratedDocs, OtherShellsKnowTheSameOptions) {
    EXPECT_EQ(generated("_glint").rfind("#compdef glint\n", 0), 0u);
    for (const char* name : {"_glint", "glint.fish"})
        for (const char* option : {"keep-partial", "metric", "auto plain json none"})
            EXPECT_NE(generated(name).find(option), std::string::npos) << name << " " << option;
}

} // namespace
} // namespace glint::test
