// The reference page and the starter scenes: what they say is what the reader does.

#include "formats/key_table.h"
#include "scene_support.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace glint::test {
namespace {

// A scene that says every default of the key table explicitly, and one that says none.
struct DefaultsCase {
    const char* required; ///< the table with what it requires
    const char* table;
    const char* type;
};

std::string said(const DefaultsCase& c) {
    std::string text = c.required;
    const TableSpec& table = *find_table(c.table);
    for (const KeySpec& key : table.keys) {
        if (find_key(table, key.key, c.type) != &key || key.fallback.empty()) continue;
        text += std::string(key.key) + " = " + std::string(key.fallback) + "\n";
    }
    return text + "[material.m]\n";
}

void expect_same(const SceneDescription& a, const SceneDescription& b) {
    ASSERT_EQ(a.objects.size(), b.objects.size());
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        EXPECT_EQ(a.objects[i].visible, b.objects[i].visible);
        EXPECT_EQ(a.objects[i].priority, b.objects[i].priority);
        EXPECT_EQ(a.objects[i].transform, b.objects[i].transform);
    }
}

TEST(SceneReference, ThePagesDefaultsAreTheDefaultsOfTheValues) {
    const auto render = parse(said({"[render]\n", "render", ""})).description.render;
    const RenderSettings r;
    EXPECT_EQ(render.width, r.width);
    EXPECT_EQ(render.height, r.height);
    EXPECT_EQ(render.spp, r.spp);
    EXPECT_EQ(render.seed, r.seed);
    EXPECT_EQ(render.integrator, r.integrator);
    EXPECT_EQ(render.filter, r.filter);
    EXPECT_EQ(render.background, r.background);

    const auto whitted = parse(said({"[whitted]\n", "whitted", ""})).description.whitted;
    const WhittedSettings w;
    EXPECT_EQ(whitted.max_depth, w.max_depth);
    EXPECT_EQ(whitted.shadows, w.shadows);
    EXPECT_EQ(whitted.clamp, w.clamp);
    EXPECT_EQ(whitted.energy, w.energy);
    EXPECT_EQ(whitted.highlight_model, w.highlight_model);
    EXPECT_EQ(whitted.index, w.index);

    const auto camera =
        *parse(said({"[camera]\neye = [1,1,1]\nlook_at = [0,0,0]\n", "camera", ""})).description.camera;
    EXPECT_EQ(camera.up, CameraDescription{}.up);
    EXPECT_EQ(camera.fov, CameraDescription{}.fov);
    EXPECT_EQ(camera.fov_axis, CameraDescription{}.fov_axis);

    const auto material = parse(said({"[material.x]\n", "material", ""})).description.materials[0];
    const Material m;
    EXPECT_EQ(material.color, m.color);
    EXPECT_EQ(material.ambient, m.ambient);
    EXPECT_EQ(material.diffuse, m.diffuse);
    EXPECT_EQ(material.highlight, m.highlight);
    EXPECT_EQ(material.shininess, m.shininess);
    EXPECT_EQ(material.reflectivity, m.reflectivity);
    EXPECT_EQ(material.transparency, m.transparency);
    EXPECT_EQ(material.index, m.index);
    EXPECT_EQ(material.absorption, m.absorption);
    EXPECT_EQ(material.fresnel, m.fresnel);
    EXPECT_EQ(material.emission, m.emission);
}

TEST(SceneReference, ThePagesDefaultsAreTheDefaultsOfShapes) {
    const DefaultsCase plane{"[[plane]]\nnormal = [0,0,1]\nmaterial = \"m\"\n", "plane", ""};
    EXPECT_EQ(only_shape<PlaneShape>(parse(said(plane))).offset, PlaneShape{}.offset);
    EXPECT_EQ(only_shape<PlaneShape>(parse(said(plane))).solid, PlaneShape{}.solid);
    expect_same(parse(said(plane)).description,
                parse(std::string(plane.required) + "[material.m]").description);

    const auto cylinder = only_shape<CylinderShape>(parse(
        said({"[[cylinder]]\nbase = [0,0,0]\nheight = 1\nradius = 1\nmaterial = \"m\"\n", "cylinder", ""})));
    EXPECT_EQ(cylinder.axis, CylinderShape{}.axis);

    const auto box = only_shape<PolyhedronShape>(
        parse(said({"[[polyhedron]]\nkind = \"box\"\nmaterial = \"m\"\n", "polyhedron", "box"})));
    EXPECT_EQ(box.center, PolyhedronShape{}.center);
    EXPECT_EQ(box.size, PolyhedronShape{}.size);
    const auto prism = only_shape<PolyhedronShape>(
        parse(said({"[[polyhedron]]\nkind = \"prism\"\nmaterial = \"m\"\n", "polyhedron", "prism"})));
    EXPECT_EQ(prism.radius, PolyhedronShape{}.radius);
    EXPECT_EQ(prism.sides, PolyhedronShape{}.sides);
    EXPECT_EQ(prism.height, PolyhedronShape{}.height);
    EXPECT_EQ(prism.axis, PolyhedronShape{}.axis);

    const auto mesh =
        only_shape<MeshShape>(parse(said({"[[mesh]]\nfile = \"a.ply\"\nmaterial = \"m\"\n", "mesh", ""})));
    EXPECT_EQ(mesh.scale, MeshShape{}.scale);
    EXPECT_EQ(mesh.normals, MeshShape{}.normals);
    EXPECT_EQ(mesh.vertex_colors, MeshShape{}.vertex_colors);
    EXPECT_EQ(mesh.point_radius, MeshShape{}.point_radius);
}

TEST(SceneReference, ThePagesDefaultsAreTheDefaultsOfLights) {
    const auto ambient =
        only_light<AmbientLight>(parse(said({"[[light]]\ntype = \"ambient\"\n", "light", "ambient"})));
    EXPECT_EQ(ambient.color, AmbientLight{}.color);
    const auto point = only_light<PointLight>(
        parse(said({"[[light]]\ntype = \"point\"\nposition = [0,0,0]\n", "light", "point"})));
    EXPECT_EQ(point.color, PointLight{}.color);
    EXPECT_EQ(point.intensity, PointLight{}.intensity);
    const auto sun = only_light<DirectionalLight>(
        parse(said({"[[light]]\ntype = \"directional\"\ndirection = [0,0,1]\n", "light", "directional"})));
    EXPECT_EQ(sun.color, DirectionalLight{}.color);
    EXPECT_EQ(sun.irradiance, DirectionalLight{}.irradiance);
    const auto spot = only_light<SpotLight>(parse(
        said({"[[light]]\ntype = \"spot\"\nposition = [0,0,0]\ndirection = [0,0,1]\n", "light", "spot"})));
    EXPECT_EQ(spot.angle, SpotLight{}.angle);
    EXPECT_EQ(spot.blend, SpotLight{}.blend);
    EXPECT_EQ(spot.color, SpotLight{}.color);
    EXPECT_EQ(spot.intensity, SpotLight{}.intensity);
}

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
    for (const TableSpec& table : table_specs())
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
