// SceneDocument under random edits: its promises over every scene and every way of writing.

#include "document_support.h"
#include "formats/scene/table_reader.h"

#include <algorithm>
#include <random>

namespace glint::test {

using formats::TreeEntry;
using formats::TreeValue;

namespace {

namespace fs = std::filesystem;

/// Draws paths and values that may suit them.
class Drawer {
  public:
    Drawer(const std::string& text, unsigned seed) : random_(seed) {
        const formats::SceneSource source(text, "a", {});
        const TreeValue root = formats::parse_tree(source);
        for (const TableSpec& spec : formats::table_specs()) {
            const TreeEntry* entry = root.find(spec.name);
            if (spec.form == TableForm::root)
                add(spec, "", root);
            else if (spec.form == TableForm::one)
                add(spec, std::string(spec.name) + ".", entry ? entry->value : TreeValue{});
            else if (entry)
                add_parts(spec, entry->value);
        }
    }

    struct Draw {
        std::string path;
        std::string value;
    };
    Draw draw() {
        const auto& [path, key] = keys_[below(keys_.size())];
        return {path, value(*key)};
    }

  private:
    void add(const TableSpec& spec, const std::string& path, const TreeValue& table) {
        const std::string type = formats::selected_type(table, spec);
        for (const KeySpec& key : spec.keys)
            if (find_key(spec, key.key, type) == &key) keys_.push_back({path + std::string(key.key), &key});
    }

    void add_parts(const TableSpec& spec, const TreeValue& parts) {
        const std::string table(spec.name);
        for (const TreeEntry& named : parts.entries) add(spec, table + "." + named.key + ".", named.value);
        for (std::size_t i = 0; i < parts.items.size(); ++i) {
            const std::string path = table + "." + std::to_string(i) + ".";
            add(spec, path, parts.items[i]);
            const TreeEntry* transform = parts.items[i].find("transform");
            for (std::size_t k = 0; transform && k < transform->value.items.size(); ++k)
                for (const TreeEntry& entry : transform->value.items[k].entries)
                    keys_.push_back({path + "transform." + std::to_string(k) + "." + entry.key,
                                     find_key(*formats::find_table("transform"), entry.key, {})});
        }
    }

    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
    double number() { return std::uniform_real_distribution<double>(0.01, 1)(random_); }
    std::string three() { return scene_value(Vec3(number(), number(), number())); }

    std::string value(const KeySpec& key) {
        // Now and then something that does not fit.
        if (below(8) == 0) return below(2) == 0 ? "\"what\"" : "-1";
        switch (key.type) {
        case KeyType::boolean:
            return below(2) == 0 ? "true" : "false";
        case KeyType::whole_number:
        case KeyType::whole_number_or_auto:
            return std::to_string(below(9));
        case KeyType::size:
            return "[" + std::to_string(1 + below(99)) + ", 7]";
        case KeyType::choice: {
            const auto words = formats::choice_names(key);
            return words[below(words.size())];
        }
        case KeyType::text:
        case KeyType::file:
            return "a=b \"" + std::to_string(below(1000)) + "\" # c";
        case KeyType::vertices:
            return "[" + three() + ", " + three() + ", " + three() + "]";
        case KeyType::transform:
            return "[{ translate = " + three() + " }, { rotate = [0, 0, 1], angle = 9 }]";
        case KeyType::number:
        case KeyType::number_or_auto:
            return scene_value(number());
        default:
            return three();
        }
    }

    struct Key {
        std::string path;
        const KeySpec* spec;
    };
    std::mt19937 random_;
    std::vector<Key> keys_;
};

/// All bytes but one run of them are the same.
bool differs_in_one_run(const std::string& a, const std::string& b, std::size_t run_of_a) {
    const auto front = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
    const auto back = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend()).first - a.rbegin();
    return static_cast<std::size_t>(front + back) + run_of_a >= a.size();
}

// The promises of a document, for one edit; whether the edit was a valid one.
bool keeps_its_promises(const std::string& text, const Drawer::Draw& draw) {
    SceneDocument edited = document(text);
    const auto old_value = edited.value(draw.path);
    std::string expected, refusal;
    try {
        expected = meaning(text, {draw.path + "=" + draw.value});
    } catch (const Error& error) {
        refusal = error.what();
    }
    try {
        edited.set(draw.path, draw.value);
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), refusal);
        EXPECT_EQ(edited.text(), text);
        return false;
    }
    EXPECT_EQ(refusal, "");
    EXPECT_EQ(meaning(edited.text()), expected);
    EXPECT_TRUE(differs_in_one_run(text, edited.text(), old_value ? old_value->size() : 0));
    if (old_value) {
        edited.set(draw.path, *old_value);
        EXPECT_EQ(edited.text(), text);
    }
    return true;
}

int valid_edits(const std::string& text, int count) {
    Drawer drawer(text, static_cast<unsigned>(text.size()));
    int valid = 0;
    for (int i = 0; i < count; ++i) {
        const Drawer::Draw draw = drawer.draw();
        valid += keeps_its_promises(text, draw) ? 1 : 0;
        if (testing::Test::HasFailure()) {
            ADD_FAILURE() << draw.path << " = " << draw.value;
            return valid;
        }
    }
    return valid;
}

TEST(SceneDocument, KeepsItsPromisesOverRandomEditsOfEveryScene) {
    int scenes = 0, valid = 0;
    for (const auto& entry : fs::recursive_directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        const std::string text = contents(entry.path().string());
        SCOPED_TRACE(entry.path().string());
        valid += valid_edits(text, text.size() > 20000 ? 3 : 15);
        ++scenes;
    }
    EXPECT_GE(scenes, 30);
    EXPECT_GE(valid, 5 * scenes);
}

TEST(SceneDocument, KeepsItsPromisesOverRandomEditsOfEveryWayOfWriting) {
    std::string windows = "\xef\xbb\xbf";
    for (const char c : std::string(odd_scene))
        windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_GE(valid_edits(odd_scene, 400), 150);
    EXPECT_GE(valid_edits(windows, 400), 150);
}

TEST(SceneDocument, ManyEditsSayTheSameAsManyOverrides) {
    Drawer drawer(odd_scene, 7);
    SceneDocument edited = document(odd_scene);
    std::vector<Override> overrides;
    for (int i = 0; i < 200; ++i) {
        const Drawer::Draw draw = drawer.draw();
        if (draw.path.ends_with(".name")) continue; // later paths would lead elsewhere
        try {
            edited.set(draw.path, draw.value);
        } catch (const Error&) {
            continue;
        }
        overrides.push_back(draw.path + "=" + draw.value);
        ASSERT_EQ(meaning(edited.text()), meaning(odd_scene, overrides)) << overrides.back();
    }
    SceneDocument again = edited;
    again.rebase(odd_scene);
    EXPECT_EQ(meaning(again.text()), meaning(edited.text()));
    EXPECT_GE(overrides.size(), 80u);
}

} // namespace
} // namespace glint::test
