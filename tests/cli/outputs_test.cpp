// Files that must not be overwritten, and outputs that fail. long.toml would take hours: what it is refused
// for is found before rendering.

#include "cli_test.h"

#include <csignal>

namespace glint::test {
namespace {

namespace fs = std::filesystem;

class Outputs : public CliTest {
  public:
    /// Runs a line of shell in the folder; $G is glint.
    Outcome shell(const std::string& line, Setting setting = {}) const {
        setting.folder = path("");
        setting.environment.push_back(std::string("G=") + GLINT_PROGRAM);
        return run_program({"/bin/sh", "-c", line}, setting);
    }

    void expect_refused(const std::string& line, int exit, const std::string& says) const {
        const std::string before = listing();
        const Outcome outcome = shell(line);
        EXPECT_EQ(outcome.exit, exit) << line << "\n" << outcome.err;
        EXPECT_NE(outcome.err.find(says), std::string::npos) << line << "\n" << outcome.err;
        EXPECT_EQ(listing(), before) << line;
    }
};

TEST_F(Outputs, OverwriteNoInputUnderAnyName) {
    fs::create_symlink("long.toml", path("link.json"));
    fs::create_hard_link(path("long.toml"), path("hard.json"));
    fs::create_symlink(".", path("here"));
    for (const std::string& name : {std::string("./long.toml"), path("long.toml"), std::string("link.json"),
                                    std::string("hard.json"), std::string("here/long.toml")})
        expect_refused("$G long.toml --stats " + name, 2, "--stats would overwrite long.toml");
    expect_refused("$G - --stats long.toml <long.toml", 2,
                   "--stats would overwrite the file that stdin reads");

    write("mesh.toml", "[material.m]\n[[mesh]]\nfile = \"mesh.ply\"\nmaterial = \"m\"\n");
    expect_refused("$G mesh.toml --stats here/mesh.ply", 2, "--stats would overwrite mesh.ply");
    expect_refused("$G explain mesh.toml --pixel 1,1 -o here/mesh.ply", 2, "-o would overwrite mesh.ply");

    // A scene whose default picture is its own file, and one that is the picture of a frame.
    write("scene.png", content("long.toml"));
    expect_refused("$G scene.png", 2, "-o would overwrite scene.png");
    write("f-2.png", content("long.toml"));
    expect_refused("$G f-2.png --frames 1..3 -o here/f-%d.png", 2, "-o would overwrite f-2.png");
}

TEST_F(Outputs, OverwriteNoOtherOutputUnderAnyName) {
    fs::create_symlink("x.png", path("link.json"));
    for (const std::string name : {"./x.png", "link.json"})
        expect_refused("$G long.toml -o x.png --stats " + name, 2, "-o and --stats both go to ");
    expect_refused("$G long.toml -o - --stats /dev/stdout | cat", 0, "-o and --stats both go to ");
    expect_refused("$G long.toml --frames 1..3 -o x%d.png --stats x2.png", 2, "-o and --stats both go to ");
    fs::create_symlink("x2.png", path("x1.png"));
    expect_refused("$G long.toml --frames 1..3 -o x%d.png", 2, "two frames both go to x2.png");
    EXPECT_EQ(shell("ln -s /dev/null null.png; $G good.toml -o null.png --stats /dev/null").exit, 0);
}

TEST_F(Outputs, AreCheckedBeforeRendering) {
    fs::create_symlink("none/x.png", path("link.png"));
    expect_refused("$G long.toml -o link.png", 4, "create the folder 'none' first");
    fs::create_symlink("loop.png", path("loop.png"));
    expect_refused("$G long.toml -o loop.png", 4, "symbolic links");
    fs::create_directory(path("x-2.png"));
    expect_refused("$G long.toml --frames 1..3 -o x-%d.png", 4, "x-2.png: error: ");
    expect_refused("cd /proc && $G \"$OLDPWD/good.toml\"", 4, "-o names another file");
}

TEST_F(Outputs, HaveNamesThatFileSystemsTake) {
    const std::string name(300, 'n');
    expect_refused("$G long.toml -o " + name + ".png", 4, "choose a shorter name; -o names another file");
    expect_refused("$G long.toml --stats " + name, 4, "choose a shorter name; --stats names");
    expect_refused("$G new -o " + name, 4, "choose a shorter name");
    expect_refused("$G " + name, 2, "neither a command nor a file");
    expect_refused("$G " + name + ".toml", 3, "cannot read the file: File name too long");
    expect_refused("$G diff " + name + " " + name, 3, "shorten the name");
    write("mesh.toml", "[material.m]\n[[mesh]]\nfile = \"" + name + "\"\nmaterial = \"m\"\n");
    expect_refused("$G check mesh.toml", 3, "cannot be read: File name too long");
}

TEST_F(Outputs, DoNotReplaceAFileThatIsMountedByItself) {
    const std::string mount = "unshare -m sh -c 'touch a.png b.png && mount --bind a.png b.png && ";
    if (shell(mount + "true'").exit != 0) GTEST_SKIP() << "nothing can be mounted here";
    expect_refused(mount + "$G long.toml -o b.png'", 4, "mount its folder");
}

TEST_F(Outputs, MayGoToDevices) {
    EXPECT_EQ(glint("good.toml -o /dev/null --stats /dev/null").exit, 0);
    EXPECT_EQ(glint("diff garbage.png /dev/zero").exit, 3);
    expect_refused("cat /dev/zero | $G diff /dev/stdin /dev/stdin", 3, "this is no picture");
}

TEST_F(Outputs, OfASingleFrameHaveItsNumber) {
    const Outcome outcome = glint("good.toml --frames 7");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_TRUE(exists("good-0007.png"));
    EXPECT_FALSE(exists("good.png"));
}

TEST_F(Outputs, FollowALinkToAFileThatIsNotThereYet) {
    fs::create_symlink("empty/x.png", path("link.png"));
    EXPECT_EQ(glint("good.toml -o link.png").exit, 0);
    EXPECT_TRUE(fs::is_symlink(path("link.png")));
    EXPECT_TRUE(exists("empty/x.png"));
}

TEST_F(Outputs, GoIntoPipesThatHaveAName) {
    const Outcome outcome = glint("good.toml -q -o a.png --stats /dev/stdout");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_EQ(outcome.out.substr(0, 1), "{");
}

TEST_F(Outputs, LeaveNothingBehindBeyondTheLimitOnTheSizeOfFiles) {
    for (const std::string line :
         {"good.toml -o a.pfm", "explain good.toml --pixel 8,6 --steps -o a.txt", "new -o a.toml"})
        expect_refused("ulimit -f 1; $G " + line, 4, "raise the limit on the size of files");
    expect_refused("ulimit -f 1; $G good.toml", 4, "-o names another file");
}

TEST_F(Outputs, EndWithAnErrorIfNobodyReadsThem) {
    const Outcome outcome = shell("mkfifo f; exec 4<>f 5>f 4<&-; $G good.toml -q -o - >&5");
    EXPECT_EQ(outcome.exit, 4);
    EXPECT_NE(outcome.err.find("the program that reads the output has ended"), std::string::npos)
        << outcome.err;
}

// A picture may have taken hours.
TEST_F(Outputs, StayWhereThoseAfterThemFail) {
    const Outcome outcome = glint("good.toml -o a.png --stats /dev/full");
    EXPECT_EQ(outcome.exit, 4);
    EXPECT_NE(outcome.err.find("a.png: 16×12"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("/dev/full: error: "), std::string::npos) << outcome.err;
    EXPECT_EQ(content("a.png").substr(1, 3), "PNG");
}

TEST_F(Outputs, DoNotDependOnMessages) {
    for (const std::string sink : {">/dev/full", ">&-"}) {
        EXPECT_EQ(shell("$G dark.toml -v --progress json -o a.png 2" + sink).exit, 0) << sink;
        EXPECT_EQ(content("a.png").substr(1, 3), "PNG") << sink;
        EXPECT_EQ(shell("$G bad.toml 2" + sink).exit, 3) << sink;
    }
    shell("mkfifo f; exec 4<>f 5>f 4<&-; $G dark.toml -o a.png 2>&5; echo $? >code");
    EXPECT_EQ(content("code"), "0\n");
    EXPECT_EQ(shell("$G good.toml -o - >&-").exit, 4);
}

TEST_F(Outputs, OneSignalEndsWaitingForAReader) {
    Setting setting;
    setting.signal_when = "\"event\":\"progress\"";
    for (const int signal : {SIGTERM, SIGINT}) {
        setting.signal = signal;
        EXPECT_EQ(shell("mkfifo f.png; exec $G good.toml --progress json -o f.png", setting).exit,
                  128 + signal);
    }
}

TEST_F(Outputs, ComeFromNoFolderOnStdin) {
    for (const std::string line : {"- -o a.pfm", "info -", "check -", "explain - --pixel 1,1"})
        expect_refused("$G " + line + " </", 3, "Is a directory");
    expect_refused("$G - <&-", 3, "<stdin>: error: ");
}

TEST_F(Outputs, AreNotMadeByADryRun) {
    const std::string before = listing();
    const Outcome outcome = glint("long.toml --dry-run");
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("long.png: 1024×1024, 4000 spp\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\n  picture  12.0 MiB\n  writing  3.0 MiB\n"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(glint("long.toml --dry-run -o no/x.png").exit, 4);
    EXPECT_EQ(listing(), before);
}

TEST_F(Outputs, AreRefusedForWhichThereIsNoMemory) {
    if (sanitized || !GLINT_EXR) GTEST_SKIP() << "needs addresses, or OpenEXR";
    // Writing an EXR takes its picture once more.
    const std::string limit = "ulimit -v 2000000; $G long.toml --size 10000x10000 ";
    expect_refused(limit + "-o x.exr", 5, "rendering (scene 512 B, picture 1.1 GiB, writing 1.1 GiB) takes");
    expect_refused(limit + "--layers -o x.exr", 5, "render in parts with --crop");
    EXPECT_EQ(shell(limit + "--crop 0,0,9,9 --spp 1 -o x.exr").exit, 0);
}

// A scene may read meshes below its own folder; where that cannot be known, none.
TEST_F(Outputs, AndInputsMayLieInFoldersWhosePathIsTooLong) {
    write("mesh.toml", "[material.m]\n[[mesh]]\nfile = \"mesh.ply\"\nmaterial = \"m\"\n");
    Setting setting;
    setting.environment = {"H=" + path(".")};
    const std::string descend =
        "d=$(printf %0250d 0); for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17; do "
        "mkdir $d && cd -P $d; done; cp \"$H\"/mesh.toml \"$H\"/mesh.ply .; ";
    const Outcome outcome =
        shell(descend + "$G check mesh.toml; $G mesh.toml --allow-outside -o a.png", setting);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("the path cannot be resolved"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace glint::test
