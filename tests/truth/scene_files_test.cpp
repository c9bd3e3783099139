// Truths that are a scene file and a number: every .toml beside this source is one test.
//
// Comments in the file say what is expected, one line each, of pixels of the picture rendered by its own
// settings:
//   # expect pixel X Y = R G B relative T      |value − expected| ≤ T · |expected| in each channel
//   # expect pixel X Y = R G B absolute T      |value − expected| ≤ T
//   # expect mean = R G B relative T           the same of the mean over all pixels

#include "glint/image.h"
#include "glint/render.h"
#include "glint/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace glint {
namespace {

struct Expectation {
    std::string line; ///< as written, for messages
    int x = -1;       ///< −1: the mean
    int y = -1;
    std::array<double, 3> value{};
    bool relative = false;
    double tolerance = 0;
};

/// Reads what follows "# expect "; throws std::runtime_error for anything but the forms above.
Expectation parse_expectation(const std::string& text) {
    Expectation e;
    e.line = text;
    std::istringstream in(text);
    std::string what, equals, kind, rest;
    in >> what;
    if (what == "pixel") in >> e.x >> e.y;
    in >> equals >> e.value[0] >> e.value[1] >> e.value[2] >> kind >> e.tolerance;
    const bool known = (what == "pixel" || what == "mean") && (kind == "relative" || kind == "absolute");
    if (!in || !known || equals != "=" || in >> rest) throw std::runtime_error("cannot read: expect " + text);
    e.relative = kind == "relative";
    return e;
}

std::vector<Expectation> expectations_of(const std::filesystem::path& file) {
    constexpr std::string_view mark = "# expect ";
    std::vector<Expectation> all;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.rfind(mark, 0) == 0) all.push_back(parse_expectation(line.substr(mark.size())));
    return all;
}

std::array<double, 3> value_at(const Image& image, const Expectation& e) {
    std::array<double, 3> value{};
    const int pixels = image.width * image.height;
    for (std::size_t c = 0; c < 3; ++c) {
        if (e.x >= 0) {
            value[c] = image.at(e.x, e.y)[c];
            continue;
        }
        for (std::size_t i = c; i < image.pixels.size(); i += 3) value[c] += image.pixels[i];
        value[c] /= pixels;
    }
    return value;
}

class SceneFile : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(SceneFile, ShowsTheNumbersThatItExpects) {
    const std::vector<Expectation> expectations = expectations_of(GetParam());
    ASSERT_FALSE(expectations.empty()) << GetParam() << " has no line \"# expect …\"";
    const Image image = render(build_scene(load_scene(GetParam().string()).description)).image;
    for (const Expectation& e : expectations) {
        ASSERT_TRUE(e.x < image.width && e.y < image.height) << e.line;
        const std::array<double, 3> value = value_at(image, e);
        for (std::size_t c = 0; c < 3; ++c) {
            const double allowed = e.relative ? e.tolerance * std::abs(e.value[c]) : e.tolerance;
            EXPECT_LE(std::abs(value[c] - e.value[c]), allowed)
                << GetParam().filename() << ": expect " << e.line << "\nchannel " << c << " shows "
                << value[c];
        }
    }
}

std::vector<std::filesystem::path> scene_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(GLINT_SOURCE_DIR "/tests/truth"))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

INSTANTIATE_TEST_SUITE_P(Truth, SceneFile, testing::ValuesIn(scene_files()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(SceneFiles, ExpectationsThatCannotBeReadAreRefused) {
    EXPECT_EQ(parse_expectation("pixel 1 2 = 3 4 5 relative 1e-6").y, 2);
    EXPECT_EQ(parse_expectation("mean = 3 4 5 absolute 0").x, -1);
    for (const char* bad :
         {"pixel 1 = 3 4 5 relative 1e-6", "pixel 1 2 = 3 4 relative 1e-6", "median = 1 1 1 relative 0",
          "mean = 1 1 1 about 0", "mean = 1 1 1 relative", "mean = 1 1 1 relative 0 0"})
        EXPECT_THROW(parse_expectation(bad), std::runtime_error) << bad;
}

} // namespace
} // namespace glint
