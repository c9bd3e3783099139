// Loading, generating and framing models.

#include "model.h"

#include "glint/mesh_files.h"
#include "math/bounds.h"
#include "request.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace glint::bench {
namespace {

/// Contents of a .cam file: lines of a keyword and its numbers.
struct CameraFile {
    vec3 eye{0.0f};
    vec3 target{0.0f};
    vec3 up{0.0f, 1.0f, 0.0f};
    float fov = 45.0f; ///< degrees, vertical
};

CameraFile read_camera(const std::string& path) {
    CameraFile camera;
    std::ifstream in(path);
    std::string word;
    while (in >> word) {
        if (word == "fov") {
            in >> camera.fov;
            continue;
        }
        vec3* vector = word == "eye"      ? &camera.eye
                       : word == "target" ? &camera.target
                       : word == "up"     ? &camera.up
                                          : nullptr;
        if (vector == nullptr || !(in >> vector->x >> vector->y >> vector->z))
            throw Error(ErrorKind::input, path + ": '" + word + "' is not understood",
                        "expected eye X Y Z, target X Y Z, up X Y Z, fov DEGREES");
    }
    return camera;
}

Camera looking(const vec3& eye, const vec3& forward, const vec3& up, float fov) {
    Camera camera;
    camera.eye = eye;
    camera.forward = glm::normalize(forward);
    camera.right = glm::normalize(glm::cross(camera.forward, up));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.half = std::tan(fov * 3.14159265f / 360.0f);
    return camera;
}

/// A camera from above and in front, as close as possible with the whole mesh in view.
Camera framing(const Mesh& mesh, const Bounds& bounds) {
    const vec3 extent = bounds.extent();
    // Flat models such as landscapes have z up; scans have y up.
    const bool flat = extent.z < 0.5f * std::min(extent.x, extent.y);
    const vec3 back = glm::normalize(flat ? vec3(0.5f, -0.9f, 0.45f) : vec3(0.5f, 0.4f, 1.0f));
    const vec3 center = (bounds.lo + bounds.hi) * 0.5f;
    Camera camera = looking(center, -back, flat ? vec3(0, 0, 1) : vec3(0, 1, 0), 40.0f);
    float distance = 0.0f;
    for (const vec3& p : mesh.positions) {
        const vec3 q = p - center;
        const float aside = std::max(std::abs(glm::dot(q, camera.right)), std::abs(glm::dot(q, camera.up)));
        distance = std::max(distance, aside / camera.half + glm::dot(q, back));
    }
    camera.eye = center + back * (1.02f * distance);
    return camera;
}

Model model_of(std::string name, std::string file, std::shared_ptr<const Mesh> mesh) {
    Bounds bounds;
    for (const vec3& p : mesh->positions) bounds.grow(p);
    if (mesh->triangles.empty()) throw Error(ErrorKind::input, file + ": there are no triangles");
    Model model{std::move(name), std::move(file), std::move(mesh), {}, {}, glm::length(bounds.extent())};
    model.camera = framing(*model.mesh, bounds);
    model.light = bounds.hi + bounds.extent() * 0.5f;
    return model;
}

meshgen::Request request_for(const std::string& name) {
    meshgen::Request request;
    request.flat = true;
    if (name == "terrain") {
        request.kind = meshgen::Kind::terrain;
        request.triangles = 1e6;
    } else if (name == "knot") {
        request.kind = meshgen::Kind::knot;
        request.triangles = 70e3;
    } else {
        request.kind = meshgen::Kind::gyroid;
        request.triangles = 300e3;
    }
    return request;
}

} // namespace

Model load_model(const std::string& file) {
    const std::filesystem::path path(file);
    Model model = model_of(path.stem().string(), file, load_mesh(file).mesh);
    const std::string beside = std::filesystem::path(path).replace_extension(".cam").string();
    if (std::filesystem::exists(beside)) {
        const CameraFile camera = read_camera(beside);
        model.camera = looking(camera.eye, camera.target - camera.eye, camera.up, camera.fov);
    }
    return model;
}

Model generate_model(const std::string& name, const std::string& folder) {
    auto mesh = std::make_shared<Mesh>(meshgen::make_mesh(request_for(name)));
    const std::string file = (std::filesystem::path(folder) / (name + ".ply")).string();
    write_ply(file, *mesh);
    return model_of(name, file, mesh);
}

} // namespace glint::bench
