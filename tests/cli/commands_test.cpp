// check, info, diff and new.

#include "cli_test.h"

#include <nlohmann/json.hpp>

namespace glint::test {
namespace {

class Check : public CliTest {};

TEST_F(Check, TellsOfEveryFile) {
    const Outcome outcome = glint("check good.toml bad.toml dark.toml mesh.ply");
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_NE(outcome.out.find("good.toml: ok (1 object, 1 light, 1 material)\n"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("dark.toml: ok (1 object, 0 lights, 1 material; "), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("mesh.ply: ok ("), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("bad.toml"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("bad.toml:5:"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("bad.toml:6:"), std::string::npos) << "all errors, not only the first\n"
                                                                  << outcome.err;
    EXPECT_NE(outcome.err.find("1 of 4 files have errors"), std::string::npos) << outcome.err;
}

TEST_F(Check, PassesWarnings) {
    const Outcome outcome = glint("check dark.toml");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_NE(outcome.err.find("warning: "), std::string::npos) << outcome.err;
}

TEST_F(Check, KeepsQuiet) {
    const Outcome sound = glint("check -q good.toml dark.toml");
    EXPECT_EQ(sound.exit, 0);
    EXPECT_EQ(sound.out + sound.err, "");
    const Outcome unsound = glint("check -q bad.toml");
    EXPECT_EQ(unsound.exit, 3);
    EXPECT_NE(unsound.err.find("error: "), std::string::npos) << unsound.err;
}

TEST_F(Check, SpeaksJson) {
    const Outcome outcome = glint("check --json good.toml bad.toml dark.toml");
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_EQ(outcome.err, "");
    const auto files = nlohmann::json::parse(outcome.out)["files"];
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[0]["file"], "good.toml");
    EXPECT_EQ(files[0]["ok"], true);
    EXPECT_EQ(files[0]["scene"]["objects"], 1);
    EXPECT_EQ(files[1]["ok"], false);
    ASSERT_EQ(files[1]["errors"].size(), 2u);
    EXPECT_EQ(files[1]["errors"][0]["line"], 5);
    EXPECT_EQ(files[1]["errors"][0]["file"], "bad.toml");
    EXPECT_NE(files[1]["errors"][0]["message"], "");
    EXPECT_EQ(files[2]["ok"], true);
    EXPECT_EQ(files[2]["warnings"].size(), 1u);
}

TEST_F(Check, EscapesControlCharactersOfNames) {
    write("odd\x1b[31m.toml", R"([render]
size = [8, 8]
[material."a\u001b[31m"]
transparency = 0.5
reflectivity = 0.9
[[sphere]]
name = "b\u001b[31m\u009b\u0007"
center = [0, 0, 0]
radius = 1
material = "a\u001b[31m"
[[sphere]]
name = "c\u001b[31m"
center = [0, 0, 0]
radius = 1
material = "a\u001b[31m"
)");
    for (const char* command : {"check", "info", "explain --pixel 4,4", "render --progress plain -o a.png"}) {
        const Outcome outcome = glint(std::string(command) + " odd\x1b[31m.toml");
        EXPECT_EQ(outcome.exit, 0) << outcome.err;
        const std::string all = outcome.out + outcome.err;
        EXPECT_EQ(all.find_first_of("\x1b\a"), std::string::npos) << command << "\n" << all;
        EXPECT_EQ(all.find("\xc2\x9b"), std::string::npos) << command;
        EXPECT_NE(all.find("\\u001b[31m"), std::string::npos) << command << "\n" << all;
    }
}

class Info : public CliTest {};

TEST_F(Info, PrintsToStdout) {
    const Outcome outcome = glint("info good.toml");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.err, "");
    for (const char* text : {"1 sphere", "1 point", "(-1, -1, -1) to (1, 1, 1)", "white", "16x12", "whitted"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text << "\n" << outcome.out;
}

TEST_F(Info, SpeaksJson) {
    const auto info = nlohmann::json::parse(glint("info mesh.ply --json").out);
    EXPECT_EQ(info["scene"]["triangles"], 4);
    EXPECT_EQ(info["camera"]["eye"].size(), 3u);
    EXPECT_FALSE(info["materials"].empty());
    EXPECT_EQ(info["settings"]["size"], (nlohmann::json{640, 480}));
    EXPECT_EQ(info["settings"]["spp"], "auto");
    EXPECT_EQ(info["settings"]["clamp"], false);
    EXPECT_EQ(info["settings"]["integrator"], "whitted");
}

TEST_F(Info, FailsWhenStdoutIsFull) {
    Setting setting;
    setting.out_file = "/dev/full";
    const Outcome outcome = glint("info good.toml", setting);
    EXPECT_EQ(outcome.exit, 4);
    EXPECT_NE(outcome.err.find("cannot write to stdout: No space left"), std::string::npos) << outcome.err;
}

class Diff : public CliTest {
  public:
    Diff() {
        write_pfm("a.pfm", 4, 3, 0.5f);
        write_pfm("b.pfm", 4, 3, 0.625f);
        write_pfm("wide.pfm", 5, 3, 0.5f);
    }
};

TEST_F(Diff, PassesEqualPictures) {
    const Outcome outcome = glint("diff a.pfm a.pfm");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("max      0\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(glint("diff a.pfm a.pfm --metric psnr").exit, 0);
}

TEST_F(Diff, PrintsEveryMeasure) {
    const Outcome outcome = glint("diff a.pfm b.pfm");
    EXPECT_EQ(outcome.exit, 1);
    EXPECT_EQ(outcome.out, "max      0.125\n"
                           "mae      0.125\n"
                           "rmse     0.125\n"
                           "psnr     18.06 dB\n"
                           "unequal  1 of the pixels\n"
                           "share    1 of the pixels by more than 1/255\n");
}

TEST_F(Diff, JudgesByMetricAndTolerance) {
    const std::string diff = "diff -q a.pfm b.pfm ";
    for (const char* metric : {"max", "mae", "rmse"}) {
        EXPECT_EQ(glint(diff + "--tolerance 0.125 --metric " + metric).exit, 0) << metric;
        EXPECT_EQ(glint(diff + "--tolerance 0.124 --metric " + metric).exit, 1) << metric;
    }
    EXPECT_EQ(glint(diff + "--metric psnr --tolerance 18").exit, 0);
    EXPECT_EQ(glint(diff + "--metric psnr --tolerance 19").exit, 1);
    EXPECT_EQ(glint(diff + "--metric share --tolerance 1").exit, 0);
    EXPECT_EQ(glint(diff + "--metric share --tolerance 0.99").exit, 1);
}

TEST_F(Diff, ComparesEightBitPicturesInTheirUnits) {
    for (const char* value : {"128", "131"}) {
        const std::string level = std::string(value) + ".5/255";
        const double v = (std::stod(value) + 0.5) / 255;
        const std::string gray = std::to_string(v) + "," + std::to_string(v) + "," + std::to_string(v);
        ASSERT_EQ(glint("dark.toml -q --view raw -D render.background=[" + gray +
                        "] -D sphere.0.visible=false -o " + value + ".png")
                      .exit,
                  0);
    }
    const Outcome outcome = glint("diff 128.png 131.png --tolerance 3");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("max      3 of 255\n"), std::string::npos) << outcome.out;
}

TEST_F(Diff, DrawsTheDifferences) {
    EXPECT_EQ(glint("diff a.pfm b.pfm -o heat.png").exit, 1);
    EXPECT_EQ(content("heat.png").substr(1, 3), "PNG");
    const Outcome piped = glint("diff a.pfm b.pfm -o -");
    EXPECT_EQ(piped.exit, 1);
    EXPECT_EQ(piped.out, content("heat.png")) << "the table makes way for the picture";
}

TEST_F(Diff, RefusesPicturesOfDifferentSizes) {
    const Outcome outcome = glint("diff a.pfm wide.pfm");
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_NE(outcome.err.find("different sizes: 4×3 and 5×3"), std::string::npos) << outcome.err;
}

class New : public CliTest {
  public:
    std::vector<std::string> templates() const { return words_of(glint("new --list").out); }
};

TEST_F(New, WritesStartersThatPassTheCheck) {
    ASSERT_FALSE(templates().empty());
    write("model.ply", content("mesh.ply")); // the reader's own mesh, which one of them names
    for (const std::string& name : templates()) {
        ASSERT_EQ(glint("new " + name + " -o " + name + ".toml").exit, 0);
        const Outcome check = glint("check " + name + ".toml");
        EXPECT_EQ(check.exit, 0) << check.err;
        EXPECT_EQ(check.err, "") << "a starter does not warn";
    }
}

TEST_F(New, WritesTheFirstTemplateToStdout) {
    const Outcome outcome = glint("new");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.out, glint("new " + templates().front()).out);
    EXPECT_NE(outcome.out.find("[camera]"), std::string::npos) << outcome.out;
}

TEST_F(New, OverwritesOnlyByForce) {
    const Outcome refused = glint("new -o good.toml");
    EXPECT_EQ(refused.exit, 4);
    EXPECT_NE(refused.err.find("--force overwrites it"), std::string::npos) << refused.err;
    EXPECT_EQ(glint("new -o good.toml --force").exit, 0);
    EXPECT_EQ(content("good.toml"), glint("new").out);
}

TEST_F(New, WritesTheStageOfAMesh) {
    ASSERT_EQ(glint("new --from mesh.ply --up z -o stage.toml").exit, 0);
    const std::string stage = content("stage.toml");
    for (const char* word : {"[camera]", "file = \"mesh.ply\"", "[[plane]]", "[[light]]"})
        EXPECT_NE(stage.find(word), std::string::npos) << word << "\n" << stage;
    ASSERT_EQ(glint("mesh.ply --up z --spp 1 -q -o mesh.pfm").exit, 0);
    ASSERT_EQ(glint("stage.toml --spp 1 -q -o stage.pfm").exit, 0);
    EXPECT_EQ(glint("diff mesh.pfm stage.pfm --tolerance 1e-4 -q").exit, 0);
    EXPECT_EQ(glint("new --from mesh.ply --up z").out, stage);
    EXPECT_EQ(glint("new glass --from mesh.ply").exit, 2);
}

TEST_F(New, FitsTheTurntableToTheMesh) {
    for (const char* scale : {"0.01", "1000"}) {
        std::string small = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                            "end_header\n0 0 0\n";
        small += std::string(scale) + " 0 0\n0 " + scale + " 0\n0 0 " + scale + "\n3 0 1 2\n3 0 1 3\n";
        write("model.ply", small);
        ASSERT_EQ(glint("new mesh --from model.ply --up y --force -o turn.toml").exit, 0);
        const Outcome check = glint("check turn.toml");
        EXPECT_EQ(check.exit, 0) << check.err;
        EXPECT_EQ(check.err, "");
        const auto info = nlohmann::json::parse(glint("info turn.toml --json").out)["scene"];
        const double width = info["bounds_max"][0].get<double>() - info["bounds_min"][0].get<double>();
        EXPECT_GT(width, std::stod(scale));
        EXPECT_LT(width, 3 * std::stod(scale));
    }
}

TEST_F(New, NamesACommandThatRendersTheFile) {
    EXPECT_NE(glint("new -o a.toml").err.find("render it with: glint a.toml\n"), std::string::npos);
    EXPECT_NE(glint("new -o check").err.find("render it with: glint ./check\n"), std::string::npos);
}

} // namespace
} // namespace glint::test
