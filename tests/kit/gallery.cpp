#include "gallery.h"

#include "scene_kit.h"

#include "math/trig.h"

namespace glint::kit {
namespace {

// Numbers without meaning, so that no edge, tie or tangent comes about by chance.
SceneDescription studio() {
    SceneDescription scene = empty_scene(Vec3(4.13, -6.57, 3.71), Vec3(-0.531, 0.847, -0.449), 0, 33);
    scene.render.width = 44;
    scene.render.height = 36;
    scene.whitted.max_depth = 5;
    add_light(scene, Vec3(3.1, -4.7, 6.3), 40, Vec3(1, 0.9, 0.8));
    add_ambient(scene, Vec3(0.11, 0.12, 0.13));
    return scene;
}

Material paint(const Vec3& color) {
    Material m;
    m.color = color;
    return m;
}

Material shiny(const Vec3& color, double highlight, double shininess, double reflectivity) {
    Material m = paint(color);
    m.highlight = highlight;
    m.shininess = shininess;
    m.reflectivity = reflectivity;
    return m;
}

Material tinted_glass(double index, const Vec3& absorption, bool fresnel) {
    Material m = shiny(Vec3(0.1, 0.2, 0.3), 0.5, 40, 0.1);
    m.transparency = 0.85;
    m.index = index;
    m.absorption = absorption;
    m.fresnel = fresnel;
    return m;
}

void add_floor(SceneDescription& scene, const Material& material) {
    add(scene, PlaneShape{Vec3(0, 0, 1), -1.07}, material);
}

void add_solids(SceneDescription& scene, const Material& material) {
    add(scene, SphereShape{Vec3(-1.3, 0.4, 0.1), 1.03}, material);
    add(scene, CylinderShape{Vec3(1.21, 0.3, -0.93), Vec3(0.2, -0.1, 1), 1.6, 0.57}, material);
    PolyhedronShape box{PolyhedronKind::box, Vec3(0.13, -1.7, -0.41), Vec3(0.9, 0.7, 1.1)};
    add(scene, box, material).transform = rotation(5);
    PolyhedronShape gem{PolyhedronKind::dodecahedron};
    gem.center = Vec3(2.6, -1.1, -0.31);
    gem.radius = 0.6;
    add(scene, gem, material);
}

void add_remaining_polyhedra(SceneDescription& scene, const Material& material) {
    using Kind = PolyhedronKind;
    double x = -2.9;
    for (Kind kind : {Kind::tetrahedron, Kind::octahedron, Kind::icosahedron, Kind::prism, Kind::pyramid}) {
        PolyhedronShape shape{kind};
        shape.center = Vec3(x, 2.2 + 0.1 * x, 0.03);
        shape.radius = 0.55;
        shape.height = 0.9;
        shape.axis = Vec3(0.3, 0.1, 1);
        add(scene, shape, material);
        x += 1.31;
    }
}

SceneDescription matte_solids() {
    SceneDescription scene = studio();
    add_floor(scene, paint(Vec3(0.7, 0.8, 0.6)));
    add_solids(scene, paint(Vec3(0.8, 0.4, 0.2)));
    add_remaining_polyhedra(scene, paint(Vec3(0.2, 0.5, 0.9)));
    add(scene, TriangleShape{{Vec3(-2.1, -1.3, 0.2), Vec3(-0.9, -2.1, 0.1), Vec3(-1.6, -1.2, 1.4)}},
        paint(Vec3(0.9, 0.9, 0.1)));
    return scene;
}

SceneDescription highlights(HighlightModel model, bool clamp) {
    SceneDescription scene = studio();
    scene.whitted.highlight_model = model;
    scene.whitted.clamp = clamp;
    add_floor(scene, shiny(Vec3(0.3, 0.5, 0.8), 0.8, 12, 0));
    add_solids(scene, shiny(Vec3(0.9, 0.5, 0.3), 1.5, 35, 0));
    return scene;
}

SceneDescription mirrors() {
    SceneDescription scene = studio();
    add_floor(scene, shiny(Vec3(0.5, 0.6, 0.7), 0, 32, 0.4));
    add_solids(scene, shiny(Vec3(0.4, 0.2, 0.1), 0.7, 60, 0.6));
    add(scene, PlaneShape{Vec3(-0.3, -1, 0.1), -4.3}, mirror(0.9));
    return scene;
}

SceneDescription colored_glass(bool fresnel) {
    SceneDescription scene = studio();
    add_floor(scene, paint(Vec3(0.8, 0.7, 0.5)));
    add_solids(scene, tinted_glass(1.5, Vec3(0.3, 0.1, 0.7), fresnel));
    add_light(scene, Vec3(-4.4, -2.1, 5.3), 25);
    return scene;
}

SceneDescription panes() {
    SceneDescription scene = studio();
    scene.render.background = Vec3(0.2, 0.3, 0.5);
    add_floor(scene, paint(Vec3(0.8)));
    Material pane = tinted_glass(1.4, Vec3(1), true);
    add(scene, TriangleShape{{Vec3(-1.9, -2.2, -0.8), Vec3(2.3, -1.6, -0.9), Vec3(0.4, -1.1, 2.1)}}, pane);
    pane.transparency = 0.5;
    add(scene, PlaneShape{Vec3(0.1, 1, 0.2), 1.9}, pane);
    Mesh open = box_mesh(Vec3(-0.4, 0.2, -0.2), Vec3(1.3, 0.8, 1.1));
    open.triangles.resize(8);
    add(scene, mesh_of(open), pane).transform = rotation(2);
    add(scene, SphereShape{Vec3(0.3, 3.4, 0.3), 0.8}, paint(Vec3(0.9, 0.2, 0.1)));
    return scene;
}

SceneDescription spots() {
    SceneDescription scene = studio();
    scene.lights.clear();
    SpotLight spot;
    spot.position = Vec3(2.1, -3.3, 4.2);
    spot.direction = Vec3(-0.41, 0.57, -0.87);
    spot.angle = 23;
    spot.blend = 0.6;
    spot.intensity = 30;
    scene.lights.push_back({spot, {}});
    spot.position = Vec3(-3.3, -1.2, 3.7);
    spot.direction = Vec3(0.62, 0.21, -0.8);
    spot.blend = 0;
    spot.color = Vec3(0.3, 0.9, 0.5);
    scene.lights.push_back({spot, {}});
    add_floor(scene, paint(Vec3(0.8)));
    add_solids(scene, shiny(Vec3(0.7), 0.4, 20, 0.1));
    return scene;
}

SceneDescription sunlight() {
    SceneDescription scene = studio();
    scene.lights.clear();
    DirectionalLight sun;
    sun.direction = Vec3(-0.37, 0.61, -1.13);
    sun.irradiance = 0.8;
    scene.lights.push_back({sun, {}});
    scene.render.background = Vec3(0.3, 0.5, 0.9);
    add_floor(scene, paint(Vec3(0.5, 0.6, 0.3)));
    add_solids(scene, tinted_glass(1.33, Vec3(0.2), false));
    add(scene, SphereShape{Vec3(-2.2, -2.6, -0.4), 0.4}, lamp(Vec3(2, 1, 0.5)));
    return scene;
}

SceneDescription smooth_meshes() {
    SceneDescription scene = studio();
    add_floor(scene, paint(Vec3(0.6)));
    Mesh ball = sphere_mesh(0.9, 7);
    for (const glm::vec3& n : ball.normals) ball.colors.push_back(n * 0.4f + 0.5f);
    add(scene, mesh_of(ball), shiny(Vec3(1), 0.5, 30, 0.2)).transform = rotation(3);
    MeshShape faceted = mesh_of(box_mesh(Vec3(1.7, -0.6, 0.1), Vec3(0.9)));
    faceted.normals = NormalsMode::smooth;
    add(scene, faceted, shiny(Vec3(0.3, 0.7, 0.9), 0.8, 15, 0.3));
    ball.colors.clear();
    MeshShape lens = mesh_of(ball);
    lens.scale = Vec3(0.9, 0.9, -0.5);
    Object& glass_lens = add(scene, lens, tinted_glass(1.45, Vec3(0.1, 0.4, 0.2), true));
    glass_lens.transform[3] = {-1.8, -1.6, 0.2, 1};
    return scene;
}

SceneDescription instances() {
    SceneDescription scene = studio();
    add_floor(scene, paint(Vec3(0.6, 0.7, 0.9)));
    MeshShape ball = mesh_of(sphere_mesh(0.5, 6));
    ball.scale = Vec3(1, 1.5, 0.7);
    Object& original = add(scene, ball, shiny(Vec3(0.9, 0.3, 0.2), 0.4, 25, 0.2));
    original.name = "ball";
    for (unsigned i = 0; i < 4; ++i) {
        Object& copy = add(scene, InstanceShape{"ball"}, std::string());
        copy.transform = rotation(7 + i);
        copy.transform[3] = {-2.0 + 1.17 * i, -1.3 + 0.4 * i, 0.1 * i, 1};
        if (i == 2) copy.material = scene.materials[0].name;
    }
    return scene;
}

SceneDescription stretched() {
    SceneDescription scene = studio();
    add_floor(scene, paint(Vec3(0.7)));
    Mat4 shear = rotation(4);
    shear[0] *= 1.7;
    shear[2] += shear[1] * 0.4;
    add(scene, SphereShape{Vec3(0.1, 0.2, 0.1), 0.8}, tinted_glass(1.3, Vec3(0.4, 0.2, 0.1), true))
        .transform = shear;
    shear[3] = {2.1, -1.2, 0.3, 1};
    add(scene, CylinderShape{Vec3(0.1), Vec3(0.3, 0.2, 1), 0.9, 0.4}, shiny(Vec3(0.9, 0.8, 0.2), 1, 50, 0.2))
        .transform = shear;
    shear[3] = {-2.3, -0.7, 0.2, 1};
    add(scene, PolyhedronShape{PolyhedronKind::box}, tinted_glass(1.6, Vec3(0.1), false)).transform = shear;
    return scene;
}

SceneDescription nested() {
    SceneDescription scene = studio();
    scene.whitted.max_depth = 7;
    add_floor(scene, paint(Vec3(0.8, 0.6, 0.4)));
    add(scene, SphereShape{Vec3(-0.9, 0.1, 0.2), 1.1}, tinted_glass(1.5, Vec3(0.2, 0.1, 0.4), true))
        .priority = 2;
    add(scene, SphereShape{Vec3(0.3, -0.3, 0.1), 1.0}, tinted_glass(1.2, Vec3(0.4, 0.3, 0.1), false));
    add(scene, CylinderShape{Vec3(1.1, -0.9, -0.8), Vec3(0.1, 0, 1), 1.5, 0.6},
        tinted_glass(1.33, Vec3(0.1, 0.5, 0.3), false))
        .priority = 1;
    add(scene, SphereShape{Vec3(-0.8, 0.2, 0.3), 0.3}, paint(Vec3(1, 0.2, 0.2))).priority = 3;
    add(scene, PlaneShape{Vec3(0.1, 0.2, 1), -0.53, true}, tinted_glass(1.1, Vec3(0.05), false));
    return scene;
}

SceneDescription inside_glass() {
    SceneDescription scene = studio();
    scene.whitted.index = 1.1;
    add_floor(scene, paint(Vec3(0.8, 0.6, 0.4)));
    add(scene, SphereShape{Vec3(4.2, -6.4, 3.6), 1.3}, tinted_glass(1.4, Vec3(0.1, 0.2, 0.1), true));
    add(scene, SphereShape{Vec3(0.2, 0.1, 0.3), 1.2}, shiny(Vec3(0.2, 0.4, 0.8), 0.6, 30, 0.3));
    return scene;
}

SceneDescription balanced() {
    SceneDescription scene = studio();
    scene.whitted.energy = Energy::balanced;
    scene.whitted.shadows = Shadows::opaque;
    add_floor(scene, shiny(Vec3(0.8, 0.7, 0.6), 0.2, 10, 0.3));
    add_solids(scene, tinted_glass(1.2, Vec3(0.1), true));
    return scene;
}

/// On a slab a thousand times as wide as what stands there.
SceneDescription wide_ground() {
    SceneDescription scene = studio();
    add(scene, PolyhedronShape{PolyhedronKind::box, Vec3(3, 4, -2.07), Vec3(2000, 2000, 2)},
        shiny(Vec3(0.8, 0.7, 0.6), 0.2, 10, 0.3));
    add_solids(scene, tinted_glass(1.3, Vec3(0.2, 0.1, 0.4), true));
    return scene;
}

SceneDescription points() {
    SceneDescription scene = studio();
    Mesh cloud = sphere_mesh(1.2, 6);
    cloud.triangles.clear();
    // Each pole is stored twelve times: once is enough.
    for (auto* values : {&cloud.positions, &cloud.normals}) {
        values->erase(values->begin(), values->begin() + 11);
        values->resize(values->size() - 11);
    }
    for (const glm::vec3& n : cloud.normals) cloud.colors.push_back(n * 0.5f + 0.5f);
    MeshShape shape = mesh_of(cloud);
    shape.point_radius = 0.12;
    add(scene, shape, shiny(Vec3(1), 0.3, 20, 0.1)).transform = rotation(9);
    add_floor(scene, paint(Vec3(0.5)));
    return scene;
}

/// Materials that Whitted's model reads in its own way, with what it tints: mirrors, highlights, refracted
/// rays and the shadows of glass.
SceneDescription models() {
    SceneDescription scene = studio();
    scene.render.background = Vec3(0.3, 0.4, 0.5);
    add_floor(scene, modelled(MaterialModel::diffuse, Vec3(0.7, 0.8, 0.6), 0));
    add_solids(scene, modelled(MaterialModel::dielectric, Vec3(0.9, 0.6, 0.3), 0));
    Material gold = modelled(MaterialModel::conductor, Vec3(1), 0);
    gold.metal = Metal::gold;
    add(scene, SphereShape{Vec3(1.9, 2.2, 0.3), 0.9}, gold);
    gold.roughness = 0.3;
    add(scene, SphereShape{Vec3(-2.6, -0.9, -0.4), 0.6}, gold);
    add(scene, SphereShape{Vec3(0.4, 1.9, 0.2), 0.5},
        modelled(MaterialModel::plastic, Vec3(0.2, 0.3, 0.8), 0.2));
    Material part = modelled(MaterialModel::principled, Vec3(0.8, 0.3, 0.2), 0.4);
    part.metallic = 0.3;
    part.transmission = 0.5;
    add(scene, SphereShape{Vec3(-1.1, -1.9, -0.5), 0.5}, part);
    add(scene, RectangleShape{Vec3(1.2, -2.4, -0.9), Vec3(0.9, 0.3, 0), Vec3(0, 0.1, 1.3)},
        modelled(MaterialModel::dielectric, Vec3(0.3, 0.9, 0.4), 0));
    return scene;
}

} // namespace

std::vector<Exhibit> gallery() {
    return {{"matte_solids", matte_solids()},
            {"highlights", highlights(HighlightModel::blinn, false)},
            {"phong_clamped", highlights(HighlightModel::phong, true)},
            {"mirrors", mirrors()},
            {"colored_glass", colored_glass(false)},
            {"fresnel_glass", colored_glass(true)},
            {"panes", panes()},
            {"spots", spots()},
            {"sunlight", sunlight()},
            {"smooth_meshes", smooth_meshes()},
            {"instances", instances()},
            {"stretched", stretched()},
            {"nested", nested()},
            {"inside_glass", inside_glass()},
            {"balanced", balanced()},
            {"models", models()},
            {"wide_ground", wide_ground()},
            {"points", points()}};
}

} // namespace glint::kit
