#pragma once
// What tests build small scenes with: one line a thing, and single rays with their trees.

#include "glint/render.h"
#include "glint/scene.h"
#include "render/estimators/estimator.h"

#include <memory>
#include <string>
#include <vector>

namespace glint::kit {

inline constexpr double pi = 3.14159265358979323846;

/// A scene without anything in it: black background, one sample a pixel, square picture of `size` pixels,
/// seen from `eye` along `direction`.
SceneDescription empty_scene(const Vec3& eye = Vec3(0), const Vec3& direction = Vec3(0, 1, 0), int size = 16,
                             double fov = 45);

/// An empty scene within a sky that shines alike from everywhere.
SceneDescription in_sky(const Vec3& background = Vec3(1));

/// Materials that do one thing only: no ambient, no highlight, and c · k_d = `diffuse`.
Material matte(double diffuse = 1);
Material black();                                      ///< does nothing
Material mirror(double reflectivity = 1);              ///< black, but for ρ
Material glass(double index, double transparency = 1); ///< black, but for τ
Material lamp(const Vec3& emission);                   ///< black, but for its own light
/// A material of a model, but for color and roughness as by default.
Material modelled(MaterialModel model, const Vec3& color = Vec3(1), double roughness = 0);

/// Adds a shape with a material of its own; the object may be changed until the next call.
Object& add(SceneDescription& scene, Shape shape, const Material& material);
/// Adds a shape of a material that is in the scene.
Object& add(SceneDescription& scene, Shape shape, const std::string& material);
void add_light(SceneDescription& scene, const Vec3& position, double intensity = 1,
               const Vec3& color = Vec3(1));
void add_ambient(SceneDescription& scene, const Vec3& color);
/// The material of an object of the scene.
Material& material_of_object(SceneDescription& scene, std::size_t object);

/// The scene with everything in it moved.
SceneDescription moved(SceneDescription scene, const Vec3& by);

MeshShape mesh_of(Mesh mesh);
/// A sphere about the origin as a closed mesh: `rings` · 2 · `rings` quads cut in two, outward, with vertex
/// normals.
Mesh sphere_mesh(double radius, unsigned rings);
/// A closed box as a mesh with shared corners, outward.
Mesh box_mesh(const Vec3& center, const Vec3& size);

/// A rotation drawn by number, of any axis and angle.
Mat4 rotation(unsigned number);

/// A camera sample of a ray alone.
rendering::CameraSample camera_ray(const vec3& origin, const vec3& direction);

/// One ray with all that it met. The camera is put at its origin, so that media around it are found.
struct Look {
    Scene scene;
    rendering::Terms terms;
    rendering::RayTree tree;
    vec3 light{0.0f}; ///< sum of the terms
    rendering::RayCounts counts;

    const rendering::RayNode& node(std::size_t i) const { return tree.nodes.at(i); }
};
Look look(SceneDescription scene, const Vec3& eye, const Vec3& direction);

/// Renders on one thread.
Picture rendered(const SceneDescription& scene, RenderOptions options = {});

/// The angle between two vectors, radians, exact for small ones too.
double angle_between(const vec3& a, const vec3& b);

} // namespace glint::kit
