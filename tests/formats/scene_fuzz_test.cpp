// Scene files with random damage are read or refused, never worse.

#include "scene_support.h"

#include <random>

namespace glint::test {
namespace {

// What damage likes to insert: pieces of the language and of scenes.
const std::vector<std::string>& pieces() {
    static const std::vector<std::string> list = {
        "[",
        "]",
        "[[",
        "]]",
        "{",
        "}",
        "=",
        ".",
        ",",
        "\"",
        "'",
        "\"\"\"",
        "'''",
        "#",
        "\n",
        "\r\n",
        "\r",
        std::string(1, '\0'),
        "\xff",
        "\xc3\xa4",
        "\\u0000",
        "nan",
        "inf",
        "-",
        "1e308",
        "1e-308",
        "0",
        "-0.0",
        "9223372036854775807",
        "true",
        "1979-05-27",
        "[[sphere]]\n",
        "[camera]\n",
        "[material.x]\n",
        "transform = [{ scale = 0 }]\n",
        "material",
        "name",
        "a.b.c.d",
        "matrix",
        "[0, 0, 0]",
        "\"mesh\"",
        "0x7f",
        "1_0",
        "[[[[[[[[",
        "}}}}",
    };
    return list;
}

std::string damaged(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random()) % n; };
    const std::size_t changes = 1 + below(2);
    for (std::size_t i = 0; i < changes; ++i) {
        const std::size_t at = below(text.size() + 1);
        const std::size_t kind = below(5);
        const std::size_t length = below(40);
        const std::size_t other = below(text.size() + 1);
        if (kind == 0)
            text.insert(at, pieces()[below(pieces().size())]);
        else if (kind == 1)
            text.erase(at, length);
        else if (kind == 2)
            text.insert(at, text.substr(other, length));
        else if (kind == 3 && at < text.size())
            text[at] = static_cast<char>(below(256));
        else
            text.replace(at, std::min(length, text.size() - at), pieces()[below(pieces().size())]);
    }
    return text;
}

TEST(SceneFuzz, DamagedScenesAreReadOrRefused) {
    std::vector<std::string> seeds;
    for (const std::string& name : template_names()) seeds.push_back(template_text(name));
    seeds.push_back(
        "[material.m]\n[[triangle]]\nvertices = [[0,0,0], [1,0,0], [0,1,0]]\nmaterial = \"m\"\ntransform = "
        "[{ matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1] }, { rotate = [1,1,1], angle = 30 }]\n"
        "[[mesh]]\nname = \"a\"\nfile = \"a.ply\"\nscale = [1, 2, 3]\nmaterial = \"m\"\n[[instance]]\nmesh = "
        "\"a\"\n");
    const std::vector<Override> overrides = {"sphere.0.radius=2", "whitted.max_depth=3",
                                             "material.m.color=red"};

    std::mt19937 random(20240611);
    int good = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::string text = damaged(seeds[static_cast<std::size_t>(i) % seeds.size()], random);
        LoadOptions options;
        options.load_meshes = false;
        if (i % 8 == 0) options.overrides = overrides;
        try {
            parse_scene(text, "fuzz.toml", options);
            ++good;
        } catch (const Error& error) {
            ASSERT_FALSE(error.diagnostics().empty()) << i;
            for (const Diagnostic& d : error.diagnostics()) ASSERT_FALSE(d.message.empty()) << i;
        }
    }
    // Damage to comments and numbers often leaves a scene: both ways were taken.
    EXPECT_GT(good, 1000);
    EXPECT_LT(good, 19000);
}

TEST(SceneFuzz, DamagedOverridesAreTakenOrRefused) {
    const std::string text = template_text("glass");
    const std::vector<std::string> seeds = {"material.glass.index=1.33", "light.0.color=[1, 0.5, 2]",
                                            "camera.eye=[1,2,3]",
                                            "polyhedron.block.transform=[{ scale = 2 }]"};
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        const std::string override_text = damaged(seeds[static_cast<std::size_t>(i) % seeds.size()], random);
        try {
            parse(text, {override_text});
        } catch (const Error& error) {
            ASSERT_TRUE(error.kind() == ErrorKind::input || error.kind() == ErrorKind::usage)
                << override_text;
        }
    }
}

} // namespace
} // namespace glint::test
