#include "scene_kit.h"

#include "geometry/polyhedron.h"

#include <cmath>

namespace glint::kit {

SceneDescription empty_scene(const Vec3& eye, const Vec3& direction, int size, double fov) {
    SceneDescription scene;
    CameraDescription camera;
    camera.eye = eye;
    camera.direction = direction;
    const Vec3 side = glm::cross(direction, camera.up);
    if (glm::dot(side, side) < 1e-12 * glm::dot(direction, direction)) camera.up = Vec3(0, 1, 0);
    camera.fov = fov;
    scene.camera = camera;
    scene.render.width = size;
    scene.render.height = size;
    scene.render.spp = 1;
    return scene;
}

SceneDescription in_sky(const Vec3& background) {
    SceneDescription scene = empty_scene();
    scene.render.background = background;
    return scene;
}

Material black() {
    Material m;
    m.color = Vec3(0);
    m.ambient = 0;
    m.diffuse = 0;
    return m;
}

Material matte(double diffuse) {
    Material m = black();
    m.color = Vec3(1);
    m.diffuse = diffuse;
    return m;
}

Material mirror(double reflectivity) {
    Material m = black();
    m.reflectivity = reflectivity;
    return m;
}

Material modelled(MaterialModel model, const Vec3& color, double roughness) {
    Material m;
    m.model = model;
    m.color = color;
    m.roughness = roughness;
    return m;
}

Material glass(double index, double transparency) {
    Material m = black();
    m.transparency = transparency;
    m.index = index;
    return m;
}

Material lamp(const Vec3& emission) {
    Material m = black();
    m.emission = emission;
    return m;
}

Object& add(SceneDescription& scene, Shape shape, const std::string& material) {
    Object object;
    object.shape = std::move(shape);
    object.material = material;
    scene.objects.push_back(std::move(object));
    return scene.objects.back();
}

Object& add(SceneDescription& scene, Shape shape, const Material& material) {
    scene.materials.push_back(material);
    Material& m = scene.materials.back();
    if (m.name.empty()) m.name = "material " + std::to_string(scene.materials.size());
    return add(scene, std::move(shape), m.name);
}

void add_light(SceneDescription& scene, const Vec3& position, double intensity, const Vec3& color) {
    PointLight light;
    light.position = position;
    light.intensity = intensity;
    light.color = color;
    scene.lights.push_back({light, {}});
}

void add_ambient(SceneDescription& scene, const Vec3& color) {
    scene.lights.push_back({AmbientLight{color}, {}});
}

Material& material_of_object(SceneDescription& scene, std::size_t object) {
    for (Material& m : scene.materials)
        if (m.name == scene.objects.at(object).material) return m;
    throw Error(ErrorKind::internal, "the object has no material");
}

SceneDescription moved(SceneDescription scene, const Vec3& by) {
    for (Object& object : scene.objects) {
        // An instance is transformed after its mesh, which is moved already.
        const bool instance = std::holds_alternative<InstanceShape>(object.shape);
        const Vec3 already = instance ? glm::dmat3(object.transform) * by : Vec3(0);
        object.transform[3] += glm::dvec4(by - already, 0);
    }
    for (Light& light : scene.lights) {
        if (auto* point = std::get_if<PointLight>(&light.kind)) point->position += by;
        if (auto* spot = std::get_if<SpotLight>(&light.kind)) spot->position += by;
    }
    if (scene.camera) scene.camera->eye += by;
    return scene;
}

MeshShape mesh_of(Mesh mesh) {
    MeshShape shape;
    shape.data = std::make_shared<const Mesh>(std::move(mesh));
    return shape;
}

Mesh sphere_mesh(double radius, unsigned rings) {
    Mesh mesh;
    const unsigned around = 2 * rings;
    for (unsigned i = 0; i <= rings; ++i) {
        for (unsigned j = 0; j < around; ++j) {
            const double theta = pi * i / rings;
            const double phi = 2 * pi * j / around;
            // The poles are one point each, so that the mesh is closed.
            const double s = i == 0 || i == rings ? 0 : std::sin(theta);
            const Vec3 n(s * std::cos(phi), s * std::sin(phi), std::cos(theta));
            mesh.positions.emplace_back(n * radius);
            mesh.normals.emplace_back(n);
        }
    }
    for (unsigned i = 0; i < rings; ++i) {
        for (unsigned j = 0; j < around; ++j) {
            const unsigned a = i * around + j;
            const unsigned b = i * around + (j + 1) % around;
            if (i > 0) mesh.triangles.emplace_back(a, a + around, b);
            if (i + 1 < rings) mesh.triangles.emplace_back(b, a + around, b + around);
        }
    }
    return mesh;
}

Mesh box_mesh(const Vec3& center, const Vec3& size) {
    const geometry::Polyhedron box = geometry::make_box(center, size);
    Mesh mesh;
    for (const dvec3& p : box.positions) mesh.positions.emplace_back(p);
    mesh.triangles = box.triangles;
    return mesh;
}

Mat4 rotation(unsigned number) {
    // A quaternion from four numbers of no meaning; it need only be far from 0.
    const double k = number + 1.0;
    glm::dvec4 q(std::sin(1.1 * k), std::sin(2.3 * k + 1), std::sin(3.7 * k + 2), std::sin(5.1 * k + 3));
    q /= std::sqrt(glm::dot(q, q));
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    Mat4 m(1.0);
    m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0};
    m[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0};
    m[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0};
    return m;
}

rendering::CameraSample camera_ray(const vec3& origin, const vec3& direction) {
    rendering::CameraSample sample;
    sample.origin = origin;
    sample.direction = direction;
    return sample;
}

Look look(SceneDescription scene, const Vec3& eye, const Vec3& direction) {
    CameraDescription camera;
    camera.eye = eye;
    camera.direction = direction;
    camera.up = std::abs(direction.z) < 0.5 * glm::length(direction) ? Vec3(0, 0, 1) : Vec3(0.6, 0.8, 0);
    scene.camera = camera;
    BuildSceneOptions one_thread;
    one_thread.threads = 1;
    Look result{build_scene(scene, one_thread), {}, {}, vec3(0.0f), {}};
    rendering::Whitted tracer(result.scene.data());
    result.terms = tracer.trace(camera_ray(vec3(eye), vec3(glm::normalize(direction))), &result.tree).terms;
    result.light = result.terms.sum();
    result.counts = tracer.counts();
    return result;
}

Picture rendered(const SceneDescription& scene, RenderOptions options) {
    BuildSceneOptions one_thread;
    one_thread.threads = 1;
    if (options.threads == 0) options.threads = 1;
    return render(build_scene(scene, one_thread), options);
}

double angle_between(const vec3& a, const vec3& b) {
    const dvec3 u = glm::normalize(dvec3(a));
    const dvec3 v = glm::normalize(dvec3(b));
    const dvec3 c = glm::cross(u, v);
    return std::atan2(std::sqrt(glm::dot(c, c)), glm::dot(u, v));
}

} // namespace glint::kit
