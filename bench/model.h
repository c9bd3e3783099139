#pragma once
// What the rays are shot at: a mesh and the camera in front of it.

#include "glint/scene.h"
#include "math/vec.h"

#include <memory>
#include <string>

namespace glint::bench {

/// A pinhole over a square picture.
struct Camera {
    vec3 eye{0.0f};
    vec3 forward{0.0f, 0.0f, -1.0f}; ///< unit, as are right and up
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

/// Reads a PLY file and the .cam file beside it, if there is one; else frames the mesh. Throws Error(input).
Model load_model(const std::string& file);

/// Makes one of `generated_names` and writes it into `folder` as PLY, for processes of their own to read.
Model generate_model(const std::string& name, const std::string& folder);

/// What is measured where no file is named.
inline constexpr const char* generated_names[] = {"knot", "gyroid", "terrain"};

} // namespace glint::bench
