// Scenes far from zero look like the same scenes near it, or warn.

#include "gallery.h"
#include "glint/explain.h"
#include "glint/explanation_files.h"
#include "glint/mesh_files.h"
#include "glint/pick.h"
#include "scene_kit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <functional>
#include <span>

namespace glint::kit {
namespace {

constexpr std::array offsets{1e3, 1e6, 1e9};

/// Off all axes, and not a multiple of any grid.
Vec3 place(double offset) { return offset * Vec3(1.25, -0.731, 0.317); }

/// The share of pixels that differ by more than 1/255.
double difference(const Image& a, const Image& b) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        float most = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            most = std::max(most, std::abs(std::min(a.pixels[k], 1.0f) - std::min(b.pixels[k], 1.0f)));
        differing += most > 1.0f / 255 ? 1 : 0;
    }
    return 3.0 * static_cast<double>(differing) / static_cast<double>(a.pixels.size());
}

std::vector<Diagnostic> of_precision(std::vector<Diagnostic> found) {
    std::erase_if(found, [](const Diagnostic& d) {
        return d.message.find("precision") == d.message.npos || d.message.find(" pixels") == d.message.npos;
    });
    return found;
}

class FarGallery : public testing::TestWithParam<Exhibit> {};

TEST_P(FarGallery, LooksAsNearZero) {
    SceneDescription near = GetParam().scene;
    near.render.width = near.render.height = 64;
    const Image expected = rendered(near).image;
    for (const double offset : offsets) {
        const SceneDescription far = moved(near, place(offset));
        EXPECT_TRUE(of_precision(warnings(build_scene(far))).empty()) << offset;
        EXPECT_LE(difference(rendered(far).image, expected), 0.002) << offset;
    }
}

INSTANTIATE_TEST_SUITE_P(All, FarGallery, testing::ValuesIn(gallery()),
                         [](const auto& param) { return param.param.name; });

TEST(FarScene, IsTheSameForAllKernels) {
    SceneDescription scene = empty_scene(Vec3(0, -6, 1));
    add(scene, mesh_of(sphere_mesh(1, 8)), matte());
    add(scene, SphereShape{Vec3(1.5, 0, 0), 0.5}, glass(1.5));
    add_light(scene, Vec3(-3, -5, 6), 40);
    scene = moved(scene, place(1e6));
    RenderOptions scalar;
    scalar.kernel.kernel = Kernel::scalar;
    EXPECT_EQ(rendered(scene).image.pixels, rendered(scene, scalar).image.pixels);
}

TEST(FarScene, IsReportedInItsOwnCoordinates) {
    const Vec3 there(500123.25, 5412345.5, 312.125);
    SceneDescription scene = empty_scene(there - Vec3(0, 10, 0), Vec3(0, 1, 0), 15);
    add(scene, SphereShape{there, 2}, matte());
    add_light(scene, there - Vec3(0, 20, 0), 100);
    const Scene built = build_scene(scene);
    EXPECT_EQ(built.camera().eye, scene.camera->eye);
    EXPECT_LT(glm::length(built.stats().bounds_min - (there - Vec3(2))), 1e-4);
    EXPECT_LT(glm::length(built.stats().bounds_max - (there + Vec3(2))), 1e-4);
    const auto picked = pick(built, 7.5, 7.5);
    ASSERT_TRUE(picked);
    EXPECT_LT(glm::length(picked->position - (there - Vec3(0, 2, 0))), 1e-6);
    const Explanation explanation = explain(built, 7, 7);
    const ExplainedRay& ray = explanation.samples[0].rays[0];
    EXPECT_LT(glm::length(explanation.origin + Vec3(ray.position) - picked->position), 1e-6);
    EXPECT_NE(explanation_text(explanation).find("positions are relative to (50012"), std::string::npos);

    // Other views and lights of it are what a new scene would be.
    CameraDescription camera = *scene.camera;
    camera.eye += Vec3(1, 0, 0.5);
    const Scene turned = with_view(built, camera, 20, 10);
    EXPECT_EQ(turned.description().camera->eye, camera.eye);
    scene.camera = camera;
    scene.render.width = 20;
    scene.render.height = 10;
    EXPECT_EQ(render(turned).image.pixels, render(build_scene(scene)).image.pixels);
    std::get<PointLight>(scene.lights[0].kind).position.x += 3;
    EXPECT_EQ(render(update_scene(built, scene)).image.pixels, render(build_scene(scene)).image.pixels);
}

TEST(FarScene, WarnsWhereItSpreadsTooFar) {
    SceneDescription scene = empty_scene(Vec3(0, -6, 0));
    add(scene, mesh_of(sphere_mesh(1, 8)), matte());
    add_light(scene, Vec3(0, -6, 3));
    scene = moved(scene, place(1e6));
    EXPECT_TRUE(of_precision(warnings(build_scene(scene))).empty());
    add(scene, SphereShape{}, matte());
    const auto found = of_precision(warnings(build_scene(scene)));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].message.find("moves mesh.0 by up to 0.15, about 0.48 pixels"), std::string::npos)
        << found[0].message;
}

// ── PLY files ──────────────────────────────────────────────────────────────────────────────────────────────

struct Coordinates {
    const char* name;
    const char* format;
    const char* type;
    bool exact; ///< all digits are in the file
};
void PrintTo(const Coordinates& coordinates, std::ostream* out) { *out << coordinates.name; }

std::string ply_file(const Mesh& mesh, const Vec3& by, const Coordinates& as) {
    std::string file = std::string("ply\nformat ") + as.format + " 1.0\nelement vertex " +
                       std::to_string(mesh.positions.size()) + "\n";
    for (const char* axis : {"x", "y", "z"}) file += std::string("property ") + as.type + " " + axis + "\n";
    file += "element face " + std::to_string(mesh.triangles.size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
    const bool text = std::string_view(as.format) == "ascii";
    const auto put = [&](auto value) {
        std::array<char, sizeof value> bytes = std::bit_cast<std::array<char, sizeof value>>(value);
        file.append(bytes.data(), bytes.size());
    };
    for (const glm::vec3& p : mesh.positions)
        for (int k = 0; k < 3; ++k) {
            const double value = by[k] + double(p[k]);
            char number[40];
            if (text)
                file.append(number, static_cast<std::size_t>(std::snprintf(number, sizeof number, "%.9f%c",
                                                                           value, k == 2 ? '\n' : ' ')));
            else if (std::string_view(as.type) == "double")
                put(value);
            else
                put(static_cast<float>(value));
        }
    for (const glm::uvec3& t : mesh.triangles) {
        if (text) {
            file += "3 " + std::to_string(t.x) + " " + std::to_string(t.y) + " " + std::to_string(t.z) + "\n";
            continue;
        }
        file += '\3';
        for (int k = 0; k < 3; ++k) put(t[k]);
    }
    return file;
}

class FarPly : public testing::TestWithParam<Coordinates> {};

TEST_P(FarPly, LooksAsNearZeroOrWarns) {
    const Mesh ball = sphere_mesh(5, 12);
    const auto loaded = [&](const Vec3& by) {
        const std::string file = ply_file(ball, by, GetParam());
        return parse_ply(std::as_bytes(std::span(file)), "ball.ply");
    };
    const auto picture = [](const std::shared_ptr<const Mesh>& mesh) {
        SceneDescription scene = preview_scene(mesh, "ball.ply", Axis::z);
        scene.render.width = 96;
        scene.render.height = 72;
        return rendered(scene).image;
    };
    const Image expected = picture(loaded(Vec3(0)).mesh);
    for (const double offset : offsets) {
        const LoadedMesh far = loaded(place(offset));
        EXPECT_GT(glm::length(far.mesh->origin), offset);
        const bool warned = !of_precision(far.warnings).empty();
        EXPECT_EQ(warned, !GetParam().exact && offset > 1e3);
        if (warned) continue;
        EXPECT_LE(difference(picture(far.mesh), expected), 0.002) << offset;
    }
}

INSTANTIATE_TEST_SUITE_P(All, FarPly,
                         testing::Values(Coordinates{"TextOfDoubles", "ascii", "double", true},
                                         Coordinates{"TextOfFloats", "ascii", "float", true},
                                         Coordinates{"Doubles", "binary_little_endian", "double", true},
                                         Coordinates{"Floats", "binary_little_endian", "float", false}),
                         [](const auto& param) { return param.param.name; });

TEST(FarPly, KeepsItsPlaceWhenItIsWritten) {
    const std::string file =
        ply_file(sphere_mesh(5, 4), place(1e6), {"", "binary_little_endian", "double", true});
    const auto mesh = parse_ply(std::as_bytes(std::span(file)), "far.ply").mesh;
    const std::string path = testing::TempDir() + "glint_far_" + std::to_string(::getpid()) + ".ply";
    write_ply(path, *mesh);
    const auto again = load_mesh(path).mesh;
    std::remove(path.c_str());
    ASSERT_EQ(again->positions.size(), mesh->positions.size());
    for (std::size_t i = 0; i < mesh->positions.size(); ++i)
        EXPECT_LT(glm::length(again->origin - mesh->origin + Vec3(again->positions[i] - mesh->positions[i])),
                  1e-6);
}

// ── Instances ──────────────────────────────────────────────────────────────────────────────────────────────

TEST(FarMesh, IsInstancedNearZero) {
    Mesh ball = sphere_mesh(1, 8);
    ball.origin = place(1e6);
    SceneDescription scene = empty_scene(Vec3(0, -8, 0), Vec3(0, 1, 0), 64);
    Object& source = add(scene, mesh_of(std::move(ball)), matte());
    source.name = "ball";
    source.visible = false;
    Object& shown = add(scene, InstanceShape{"ball"}, matte());
    shown.transform[3] = glm::dvec4(-place(1e6), 1);
    add_light(scene, Vec3(-3, -6, 4), 40);
    SceneDescription near = scene;
    std::get<MeshShape>(near.objects[0].shape) = mesh_of(sphere_mesh(1, 8));
    near.objects[1].transform = Mat4(1.0);
    EXPECT_LE(difference(rendered(scene).image, rendered(near).image), 0.002);
}

} // namespace
} // namespace glint::kit
