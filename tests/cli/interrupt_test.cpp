// Ctrl-C and SIGTERM. The signal is sent once the first progress line shows that rendering has begun.

#include "cli_test.h"

#include <csignal>

namespace glint::test {
namespace {

class Interrupt : public CliTest {
  public:
    Outcome stopped(const std::string& line, int signal) const {
        Setting setting;
        setting.signal = signal;
        setting.signal_when = "\"event\":\"progress\"";
        return glint(line + " --progress json --tile-size 4", setting);
    }
};

TEST_F(Interrupt, ByCtrlCLeavesNothing) {
    const std::string before = listing();
    const Outcome outcome = stopped("long.toml", SIGINT);
    EXPECT_EQ(outcome.exit, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("nothing written"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(listing(), before);
}

TEST_F(Interrupt, ByTermLeavesNothing) {
    const std::string before = listing();
    const Outcome outcome = stopped("long.toml", SIGTERM);
    EXPECT_EQ(outcome.exit, 143) << outcome.err;
    EXPECT_EQ(listing(), before);
}

TEST_F(Interrupt, LeavesAnOlderPictureAlone) {
    write("long.png", "older");
    EXPECT_EQ(stopped("long.toml", SIGINT).exit, 130);
    EXPECT_EQ(content("long.png"), "older");
}

TEST_F(Interrupt, BeforeTheFirstTileIsDone) {
    const Outcome outcome = stopped("long.toml --tile-size 4096 --spp 100000", SIGINT);
    EXPECT_EQ(outcome.exit, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("\"fraction\":0.000000,\"tiles_done\":0"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("\"seconds_left\":null"), std::string::npos) << outcome.err;
}

TEST_F(Interrupt, KeepsAPartWhenAsked) {
    const Outcome outcome = stopped("long.toml -o part.pfm --keep-partial --stats part.json", SIGINT);
    EXPECT_EQ(outcome.exit, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("\"output\":\"part.pfm\",\"complete\":false"), std::string::npos)
        << outcome.err;
    EXPECT_NE(content("part.json").find("\"complete\": false"), std::string::npos);
    // A picture like any other: it equals itself.
    const Outcome same = glint("diff part.pfm part.pfm");
    EXPECT_EQ(same.exit, 0) << same.err;
}

TEST_F(Interrupt, KeepsAPartWhenTheTerminalIsClosed) {
    const Outcome outcome = stopped("long.toml -o part.pfm --keep-partial", SIGHUP);
    EXPECT_EQ(outcome.exit, 129) << outcome.err;
    EXPECT_TRUE(exists("part.pfm"));
}

TEST_F(Interrupt, LeavesNoTemporaryFileOfOtherCommands) {
    const std::string before = listing();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Setting setting;
        setting.signal = signal;
        setting.signal_after = 200;
        const Outcome outcome = glint("explain long.toml --format html -o a.html", setting);
        EXPECT_EQ(outcome.exit, 128 + signal) << outcome.err;
        EXPECT_EQ(listing(), before);
    }
}

} // namespace
} // namespace glint::test
