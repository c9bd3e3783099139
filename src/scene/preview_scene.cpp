// The preview scene of a bare mesh: floor, lights and camera.

#include "glint/scene.h"
#include "scene/framing.h"
#include "scene/support.h"

#include <algorithm>
#include <cmath>

namespace glint {

using scene::support;

namespace {

// The exact rotation that takes `up` to +z.
Mat4 upright(Axis up) {
    switch (up) {
    case Axis::x:
        return Mat4(0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1);
    case Axis::y:
        return Mat4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
    case Axis::minus_x:
        return Mat4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1);
    case Axis::minus_y:
        return Mat4(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
    case Axis::minus_z:
        return Mat4(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
    case Axis::z:
        break;
    }
    return Mat4(1.0);
}

// Bounding box of the mesh and half its diagonal, the unit of the preview scene.
struct Extent {
    dvec3 lo{0};
    dvec3 hi{0};
    double radius = 1;

    dvec3 middle() const { return (lo + hi) / 2.0; }
};

Extent extent_of(const SceneDescription& scene) {
    Extent e;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 d(0);
        d[axis] = 1;
        e.hi[axis] = support(scene, d).value();
        e.lo[axis] = -support(scene, -d).value();
    }
    e.radius = glm::length(e.hi - e.lo) / 2;

    // A single point has no extent: use one that its coordinates can resolve.
    if (e.radius == 0) e.radius = std::max(1.0, glm::length(e.middle()) / 1024);
    return e;
}

void add_materials(SceneDescription& scene, const Mesh& mesh) {
    Material clay;
    clay.name = "clay";
    clay.color = mesh.colors.empty() ? Vec3(0.66, 0.29, 0.15) : Vec3(1);
    clay.ambient = 1;
    clay.diffuse = 0.95;
    clay.highlight = 0.12;
    clay.shininess = 40;

    Material floor;
    floor.name = "floor";
    floor.color = Vec3(0.62, 0.63, 0.65);
    floor.diffuse = 0.9;
    floor.reflectivity = 0.08;
    scene.materials = {clay, floor};
}

void add_floor(SceneDescription& scene, const Extent& extent) {
    // Slightly below the lowest point, so that a flat mesh does not coincide with the floor.
    PlaneShape plane;
    plane.offset = extent.lo.z - extent.radius * 1e-4;
    Object floor;
    floor.name = "floor";
    floor.shape = plane;
    floor.material = "floor";
    scene.objects.push_back(floor);
}

// A point light in the given direction that produces `brightness` on a white surface facing it at the centre.
Light preview_light(const Extent& extent, const dvec3& direction, const Vec3& color, double brightness) {
    const double distance = extent.radius * 5;
    PointLight light;
    light.position = extent.middle() + glm::normalize(direction) * distance;
    light.color = color;
    light.intensity = brightness * distance * distance;
    return {light, {}};
}

void add_lights(SceneDescription& scene, const Extent& extent, const scene::ViewAxes& view) {
    // A warm key light over the camera's left shoulder and a weaker, cool light from the right.
    const dvec3 up(0, 0, 1);
    const dvec3 back = glm::normalize(-dvec3(view.forward.x, view.forward.y, 0));
    scene.lights.push_back({AmbientLight{Vec3(0.13, 0.14, 0.16)}, {}});
    scene.lights.push_back(
        preview_light(extent, back * 0.7 - view.right * 0.9 + up * 1.3, Vec3(1, 0.96, 0.9), 0.95));
    scene.lights.push_back(
        preview_light(extent, back * 0.6 + view.right * 1.2 + up * 0.9, Vec3(0.85, 0.92, 1), 0.35));
}

Object preview_mesh(std::shared_ptr<const Mesh> mesh, const std::string& file, Axis up) {
    MeshShape shape;
    shape.file = file;
    shape.data = std::move(mesh);
    Object object;
    object.name = "mesh";
    object.shape = shape;
    object.material = "clay";
    object.transform = upright(up);
    return object;
}

} // namespace

SceneDescription preview_scene(std::shared_ptr<const Mesh> mesh, const std::string& file, Axis up,
                               bool floor) {
    return preview_scene(preview_mesh(std::move(mesh), file, up), floor);
}

SceneDescription preview_scene(Object mesh, bool floor) {
    const auto& shape = std::get<MeshShape>(mesh.shape);
    if (!shape.data || !support(*shape.data, dvec3(0, 0, 1))) {
        throw Error(ErrorKind::input, "the mesh has nothing to show: no vertex that is finite and used",
                    "give a mesh with faces or points", {shape.file, 0, 0, {}});
    }
    SceneDescription scene;
    add_materials(scene, *shape.data);
    scene.objects.push_back(std::move(mesh));
    const Extent extent = extent_of(scene);

    // Looking down by more than half the field of view keeps the horizon above the picture.
    scene.framing.fov = 30;
    scene.framing.fill = 0.78;

    if (floor) add_floor(scene, extent);
    add_lights(scene, extent, scene::three_quarter_view());
    scene.render.background = Vec3(0.35, 0.37, 0.4);
    return scene;
}

} // namespace glint
