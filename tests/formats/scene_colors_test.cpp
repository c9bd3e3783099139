// Colours as people write them.

#include "formats/scene/colors.h"
#include "scene_support.h"

#include <cmath>
#include <set>

namespace glint::test {

using formats::color_codes;

namespace {

Vec3 color(const std::string& written, const std::string& top = "") {
    return parse(top + "[material.m]\ncolor = " + written).description.materials.at(0).color;
}

double decoded(int code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

void expect_near(const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-15);
}

TEST(SceneColors, NumbersAreLinear) { EXPECT_EQ(color("[0.25, 1, 7]"), Vec3(0.25, 1, 7)); }

TEST(SceneColors, HexadecimalIsDecodedFromSrgb) {
    expect_near(color("\"#804020\""), {decoded(128), decoded(64), decoded(32)});
    expect_near(color("\"#8aF\""), {decoded(0x88), decoded(0xaa), decoded(0xff)});
    EXPECT_EQ(color("\"#ffffff\""), Vec3(1));
    EXPECT_EQ(color("\"#000\""), Vec3(0));
}

TEST(SceneColors, LinearColorValuesAreDividedBy255) {
    const std::string top = "color_values = \"linear\"\n";
    EXPECT_EQ(color("\"#804020\"", top), Vec3(128 / 255.0, 64 / 255.0, 32 / 255.0));
    EXPECT_EQ(color("\"LightSkyBlue\"", top), Vec3(135 / 255.0, 206 / 255.0, 250 / 255.0));
    EXPECT_EQ(color("[0.25, 1, 7]", top), Vec3(0.25, 1, 7));
}

TEST(SceneColors, ColorValuesCountWhereverTheyStandAtTheTop) {
    const auto scene = parse("material.m.color = \"#808080\"\ncolor_values = \"linear\"\n");
    EXPECT_EQ(scene.description.materials.at(0).color, Vec3(128 / 255.0));
}

TEST(SceneColors, NamesAreReadInAnyCase) {
    EXPECT_EQ(color_codes("rebeccapurple"), 0x663399u);
    EXPECT_EQ(color_codes("RebeccaPurple"), 0x663399u);
    EXPECT_EQ(color_codes("CORNFLOWERBLUE"), 0x6495edu);
    EXPECT_EQ(color_codes("greenyellow"), 0xadff2fu);
    EXPECT_EQ(color_codes("lightgoldenrodyellow"), 0xfafad2u);
}

TEST(SceneColors, CssNamesWinOverX11) {
    EXPECT_EQ(color_codes("gray"), 0x808080u);
    EXPECT_EQ(color_codes("green"), 0x008000u);
    EXPECT_EQ(color_codes("maroon"), 0x800000u);
    EXPECT_EQ(color_codes("purple"), 0x800080u);
}

TEST(SceneColors, NumberedNamesAreThoseOfX11) {
    EXPECT_EQ(color_codes("DarkOrange2"), 0xee7600u);
    EXPECT_EQ(color_codes("snow1"), 0xfffafau);
    EXPECT_EQ(color_codes("snow4"), 0x8b8989u);
    EXPECT_EQ(color_codes("thistle3"), 0xcdb5cdu);
    EXPECT_EQ(color_codes("gray0"), 0x000000u);
    EXPECT_EQ(color_codes("Grey50"), 0x7f7f7fu);
    EXPECT_EQ(color_codes("gray51"), 0x828282u);
    EXPECT_EQ(color_codes("gray90"), 0xe5e5e5u);
    EXPECT_EQ(color_codes("grey100"), 0xffffffu);
}

TEST(SceneColors, OthersAreNone) {
    for (const char* text : {"", "#", "#12", "#1234", "#12345678", "#ggg", "gray101", "gray050", "gray+1",
                             "snow0", "snow5", "aqua1", "dark orange", " red", "red "})
        EXPECT_FALSE(color_codes(text)) << text;
}

TEST(SceneColors, TheListIsCompleteAndNamesAColorOnce) {
    const std::vector<std::string> names = formats::color_names();
    EXPECT_EQ(names.size(), 148u + 4 * 78u);
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    for (const std::string& name : names) EXPECT_TRUE(color_codes(name)) << name;
}

} // namespace
} // namespace glint::test
