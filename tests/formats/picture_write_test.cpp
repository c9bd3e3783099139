#include "picture_support.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <thread>

namespace glint::test {

namespace {

using WriteFile = PictureTest;
using WritePicture = PictureTest;

TEST_F(WriteFile, WritesExactlyTheBytesAndLeavesNothingElse) {
    write_file(file("a"), bytes_of("hello"));
    EXPECT_EQ(load(file("a")), bytes_of("hello"));
    write_file(file("a"), bytes_of("bye"));
    EXPECT_EQ(load(file("a")), bytes_of("bye"));
    write_file(file("empty"), {});
    EXPECT_EQ(load(file("empty")), Bytes{});
    EXPECT_EQ(file_count(), 2U);
}

/// While it lives, no file of this process grows beyond `size` bytes: as if the disk were full.
class SmallDisk {
  public:
    explicit SmallDisk(rlim_t size) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = size;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_F(WriteFile, AFailureLeavesTheOldFileAndNoPartOfTheNew) {
    write_file(file("a"), bytes_of("old"));
    {
        const SmallDisk disk(1000);
        expect_error(ErrorKind::output, {file("a"), "File too large", "raise the limit"},
                     [&] { write_file(file("a"), Bytes(5000)); });
        expect_error(ErrorKind::output, {"File too large"}, [&] { write_file(file("b"), Bytes(5000)); });
    }
    EXPECT_EQ(load(file("a")), bytes_of("old"));
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(WriteFile, NamesCauseAndCure) {
    fs::create_directory(file("folder"));
    expect_error(ErrorKind::output, {"Is a directory", "name a file inside the folder"},
                 [&] { write_file(file("folder"), bytes_of("x")); });
    expect_error(ErrorKind::output, {"Is a directory"}, [&] { write_file(file("folder/"), bytes_of("x")); });
    expect_error(ErrorKind::output, {"No such file", "create the folder", "/none'"},
                 [&] { write_file(file("none/a.png"), bytes_of("x")); });
    expect_error(ErrorKind::output, {"No such file"}, [&] { write_file("", bytes_of("x")); });
    write_file(file("a"), bytes_of("x"));
    expect_error(ErrorKind::output, {"Not a directory"}, [&] { write_file(file("a/b"), bytes_of("x")); });
    expect_error(ErrorKind::output, {"name too long", "choose a shorter name"},
                 [&] { write_file(file(std::string(300, 'n')), bytes_of("x")); });
    EXPECT_EQ(file_count(), 2U);
}

TEST_F(WriteFile, WritesIntoDevicesInsteadOfReplacingThem) {
    if (!fs::exists("/dev/full") || !fs::exists("/dev/null")) GTEST_SKIP() << "there is no /dev/full here";
    expect_error(ErrorKind::output, {"/dev/full", "No space left on device", "free some space"},
                 [] { write_file("/dev/full", bytes_of("x")); });
    write_file("/dev/null", bytes_of("x"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(WriteFile, FollowsLinksInsteadOfReplacingThem) {
    fs::create_directory(file("folder"));
    fs::create_symlink("folder/real", file("link"));
    write_file(file("link"), bytes_of("one"));
    EXPECT_TRUE(fs::is_symlink(file("link")));
    EXPECT_EQ(load(file("folder/real")), bytes_of("one"));
    write_file(file("link"), bytes_of("two"));
    EXPECT_EQ(load(file("folder/real")), bytes_of("two"));

    fs::create_symlink("none/real", file("dangling"));
    expect_error(ErrorKind::output, {"No such file", "it links to", "create the folder", "/none'"},
                 [&] { write_file(file("dangling"), bytes_of("x")); });

    fs::create_symlink("loop", file("loop"));
    expect_error(ErrorKind::output, {"symbolic links"}, [&] { write_file(file("loop"), bytes_of("x")); });
}

TEST_F(WriteFile, KeepsThePermissionsOfTheFileItReplaces) {
    write_file(file("a"), bytes_of("old"));
    fs::permissions(file("a"), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    write_file(file("a"), bytes_of("new"));
    EXPECT_EQ(fs::status(file("a")).permissions(),
              fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(WriteFile, RefusesAFileThatMayNotBeWritten) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    write_file(file("a"), bytes_of("old"));
    fs::permissions(file("a"), fs::perms::owner_read);
    expect_error(ErrorKind::output, {"Permission denied"}, [&] { write_file(file("a"), bytes_of("new")); });
    expect_error(ErrorKind::output, {"Permission denied"}, [&] { check_writable(file("a")); });
    EXPECT_EQ(load(file("a")), bytes_of("old"));
}

TEST_F(WriteFile, TwoWritersAtOnceLeaveOneWholeFile) {
    const Bytes a(100000, std::byte{'a'});
    const Bytes b(90000, std::byte{'b'});
    const auto write_often = [&](const Bytes& bytes) {
        for (int i = 0; i < 10; ++i) write_file(file("shared"), bytes);
    };
    std::thread other([&] { write_often(b); });
    write_often(a);
    other.join();
    const Bytes found = load(file("shared"));
    EXPECT_TRUE(found == a || found == b);
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(WritePicture, RefusesNamesThatAreNoPictures) {
    for (const char* name : {"a.jpg", "a", "png", ".png"})
        expect_error(ErrorKind::usage, {name, ".png, .exr or .pfm"},
                     [&] { write_picture(file(name), varied_image(2, 2)); });
    EXPECT_EQ(file_count(), 0U);
    write_picture(file("UPPER.PNG"), varied_image(2, 2));
    EXPECT_EQ(read_picture(file("UPPER.PNG")).bits, 8);
}

TEST_F(WritePicture, RefusesWhatTheFormatCannotHold) {
    PictureOptions alpha;
    alpha.alpha = std::vector(4, 1.0f);
    PictureOptions layers;
    layers.layers = {{"diffuse", varied_image(2, 2)}};
    const Image image = varied_image(2, 2);
    expect_error(ErrorKind::usage, {"cannot hold alpha"},
                 [&] { write_picture(file("a.pfm"), image, alpha); });
    expect_error(ErrorKind::usage, {"cannot hold layers"},
                 [&] { write_picture(file("a.png"), image, layers); });
    expect_error(ErrorKind::usage, {"cannot hold layers"},
                 [&] { write_picture(file("a.pfm"), image, layers); });
    EXPECT_EQ(file_count(), 0U);
}

TEST_F(WritePicture, RefusesArgumentsThatDoNotFitTogether) {
    const Image image = varied_image(2, 2);
    const auto refused = [&](const std::string& part, const std::function<void(PictureOptions&)>& change) {
        PictureOptions options;
        change(options);
        expect_error(ErrorKind::usage, {part}, [&] { write_picture(file("a.exr"), image, options); });
    };
    refused("12 bits", [](PictureOptions& o) { o.bits = 12; });
    refused("alpha holds 3 values", [](PictureOptions& o) { o.alpha = {1, 1, 1}; });
    refused("a layer has no name", [](PictureOptions& o) { o.layers = {{"", Image(2, 2)}}; });
    refused("another size", [](PictureOptions& o) { o.layers = {{"a", Image(2, 3)}}; });
    refused("two layers have the name 'a'", [](PictureOptions& o) {
        o.layers = {{"a", Image(2, 2)}, {"a", Image(2, 2)}};
    });
    refused("no name", [](PictureOptions& o) { o.metadata = {{"", "x"}}; });

    Image short_of_pixels(2, 2);
    short_of_pixels.pixels.pop_back();
    expect_error(ErrorKind::usage, {"holds 11 values"},
                 [&] { write_picture(file("a.png"), short_of_pixels); });
    expect_error(ErrorKind::usage, {"0 x 5 pixels"}, [&] { write_picture(file("a.png"), Image(0, 5)); });
    PictureOptions bad_key;
    bad_key.metadata = {{" spaced ", "x"}};
    expect_error(ErrorKind::usage, {"' spaced '"}, [&] { write_picture(file("a.png"), image, bad_key); });
    EXPECT_EQ(file_count(), 0U);
}

TEST_F(WritePicture, AFailureLeavesTheOldPicture) {
#ifdef GLINT_WITH_EXR
    const std::vector<std::string> names{"a.png", "a.pfm", "a.exr"};
#else
    const std::vector<std::string> names{"a.png", "a.pfm"};
#endif
    for (const std::string& name : names) {
        write_picture(file(name), varied_image(4, 4));
        const Bytes old = load(file(name));
        {
            const SmallDisk disk(100);
            expect_error(ErrorKind::output, {name}, [&] { write_picture(file(name), varied_image(60, 60)); });
        }
        EXPECT_EQ(load(file(name)), old);
    }
    EXPECT_EQ(file_count(), names.size());
}

TEST_F(WritePicture, DashIsAPngOnStandardOutput) {
    write_picture(file("a.png"), varied_image(40, 30));
    std::fflush(stdout);
    const int kept = ::dup(STDOUT_FILENO);
    std::FILE* sink = std::fopen(file("stdout").c_str(), "wb");
    ASSERT_NE(sink, nullptr);
    ::dup2(::fileno(sink), STDOUT_FILENO);
    write_picture("-", varied_image(40, 30));
    ::dup2(kept, STDOUT_FILENO);
    ::close(kept);
    std::fclose(sink);
    EXPECT_EQ(load(file("stdout")), load(file("a.png")));
}

TEST_F(WritePicture, TargetsCanBeCheckedBeforeALongRender) {
    check_picture_target(file("a.exr"), true, true);
    check_picture_target("-", true);
    EXPECT_EQ(file_count(), 0U);
    expect_error(ErrorKind::usage, {".png, .exr or .pfm"}, [&] { check_picture_target(file("a.tif")); });
    expect_error(ErrorKind::usage, {"cannot hold layers"}, [&] { check_picture_target("-", false, true); });
    expect_error(ErrorKind::output, {"No such file"}, [&] { check_picture_target(file("none/a.png")); });
    fs::create_directory(file("folder.png"));
    expect_error(ErrorKind::output, {"Is a directory"}, [&] { check_picture_target(file("folder.png")); });
    fs::create_symlink("none/a.png", file("link.png"));
    expect_error(ErrorKind::output, {"No such file"}, [&] { check_picture_target(file("link.png")); });
    expect_error(ErrorKind::output, {"No such file", "no file can be created"},
                 [] { check_writable("/proc/a.png"); });
}

TEST(PictureFormat, FollowsFromTheExtensionInAnyCase) {
    EXPECT_EQ(picture_format("a.PnG"), PictureFormat::png);
    EXPECT_EQ(picture_format("b/c.exr"), PictureFormat::exr);
    EXPECT_EQ(picture_format("d.e.pfm"), PictureFormat::pfm);
    EXPECT_EQ(picture_format("-"), PictureFormat::png);
    EXPECT_EQ(picture_format("png"), std::nullopt);
    EXPECT_EQ(picture_format("a.jpeg"), std::nullopt);
}

} // namespace

} // namespace glint::test
