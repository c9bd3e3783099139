// Scenes and values written as TOML.

#include "document_support.h"
#include "formats/scene/key_table.h"
#include "formats/scene/tree.h"
#include "formats/scene/write.h"

#include <cmath>
#include <cstring>
#include <random>

namespace glint::test {

using formats::default_text;

namespace {

// ── Values ─────────────────────────────────────────────────────────────────────────────────────────────────

TEST(SceneValue, ReadsBackAsExactlyTheSameNumber) {
    std::mt19937_64 random(1);
    std::vector<double> numbers = {0.0,
                                   -0.0,
                                   1.0,
                                   0.1,
                                   1e18,
                                   1e19,
                                   12345678901234567890.0,
                                   9007199254740993.0,
                                   4.9e-324,
                                   1.7976931348623157e308,
                                   -1e15,
                                   1e22,
                                   123456.0};
    for (int i = 0; i < 2000; ++i) {
        const auto bits = random();
        double x = 0;
        std::memcpy(&x, &bits, sizeof x);
        if (std::isfinite(x)) numbers.push_back(x);
        numbers.push_back(static_cast<double>(bits));
    }
    for (const double x : numbers) {
        const auto tree = formats::parse_tree_value(scene_value(x), {});
        ASSERT_TRUE(tree) << scene_value(x);
        EXPECT_EQ(std::memcmp(&tree->number, &x, sizeof x), 0) << scene_value(x);
    }
}

TEST(SceneValue, ReadsBackAsExactlyTheSameText) {
    for (const std::string text : {"", "a", "\"", "\\", "a\nb\tc", "\x01\x7f", "ä # =", "'"})
        EXPECT_EQ(formats::parse_tree_value(scene_value(text), {}).value().text, text);
}

// ── Scenes written anew ────────────────────────────────────────────────────────────────────────────────────

/// A value of the key that is not its default.
std::string other_value(const KeySpec& key) {
    switch (key.type) {
    case KeyType::boolean:
        return default_text(key) == "true" ? "false" : "true";
    case KeyType::whole_number:
    case KeyType::whole_number_or_auto:
        return key.key == "version" ? "1" : "7";
    case KeyType::choice:
        for (const std::string& word : formats::choice_names(key))
            if (scene_value(word) != default_text(key)) return scene_value(word);
        return default_text(key);
    case KeyType::text:
    case KeyType::file:
        return "\"m\"";
    case KeyType::size:
        return "[12, 34]";
    case KeyType::vertices:
        return "[[0, 0, 0], [0.1, 0, 0], [0, 0.3, 0]]";
    case KeyType::transform:
        return "[{ translate = [1, 0.1, 0] }, { rotate = [0, 0, 1], angle = 9 }]";
    case KeyType::number:
    case KeyType::number_or_auto:
        return "0.123";
    default:
        // Directions that a table combines must not be parallel.
        return key.key == "up" || key.key == "v" ? "[0.5, 0, 0.7]" : "[0.3, 0.2, 0.7]";
    }
}

/// One table of the type that says every key otherwise than by default.
std::string full_table(const TableSpec& spec, const std::string& type) {
    std::string text = spec.header("\"odd. \\\"name\\\"\"") + "\n";
    for (const KeySpec& key : spec.keys) {
        const bool second = key.key == "look_at";
        if (find_key(spec, key.key, type) != &key || second || key.key == "radiant_intensity") continue;
        text += std::string(key.key) + " = " +
                (key.key == spec.selector ? '"' + type + '"' : other_value(key)) + "\n";
    }
    return text;
}

TEST(SceneText, SaysEveryKeyOfTheKeyTable) {
    const std::string around = "[material.m]\n";
    int tables = 0;
    for (const TableSpec& spec : formats::table_specs()) {
        if (spec.form == TableForm::root || spec.form == TableForm::entry) continue;
        if (spec.name == "animation" || spec.name == "animate") continue; // no part of a description
        const KeySpec* selector = spec.selector.empty() ? nullptr : find_key(spec, spec.selector, {});
        for (const std::string& type :
             selector ? formats::choice_names(*selector) : std::vector<std::string>{""}) {
            std::string text = full_table(spec, type) + around;
            if (spec.name == "instance")
                text += "[[mesh]]\nname = \"m\"\nfile = \"a.ply\"\nmaterial = \"m\"\n";
            const std::string anew = meaning(text);
            EXPECT_EQ(meaning(anew), anew);
            for (const KeySpec& key : spec.keys) {
                const std::string line = "\n" + std::string(key.key) + " = ";
                if (text.find(line) == std::string::npos || other_value(key) == default_text(key)) continue;
                EXPECT_NE(anew.find(line), std::string::npos) << key.key << " of " << text;
            }
            ++tables;
        }
    }
    EXPECT_GE(tables, 20);
}

TEST(SceneText, ReadsBackAsTheSameValues) {
    const SceneDescription a = parse(odd_scene).description;
    const SceneDescription b = parse(scene_text(a)).description;
    EXPECT_EQ(a.camera->eye, b.camera->eye);
    EXPECT_EQ(a.camera->direction, b.camera->direction);
    EXPECT_EQ(a.render.width, b.render.width);
    EXPECT_EQ(a.whitted.max_depth, b.whitted.max_depth);
    ASSERT_EQ(b.materials.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(a.materials[i].name, b.materials[i].name);
    EXPECT_EQ(a.materials[0].color, b.materials[0].color);
    EXPECT_EQ(a.objects[0].transform, b.objects[0].transform);
    EXPECT_EQ(std::get<PointLight>(a.lights[0].kind).position,
              std::get<PointLight>(b.lights[0].kind).position);
    EXPECT_EQ(scene_text({}), "");
}

TEST(SceneText, CannotNameAMeshThatHasNoFile) {
    SceneDescription scene;
    scene.objects.emplace_back().shape = MeshShape{};
    EXPECT_THROW(scene_text(scene), Error);
}

TEST(CameraText, IsACameraTable) {
    EXPECT_EQ(camera_text({}), "[camera]\neye = [0, 0, 0]\ndirection = [0, 1, 0]\n");
}

} // namespace
} // namespace glint::test
