// Without a display: the command line needs no window system, and says what the window needs.

#include "../cli/process.h"
#include "../kit/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace glint::test {
namespace {

namespace fs = std::filesystem;

/// libepoxy is allowed: it loads OpenGL only when the GPU is used.
TEST(Headless, TheCommandLineLinksNoWindowSystem) {
    const Outcome outcome = run_program({"/usr/bin/ldd", GLINT_PROGRAM}, {});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
    ASSERT_NE(outcome.out.find("libc."), std::string::npos) << outcome.out;
    for (const char* library : {"libX11", "libxcb", "libwayland", "libGL", "libEGL", "libglfw"})
        EXPECT_EQ(outcome.out.find(library), std::string::npos) << outcome.out;
}

TEST(Headless, WithoutTheWindowInstalledOneIsTold) {
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    fs::copy_file(GLINT_PROGRAM, folder / "glint");
    Setting setting;
    setting.folder = folder.string();
    // The first PATH of an environment counts.
    setting.environment = {"PATH=" + folder.string()};
    const Outcome outcome = run_program({(folder / "glint").string(), "view", "scene.toml"}, setting);
    EXPECT_EQ(outcome.exit, 7);
    EXPECT_NE(outcome.err.find("no glint-view beside glint"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("render to a file"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

#ifdef GLINT_VIEW_PROGRAM

TEST(Headless, AFileThatIsNotThereIsToldWithoutAWindow) {
    const Outcome outcome = run_glint({"view", "nosuch.toml"}, {});
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_EQ(outcome.err, "nosuch.toml: error: there is no such file\n");
}

TEST(Headless, WithoutADisplayOneLineSaysWhatToDo) {
    const Outcome outcome = run_glint({"view", GLINT_SOURCE_DIR "/scenes/report/diffuse.toml"}, {});
    EXPECT_EQ(outcome.exit, 7);
    EXPECT_EQ(outcome.err, "error: there is no display to open a window on; render to a file instead: glint "
                           "FILE -o picture.png\n");
    EXPECT_EQ(outcome.out, "");
}

TEST(Headless, ADisplayThatIsNotThereIsNamed) {
    Setting setting;
    setting.environment = {"DISPLAY=:98765"};
    const Outcome outcome = run_glint({"view"}, setting);
    EXPECT_EQ(outcome.exit, 7);
    EXPECT_NE(outcome.err.find(":98765"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(Headless, WrongWordsAreRefusedBeforeAWindowOpens) {
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--sise", "4x4"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--size", "4"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--size", "4x4x4"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--size"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--theme", "pink"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--scale", "nan"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "--ui-stats=1"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "-t", "many"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "-D", "=3"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "-"}, {}).exit, 2);
    EXPECT_EQ(run_program({GLINT_VIEW_PROGRAM, "a.toml", "b.toml"}, {}).exit, 2);
}

/// Every "--name" of a help text.
std::set<std::string> options_in(const std::string& text) {
    std::set<std::string> names;
    std::istringstream words(text);
    for (std::string word; words >> word;)
        // "--size", or "-t,--threads".
        if (const std::size_t at = word.find("--"); at == 0 || (at == 3 && word[2] == ','))
            names.insert(word.substr(at, word.find_first_of(",;", at) - at));
    return names;
}

TEST(Headless, BothProgramsNameTheSameOptions) {
    const Outcome from_glint = run_glint({"view", "--help"}, {});
    const Outcome from_window = run_program({GLINT_VIEW_PROGRAM, "--help"}, {});
    std::set<std::string> expected = options_in(from_window.out);
    EXPECT_EQ(expected.erase("--version"), 1u) << "glint has its own";
    EXPECT_GT(expected.size(), 8u);
    EXPECT_EQ(options_in(from_glint.out), expected);
}

#endif

} // namespace
} // namespace glint::test
