#pragma once
// A test model: a mesh and a camera in front of it.

#include "glint/scene.h"
#include "math/vec.h"

#include <memory>
#include <string>

namespace glint::bench {

/// A pinhole camera with a square picture.
struct Camera {
    vec3 eye{0.0f};
    vec3 forward{0.0f, 0.0f, -1.0f}; ///< unit vectors
    vec3 right{1.0f, 0.0f, 0.0f};
    vec3 up{0.0f, 1.0f, 0.0f};
    float half = 1.0f; ///< tangent of half the field of view
};

struct Model {
    std::string name;
    std::string file;
    std::shared_ptr<const Mesh> mesh;
    Camera camera;
    vec3 light{0.0f};      ///< a point light
    float diagonal = 0.0f; ///< of the bounding box
};

/// Reads a PLY file and the .cam file beside it, if any; otherwise frames the mesh. Throws Error(input).
Model load_model(const std::string& file);

/// Generates one of `generated_names` and writes it into `folder` as PLY, for child processes to read.
Model generate_model(const std::string& name, const std::string& folder);

/// Models measured if no file is given.
inline constexpr const char* generated_names[] = {"knot", "gyroid", "terrain"};

} // namespace glint::bench
