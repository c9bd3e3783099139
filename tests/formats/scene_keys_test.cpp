// Every key of scene files: that it is read, and what stands without it.

#include "scene_support.h"

#include "glint/document.h"

#include <numbers>

namespace glint::test {
namespace {

TEST(SceneKeys, AnEmptyFileIsAnEmptySceneWithDefaults) {
    for (const char* text : {"", "\n", "# only a comment", "version = 1\n", "\xef\xbb\xbf"}) {
        const SceneDescription d = parse(text).description;
        EXPECT_FALSE(d.camera);
        EXPECT_TRUE(d.materials.empty() && d.objects.empty() && d.lights.empty());
        EXPECT_EQ(d.render.width, 640);
        EXPECT_EQ(d.render.height, 480);
        EXPECT_FALSE(d.render.spp);
        EXPECT_EQ(d.render.filter, PixelFilter::box);
        EXPECT_EQ(d.whitted.max_depth, 8);
        EXPECT_EQ(d.whitted.shadows, Shadows::transmissive);
    }
}

TEST(SceneKeys, TheCameraIsRead) {
    const auto camera = *parse(R"([camera]
eye = [1, 2, 3]
look_at = [2, 4, 6.5]
up = [0, 1, 0]
fov = 60
fov_axis = "larger")")
                             .description.camera;
    EXPECT_EQ(camera.eye, Vec3(1, 2, 3));
    EXPECT_EQ(camera.direction, Vec3(1, 2, 3.5));
    EXPECT_EQ(camera.up, Vec3(0, 1, 0));
    EXPECT_EQ(camera.fov, 60);
    EXPECT_EQ(camera.fov_axis, FovAxis::larger);
    EXPECT_EQ(camera.where, (Location{"scenes/a.toml", 1, 1, {}}));

    const auto other = *parse("camera = { eye = [0, 0, 0], direction = [0, 3, -4] }").description.camera;
    EXPECT_EQ(other.direction, Vec3(0, 3, -4));
    EXPECT_EQ(other.up, Vec3(0, 0, 1));
    EXPECT_EQ(other.fov, 45);
    EXPECT_EQ(other.fov_axis, FovAxis::y);
}

TEST(SceneKeys, RenderAndWhittedAreRead) {
    const SceneDescription d = parse(R"(version = 1
[render]
size = [65536, 16384]
spp = 1048576
seed = 9223372036854775807
integrator = "whitted"
filter = "tent"
background = [0.5, 1, 2]
[whitted]
max_depth = 0
shadows = "opaque"
clamp = true
energy = "balanced"
highlight_model = "phong"
index = 1.33)")
                                   .description;
    EXPECT_EQ(d.render.width, 65536);
    EXPECT_EQ(d.render.height, 16384);
    EXPECT_EQ(d.render.spp, 1048576);
    EXPECT_EQ(d.render.seed, 9223372036854775807u);
    EXPECT_EQ(d.render.integrator, Integrator::whitted);
    EXPECT_EQ(d.render.filter, PixelFilter::tent);
    EXPECT_EQ(d.render.background, Vec3(0.5, 1, 2));
    EXPECT_EQ(d.whitted.max_depth, 0);
    EXPECT_EQ(d.whitted.shadows, Shadows::opaque);
    EXPECT_TRUE(d.whitted.clamp);
    EXPECT_EQ(d.whitted.energy, Energy::balanced);
    EXPECT_EQ(d.whitted.highlight_model, HighlightModel::phong);
    EXPECT_EQ(d.whitted.index, 1.33);
}

TEST(SceneKeys, ChoicesMeanWhatTheySay) {
    const auto filter = [](const std::string& name) {
        return parse("render.filter = \"" + name + "\"").description.render.filter;
    };
    EXPECT_EQ(filter("box"), PixelFilter::box);
    EXPECT_EQ(filter("tent"), PixelFilter::tent);
    EXPECT_EQ(filter("gaussian"), PixelFilter::gaussian);
    EXPECT_EQ(filter("mitchell"), PixelFilter::mitchell);
    const auto fov_axis = [](const std::string& name) {
        return parse("camera = { eye = [0,0,0], direction = [0,1,0], fov_axis = \"" + name + "\" }")
            .description.camera->fov_axis;
    };
    EXPECT_EQ(fov_axis("y"), FovAxis::y);
    EXPECT_EQ(fov_axis("x"), FovAxis::x);
    EXPECT_EQ(fov_axis("smaller"), FovAxis::smaller);
    EXPECT_EQ(fov_axis("larger"), FovAxis::larger);
    const auto kind = [](const std::string& name) {
        return only_shape<PolyhedronShape>(
                   parse(with_material("[[polyhedron]]\nmaterial = \"m\"\nkind = \"" + name + "\"")))
            .kind;
    };
    EXPECT_EQ(kind("box"), PolyhedronKind::box);
    EXPECT_EQ(kind("tetrahedron"), PolyhedronKind::tetrahedron);
    EXPECT_EQ(kind("octahedron"), PolyhedronKind::octahedron);
    EXPECT_EQ(kind("dodecahedron"), PolyhedronKind::dodecahedron);
    EXPECT_EQ(kind("icosahedron"), PolyhedronKind::icosahedron);
    EXPECT_EQ(kind("prism"), PolyhedronKind::prism);
    EXPECT_EQ(kind("pyramid"), PolyhedronKind::pyramid);
}

TEST(SceneKeys, MaterialsAreReadInTheirOrder) {
    const SceneDescription d = parse(R"([material.zinc]
color = [0.25, 0.5, 2]
ambient = 0
diffuse = 0.5
highlight = 3
shininess = 0
reflectivity = 0.25
transparency = 1
index = 0.9
absorption = [0, 1, 20]
fresnel = true
emission = [9, 8, 7]
[material."a b"])")
                                   .description;
    ASSERT_EQ(d.materials.size(), 2u);
    const Material& m = d.materials[0];
    EXPECT_EQ(m.name, "zinc");
    EXPECT_EQ(m.color, Vec3(0.25, 0.5, 2));
    EXPECT_EQ(m.ambient, 0);
    EXPECT_EQ(m.diffuse, 0.5);
    EXPECT_EQ(m.highlight, 3);
    EXPECT_EQ(m.shininess, 0);
    EXPECT_EQ(m.reflectivity, 0.25);
    EXPECT_EQ(m.transparency, 1);
    EXPECT_EQ(m.index, 0.9);
    EXPECT_EQ(m.absorption, Vec3(0, 1, 20));
    EXPECT_TRUE(m.fresnel);
    EXPECT_EQ(m.emission, Vec3(9, 8, 7));
    EXPECT_EQ(m.where.line, 1);
    EXPECT_EQ(d.materials[1].name, "a b");
    EXPECT_EQ(d.materials[1].color, Vec3(0.8));
    EXPECT_EQ(d.materials[1].ambient, 1);
    EXPECT_EQ(d.materials[1].shininess, 32);
    EXPECT_EQ(d.materials[1].index, 1.5);
}

TEST(SceneKeys, ModelsOfMaterialsHaveTheirKeysAndDefaults) {
    const std::vector<Material> all = parse(R"([material.a]
[material.b]
model = "diffuse"
opacity = 0.5
emission_sides = "front"
[material.c]
model = "conductor"
metal = "gold"
roughness = 0.3
[material.d]
model = "dielectric"
absorption = [1, 2, 3]
[material.e]
model = "plastic"
[material.f]
roughness = 1
metallic = 0.25
transmission = 0.5
clearcoat = 0.75
clearcoat_roughness = 0.125
sheen = 0.5
sheen_color = [1, 0, 0]
specular = 0.5
specular_color = [0, 1, 0]
model = "principled"
[material.g]
model = "principled")")
                                          .description.materials;
    ASSERT_EQ(all.size(), 7u);
    EXPECT_EQ(all[0].model, MaterialModel::whitted);
    EXPECT_EQ(all[1].model, MaterialModel::diffuse);
    EXPECT_EQ(all[1].opacity, 0.5);
    EXPECT_EQ(all[1].emission_sides, EmissionSides::front);
    EXPECT_EQ(all[2].metal, Metal::gold);
    EXPECT_EQ(all[2].roughness, 0.3);
    EXPECT_EQ(all[3].color, Vec3(1));
    EXPECT_EQ(all[3].roughness, 0);
    EXPECT_EQ(all[3].absorption, Vec3(1, 2, 3));
    EXPECT_EQ(all[4].color, Vec3(0.8));
    EXPECT_EQ(all[4].roughness, 0.2);
    EXPECT_EQ(all[5].roughness, 1);
    EXPECT_EQ(all[5].metallic, 0.25);
    EXPECT_EQ(all[5].transmission, 0.5);
    EXPECT_EQ(all[5].clearcoat, 0.75);
    EXPECT_EQ(all[5].clearcoat_roughness, 0.125);
    EXPECT_EQ(all[5].sheen, 0.5);
    EXPECT_EQ(all[5].sheen_color, Vec3(1, 0, 0));
    EXPECT_EQ(all[5].specular, 0.5);
    EXPECT_EQ(all[5].specular_color, Vec3(0, 1, 0));
    EXPECT_EQ(all[6].roughness, 0.5);
}

TEST(SceneKeys, MaterialsOfEveryModelSurviveWriting) {
    SceneDescription scene;
    for (const MaterialModel model :
         {MaterialModel::whitted, MaterialModel::diffuse, MaterialModel::conductor, MaterialModel::dielectric,
          MaterialModel::plastic, MaterialModel::principled}) {
        Material m;
        m.name = name_of(model);
        m.model = model;
        m.color = Vec3(0.25, 0.5, 0.75);
        m.roughness = 0.2;
        scene.materials.push_back(m);
        m.name += " 2";
        m.color = Vec3(1);
        if (model == MaterialModel::conductor) m.metal = Metal::silver;
        m.roughness = 0;
        scene.materials.push_back(m);
    }
    const std::vector<Material> read = parse(scene_text(scene)).description.materials;
    ASSERT_EQ(read.size(), scene.materials.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const Material& m = scene.materials[i];
        EXPECT_EQ(read[i].model, m.model);
        EXPECT_EQ(read[i].metal, m.metal);
        EXPECT_TRUE(m.metal || read[i].color == m.color) << m.name;
        EXPECT_TRUE(m.model <= MaterialModel::diffuse || read[i].roughness == m.roughness) << m.name;
    }
}

TEST(SceneKeys, ShapesAreRead) {
    const auto plane = only_shape<PlaneShape>(
        parse(with_material("[[plane]]\nnormal = [0, 2, 0]\noffset = -7\nsolid = true\nmaterial = \"m\"")));
    EXPECT_EQ(plane.normal, Vec3(0, 2, 0));
    EXPECT_EQ(plane.offset, -7);
    EXPECT_TRUE(plane.solid);

    const auto sphere = only_shape<SphereShape>(
        parse(with_material("[[sphere]]\ncenter = [1, 2, 3]\nradius = 4\nmaterial = \"m\"")));
    EXPECT_EQ(sphere.center, Vec3(1, 2, 3));
    EXPECT_EQ(sphere.radius, 4);

    const auto cylinder = only_shape<CylinderShape>(parse(with_material(
        "[[cylinder]]\nbase = [1, 2, 3]\naxis = [0, 1, 1]\nheight = 5\nradius = 0.5\nmaterial = \"m\"")));
    EXPECT_EQ(cylinder.base, Vec3(1, 2, 3));
    EXPECT_EQ(cylinder.axis, Vec3(0, 1, 1));
    EXPECT_EQ(cylinder.height, 5);
    EXPECT_EQ(cylinder.radius, 0.5);

    const auto cone = only_shape<ConeShape>(parse(with_material(
        "[[cone]]\nbase = [1, 2, 3]\naxis = [0, 1, 1]\nheight = 5\nradius = 0.5\nmaterial = \"m\"")));
    EXPECT_EQ(cone, (ConeShape{Vec3(1, 2, 3), Vec3(0, 1, 1), 5, 0.5}));

    const auto disk = only_shape<DiskShape>(parse(
        with_material("[[disk]]\ncenter = [1, 2, 3]\nnormal = [0, 2, 1]\nradius = 4\nmaterial = \"m\"")));
    EXPECT_EQ(disk, (DiskShape{Vec3(1, 2, 3), Vec3(0, 2, 1), 4}));

    const auto rectangle = only_shape<RectangleShape>(parse(with_material(
        "[[rectangle]]\ncorner = [1, 2, 3]\nu = [0, 2, 1]\nv = [1, 0, 0.5]\nmaterial = \"m\"")));
    EXPECT_EQ(rectangle, (RectangleShape{Vec3(1, 2, 3), Vec3(0, 2, 1), Vec3(1, 0, 0.5)}));

    const auto triangle = only_shape<TriangleShape>(
        parse(with_material("[[triangle]]\nvertices = [[0,0,0], [1,0,0], [0,1,0.5]]\nmaterial = \"m\"")));
    EXPECT_EQ(triangle.vertices[2], Vec3(0, 1, 0.5));
}

TEST(SceneKeys, PolyhedraAreRead) {
    const auto box = only_shape<PolyhedronShape>(parse(with_material(
        "[[polyhedron]]\nkind = \"box\"\ncenter = [1, 2, 3]\nsize = [4, 5, 6]\nmaterial = \"m\"")));
    EXPECT_EQ(box.center, Vec3(1, 2, 3));
    EXPECT_EQ(box.size, Vec3(4, 5, 6));
    const auto prism = only_shape<PolyhedronShape>(
        parse(with_material("[[polyhedron]]\nkind = \"prism\"\nradius = 2\nsides = 5\nheight = 3\naxis = [1, "
                            "0, 0]\nmaterial = \"m\"")));
    EXPECT_EQ(prism.radius, 2);
    EXPECT_EQ(prism.sides, 5);
    EXPECT_EQ(prism.height, 3);
    EXPECT_EQ(prism.axis, Vec3(1, 0, 0));
}

TEST(SceneKeys, MeshesAndInstancesAreRead) {
    const SceneDescription d = parse(with_material(R"([[mesh]]
name = "cat"
file = "meshes/cat.ply"
scale = -20
normals = "smooth"
vertex_colors = "ignore"
point_radius = 0.25
material = "m"
[[mesh]]
file = "cat.ply"
scale = [1, 2, 3]
point_radius = "auto"
normals = "flat"
material = "m"
[[instance]]
mesh = "cat"
[[instance]]
mesh = "cat"
name = "second"
material = "m"
)"))
                                   .description;
    ASSERT_EQ(d.objects.size(), 4u);
    const auto& cat = std::get<MeshShape>(d.objects[0].shape);
    EXPECT_EQ(cat.file, "meshes/cat.ply");
    EXPECT_EQ(cat.scale, Vec3(-20));
    EXPECT_EQ(cat.normals, NormalsMode::smooth);
    EXPECT_EQ(cat.vertex_colors, VertexColors::ignore);
    EXPECT_EQ(cat.point_radius, 0.25);
    EXPECT_FALSE(cat.data);
    const auto& other = std::get<MeshShape>(d.objects[1].shape);
    EXPECT_EQ(other.scale, Vec3(1, 2, 3));
    EXPECT_EQ(other.normals, NormalsMode::flat);
    EXPECT_EQ(other.vertex_colors, VertexColors::automatic);
    EXPECT_FALSE(other.point_radius);
    EXPECT_EQ(std::get<InstanceShape>(d.objects[2].shape).mesh, "cat");
    EXPECT_EQ(d.objects[2].material, "");
    EXPECT_EQ(d.objects[3].material, "m");
    EXPECT_EQ(d.objects[3].name, "second");
}

TEST(SceneKeys, EveryObjectHasTheCommonKeys) {
    const Object object = only_object(parse(with_material(R"(
[[sphere]]
center = [0, 0, 0]
radius = 1
name = "ball"
material = "m"
visible = false
priority = -3
transform = [{ translate = [1, 2, 3] }])")));
    EXPECT_EQ(object.name, "ball");
    EXPECT_EQ(object.material, "m");
    EXPECT_FALSE(object.visible);
    EXPECT_EQ(object.priority, -3);
    EXPECT_EQ(object.transform[3], glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(object.where, (Location{"scenes/a.toml", 3, 1, {}}));
}

TEST(SceneKeys, LightsAreRead) {
    EXPECT_EQ(only_light<AmbientLight>(parse("[[light]]\ntype = \"ambient\"")).color, Vec3(0.1));
    EXPECT_EQ(only_light<AmbientLight>(parse("[[light]]\ntype = \"ambient\"\ncolor = [1, 2, 3]")).color,
              Vec3(1, 2, 3));

    const auto point = only_light<PointLight>(
        parse("[[light]]\ntype = \"point\"\nposition = [1, 2, 3]\ncolor = [3, 2, 1]\nintensity = 500"));
    EXPECT_EQ(point.position, Vec3(1, 2, 3));
    EXPECT_EQ(point.color, Vec3(3, 2, 1));
    EXPECT_EQ(point.intensity, 500);

    const auto sun = only_light<DirectionalLight>(parse(
        "[[light]]\ntype = \"directional\"\ndirection = [1, 0, -1]\ncolor = [3, 2, 1]\nirradiance = 2"));
    EXPECT_EQ(sun.direction, Vec3(1, 0, -1));
    EXPECT_EQ(sun.color, Vec3(3, 2, 1));
    EXPECT_EQ(sun.irradiance, 2);

    const auto spot =
        only_light<SpotLight>(parse("[[light]]\ntype = \"spot\"\nposition = [1, 2, 3]\n"
                                    "direction = [0, 0, -2]\nangle = 90\nblend = 1\ncolor = [3, 2, 1]\n"
                                    "intensity = 0"));
    EXPECT_EQ(spot.position, Vec3(1, 2, 3));
    EXPECT_EQ(spot.direction, Vec3(0, 0, -2));
    EXPECT_EQ(spot.angle, 90);
    EXPECT_EQ(spot.blend, 1);
    EXPECT_EQ(spot.color, Vec3(3, 2, 1));
    EXPECT_EQ(spot.intensity, 0);
}

TEST(SceneKeys, RadiantIntensityIsPiTimesIntensity) {
    const auto light = only_light<PointLight>(
        parse("[[light]]\ntype = \"point\"\nposition = [0, 0, 1]\nradiant_intensity = 10"));
    EXPECT_EQ(light.intensity, 10 / std::numbers::pi);
}

TEST(SceneKeys, ObjectsAndLightsStandInTheOrderOfTheFile) {
    const SceneDescription mixed = parse(R"(
[[sphere]]
name = "s0"
center = [0, 0, 0]
radius = 1
material = "m"
[[light]]
type = "point"
position = [0, 0, 1]
[[plane]]
name = "p0"
normal = [0, 0, 1]
material = "m"
  [[sphere]]
name = "s1"
center = [0, 0, 0]
radius = 1
material = "m"
[material.m]
[[light]]
type = "ambient"
[[cylinder]]
name = "c0"
base = [0, 0, 0]
height = 1
radius = 1
material = "m"
[[plane]]
name = "p1"
normal = [0, 0, 1]
material = "m"
)")
                                       .description;
    std::vector<std::string> names;
    for (const Object& object : mixed.objects) names.push_back(object.name);
    EXPECT_EQ(names, (std::vector<std::string>{"s0", "p0", "s1", "c0", "p1"}));
    EXPECT_TRUE(std::holds_alternative<PointLight>(mixed.lights[0].kind));
    EXPECT_TRUE(std::holds_alternative<AmbientLight>(mixed.lights[1].kind));
}

TEST(SceneKeys, InlineListsOfTablesStandInTheOrderOfTheFile) {
    const SceneDescription d = parse(R"(
sphere = [{ center = [0,0,0], radius = 1, material = "m", name = "a" }, { center = [0,0,0], radius = 1, material = "m", name = "b" }]
plane = [{ normal = [0,0,1], material = "m", name = "c" }]
[material.m]
)")
                                   .description;
    ASSERT_EQ(d.objects.size(), 3u);
    EXPECT_EQ(d.objects[0].name, "a");
    EXPECT_EQ(d.objects[1].name, "b");
    EXPECT_EQ(d.objects[2].name, "c");
}

TEST(SceneKeys, CrlfAndByteOrderMarkAreAccepted) {
    const auto camera =
        *parse("\xef\xbb\xbf[camera]\r\neye = [1, 2, 3]\r\nlook_at = [0, 0, 0]\r\n").description.camera;
    EXPECT_EQ(camera.eye, Vec3(1, 2, 3));
    EXPECT_EQ(camera.where.column, 1);
}

TEST(SceneKeys, ReflectivityAboveOneWarns) {
    const LoadedScene scene = parse("[material.m]\nreflectivity = 1.25\n");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].severity, Severity::warning);
    EXPECT_EQ(scene.warnings[0].message, "\"reflectivity\" 1.25 is above 1");
    EXPECT_EQ(scene.warnings[0].location, (Location{"scenes/a.toml", 2, 16, {}}));
    EXPECT_TRUE(parse("[material.m]\nreflectivity = 1\n").warnings.empty());
}

TEST(SceneKeys, AnglesInRadiansWarn) {
    const auto warned = [](const std::string& table) {
        return parse("[material.m]\n[[mesh]]\nname = \"a\"\nfile = \"a.ply\"\nmaterial = \"m\"\n" + table)
            .warnings;
    };
    const auto turned = [](const std::string& angle) {
        return "transform = [{ rotate = [0, 0, 1], angle = " + angle + " }]\n";
    };
    const std::string spot = "[[light]]\ntype = \"spot\"\nposition = [0, 0, 9]\ndirection = [0, 0, -1]\n";
    const std::string camera = "[camera]\neye = [0, -5, 0]\nlook_at = [0, 0, 0]\n";
    for (const std::string& table :
         {camera + "fov = 0.785\n", spot + "angle = 0.35\n", turned("1.5708"), turned("-0.785"),
          turned("3.14159265"), turned("1.57"), std::string("normals = \"smooth\"\ncrease_angle = 0.5236\n")})
        EXPECT_EQ(warned(table).size(), 1u) << table;
    for (const std::string& table :
         {camera + "fov = 2\n", camera + "fov = 3.5\n", spot + "angle = 2.5\n", turned("1.5"), turned("0"),
          turned("2"), turned("0.5"), turned("22.5"), turned("6.02"), turned("6.2832")})
        EXPECT_TRUE(warned(table).empty()) << table;

    const Diagnostic one = warned(turned("1.5708")).at(0);
    EXPECT_EQ(one.message, "\"angle\" 1.5708 looks like radians");
    EXPECT_EQ(one.hint, "angles are in degrees; 1.5708 radians are 90°");
    EXPECT_EQ(one.location.line, 6);
}

} // namespace
} // namespace glint::test
