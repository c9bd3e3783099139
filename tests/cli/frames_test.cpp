// --frames and --frame.

#include "cli_test.h"

#include <csignal>

namespace glint::test {
namespace {

constexpr const char* moving = R"([render]
size = [16, 12]
spp = 1
[camera]
eye = [0, -5, 0]
look_at = [0, 0, 0]
[material.m]
emission = [1, 1, 1]
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "m"
[[light]]
type = "ambient"
[[animate]]
key = "sphere.0.radius"
frames = [0, 4]
values = [0.5, 1.5]
)";

class Frames : public CliTest {
  public:
    Frames() { write("moving.toml", moving); }
};

TEST_F(Frames, GoIntoOneFileEach) {
    const Outcome outcome = glint("moving.toml --frames 0..4:2 -o f-%03d.pfm");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_TRUE(exists("f-000.pfm") && exists("f-002.pfm") && exists("f-004.pfm"));
    EXPECT_FALSE(exists("f-001.pfm"));
    EXPECT_NE(outcome.err.find("3 frames in "), std::string::npos) << outcome.err;
    EXPECT_EQ(glint("diff f-000.pfm f-004.pfm").exit, 1);
}

TEST_F(Frames, AreTheSceneWithTheValuesOfTheFrame) {
    EXPECT_EQ(glint("moving.toml --frames 1 -o frame.pfm").exit, 0);
    EXPECT_EQ(glint("moving.toml -D sphere.0.radius=0.75 -o override.pfm").exit, 0);
    EXPECT_EQ(content("frame.pfm"), content("override.pfm"));
    EXPECT_EQ(glint("moving.toml -o still.pfm").exit, 0);
    EXPECT_EQ(glint("moving.toml --frames 2 -o two.pfm").exit, 0);
    EXPECT_EQ(content("still.pfm"), content("two.pfm"));
}

TEST_F(Frames, AllAreThoseOfTheAnimation) {
    const Outcome outcome = glint("moving.toml --frames all --stats stats.json");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    for (const char* name : {"moving-0000.png", "moving-0002.png", "moving-0004.png"})
        EXPECT_TRUE(exists(name));
    EXPECT_FALSE(exists("moving-0005.png"));
    EXPECT_NE(content("stats.json").find("\"frame\": 4"), std::string::npos);
    EXPECT_EQ(content("stats.json").front(), '[');
}

TEST_F(Frames, WrongRangesAndNamesAreRefused) {
    for (const std::string wrong :
         {"--frames 4..0", "--frames 0..4:0", "--frames x", "--frames 1..", "--frames 0..4 -o one.png",
          "--frames 0..4 -o f-%s.png", "--frames 0..4 -o f-%d-%d.png", "--frames 0..4 -o -",
          "--frames 0..9999999"}) {
        const std::string before = listing();
        const Outcome outcome = glint("moving.toml " + wrong);
        EXPECT_EQ(outcome.exit, 2) << wrong << "\n" << outcome.err;
        EXPECT_EQ(listing(), before);
    }
    EXPECT_EQ(glint("moving.toml --frames 3 -o 100%%.png").exit, 0);
    EXPECT_TRUE(exists("100%.png"));
}

TEST_F(Frames, AWrongFrameIsToldBeforeAnyIsRendered) {
    write("wrong.toml", std::string(moving) + "[[animate]]\nkey = \"camera.eye\"\nframes = [0, 8]\n"
                                              "values = [[0, -5, 0], [0, 5, 0]]\n");
    const std::string before = listing();
    const Outcome outcome = glint("wrong.toml --frames 0..8 -o f-%d.png");
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_NE(outcome.err.find("frame 4: \"look_at\" is where the \"eye\" is"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(listing(), before);
    EXPECT_EQ(glint("check wrong.toml").exit, 3);
    EXPECT_EQ(glint("check wrong.toml --frames 0..3").exit, 0);
}

TEST_F(Frames, CtrlCTellsWhichFramesAreDone) {
    // The first frame is small, the second one would take hours.
    std::string slow = content("long.toml");
    slow += "\n[[animate]]\nkey = \"render.spp\"\nframes = [0, 1]\nvalues = [1, 1048576]\n"
            "[[animate]]\nkey = \"render.size\"\nframes = [0, 1]\nvalues = [[4, 4], [2048, 2048]]\n";
    write("slow.toml", slow);
    Setting setting;
    setting.signal = SIGINT;
    setting.signal_when = "\"task\":\"frame 1 (2 of 3)\"";
    const Outcome outcome =
        glint("slow.toml --frames 0..2 -o f-%d.png --progress json --tile-size 4", setting);
    EXPECT_EQ(outcome.exit, 130) << outcome.err;
    EXPECT_TRUE(exists("f-0.png"));
    EXPECT_FALSE(exists("f-1.png"));
    EXPECT_NE(outcome.err.find("stopped in frame 1; 1 of 3 frames are done, 0 to 0"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("--frames 1..2"), std::string::npos) << outcome.err;
}

TEST_F(Frames, ExplainAndInfoTakeOneFrame) {
    EXPECT_NE(glint("info moving.toml --frame 0 --json").out, glint("info moving.toml --frame 4 --json").out);
    EXPECT_NE(glint("explain moving.toml --pixel 8,6 --frame 0").out,
              glint("explain moving.toml --pixel 8,6 --frame 4").out);
}

} // namespace
} // namespace glint::test
