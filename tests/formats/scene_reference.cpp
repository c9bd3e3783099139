// The reference page and the starter scenes: what they say is what the reader does.

#include "formats/scene/key_table.h"
#include "scene_support.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace glint::test {
namespace {

// GLINT_UPDATE_DOCS=1 test_scene_file writes the page anew.
TEST(SceneReference, TheReferencePageIsUpToDate) {
    const std::string path = std::string(GLINT_SOURCE_DIR) + "/docs/scene-format.md";
    if (std::getenv("GLINT_UPDATE_DOCS")) std::ofstream(path, std::ios::binary) << scene_key_reference();
    std::ifstream page(path, std::ios::binary);
    std::stringstream text;
    text << page.rdbuf();
    EXPECT_EQ(text.str(), scene_key_reference()) << "run this test with GLINT_UPDATE_DOCS=1";
}

TEST(SceneReference, TheReferencePageNamesEveryKey) {
    const std::string page = scene_key_reference();
    for (const TableSpec& table : formats::table_specs())
        for (const KeySpec& key : table.keys)
            EXPECT_NE(page.find("`" + std::string(key.key) + "`"), std::string::npos)
                << table.name << "." << key.key;
}

TEST(SceneReference, EveryTemplateParses) {
    ASSERT_GE(template_names().size(), 3u);
    EXPECT_EQ(template_names().front(), "spheres");
    for (const std::string& name : template_names()) {
        const LoadedScene scene = parse(template_text(name));
        EXPECT_FALSE(scene.description.objects.empty()) << name;
        EXPECT_FALSE(scene.description.lights.empty()) << name;
        EXPECT_TRUE(scene.warnings.empty()) << name;
        EXPECT_EQ(template_text(name).front(), '#') << name << " opens with a comment";
    }
    try {
        template_text("sphere");
        FAIL() << "accepted an unknown template";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_EQ(error.diagnostics()[0].hint, "did you mean \"spheres\"?");
    }
}

} // namespace
} // namespace glint::test
