#include "closed_solids.h"

#include "scene_kit.h"

namespace glint::kit {
namespace {

struct Solid {
    std::string name;
    Shape shape; ///< the origin is inside
    Mat4 transform = rotation(11);
};

Shape standing(PolyhedronKind kind, int sides, double height) {
    PolyhedronShape shape{kind, Vec3(0, 0, -0.2 * height)};
    shape.sides = sides;
    shape.height = height;
    return shape;
}

std::vector<Solid> closed_solids() {
    using Kind = PolyhedronKind;
    Mat4 skewed = rotation(3);
    skewed[0] *= -1.7;
    skewed[2] += skewed[1] * 0.4;
    const auto sphere = [](Vec3 scale, NormalsMode normals) {
        MeshShape mesh = mesh_of(sphere_mesh(1, 7));
        mesh.scale = scale;
        mesh.normals = normals;
        return mesh;
    };
    return {{"box", PolyhedronShape{Kind::box, Vec3(0.1, 0.2, 0.05), Vec3(1.1, 1.3, 0.9)}},
            {"tetrahedron", PolyhedronShape{Kind::tetrahedron}},
            {"octahedron", PolyhedronShape{Kind::octahedron}},
            {"dodecahedron", PolyhedronShape{Kind::dodecahedron}},
            {"icosahedron", PolyhedronShape{Kind::icosahedron}},
            {"prism", standing(Kind::prism, 5, 0.7)},
            {"pyramid", standing(Kind::pyramid, 4, 1.3)},
            {"flat_pyramid", standing(Kind::pyramid, 6, 0.1)},
            {"wide_box", PolyhedronShape{Kind::box, Vec3(-499'999, 3, 499'999), Vec3(1e6)}},
            {"sphere", SphereShape{Vec3(0.1, 0.2, 0.1), 1}},
            {"cylinder", CylinderShape{Vec3(0, 0, -0.5), Vec3(0, 0, 1), 1.2, 0.7}},
            {"cone", ConeShape{Vec3(0, 0, -0.3), Vec3(0, 0, 1), 1.4, 0.8}},
            {"flat_cone", ConeShape{Vec3(0, 0, -0.05), Vec3(0, 0, 1), 0.15, 0.9}},
            {"faceted_mesh", sphere(Vec3(1), NormalsMode::flat)},
            {"smooth_mesh", sphere(Vec3(1), NormalsMode::smooth)},
            {"lens", sphere(Vec3(1, 1, 0.06), NormalsMode::flat)},
            {"skewed_box", PolyhedronShape{Kind::box, Vec3(0.1), Vec3(1)}, skewed},
            {"skewed_cylinder", CylinderShape{Vec3(0, 0, -0.5), Vec3(0, 0, 1), 1.2, 0.7}, skewed},
            {"skewed_mesh", sphere(Vec3(1, 0.6, 0.8), NormalsMode::flat), skewed}};
}

/// Meshes also as instances, and a small ball in a box that is so wide for it.
std::vector<Exhibit> scenes_of_solids(const Vec3& eye, const Vec3& direction, double fov,
                                      const Material& material) {
    std::vector<Exhibit> scenes;
    for (const Solid& solid : closed_solids()) {
        SceneDescription scene = empty_scene(eye, direction, 0, fov);
        scene.render.width = 64;
        scene.render.height = 48;
        scene.render.background = Vec3(1);
        scene.whitted.max_depth = 8;
        add(scene, solid.shape, material).transform = solid.transform;
        if (solid.name == "wide_box") add(scene, SphereShape{Vec3(0.2, 0.3, -0.1), 0.05}, material);
        scenes.push_back({solid.name, scene});
        if (!std::holds_alternative<MeshShape>(solid.shape)) continue;
        scene.objects[0].name = "mesh";
        scene.objects[0].visible = false;
        add(scene, InstanceShape{"mesh"}, std::string()).transform = solid.transform;
        scenes.push_back({solid.name + "_placed", scene});
    }
    return scenes;
}

} // namespace

std::vector<Exhibit> mirror_rooms() {
    return scenes_of_solids(Vec3(0.011, -0.007, 0.003), Vec3(0.31, 0.83, -0.22), 120, mirror());
}

std::vector<Exhibit> invisible_solids() {
    return scenes_of_solids(Vec3(1.31, -3.83, 2.22), Vec3(-1.31, 3.83, -2.22), 33, glass(1));
}

} // namespace glint::kit
