#include "geometry/polyhedron.h"
#include "glint/mesh_files.h"
#include "glint/scene.h"
#include "math/trig.h"
#include "scene/validate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

namespace glint::scene {
namespace {

Mesh to_mesh(const geometry::Polyhedron& p, double size = 1, const dvec3& offset = dvec3(0)) {
    Mesh mesh;
    for (const dvec3& v : p.positions) mesh.positions.emplace_back(v * size + offset);
    mesh.triangles = p.triangles;
    return mesh;
}

Mesh pyramid_along(const dvec3& axis) { return to_mesh(geometry::make_pyramid({dvec3(0), axis, 5, 1, 2})); }

// Hills over the plane of the other two axes, with a rim at different heights.
Mesh landscape(int up) {
    Mesh mesh;
    for (unsigned i = 0; i < 10; ++i) {
        for (unsigned j = 0; j < 10; ++j) {
            glm::vec3 p(0);
            p[(up + 1) % 3] = static_cast<float>(i) / 9;
            p[(up + 2) % 3] = static_cast<float>(j) / 9;
            p[up] = static_cast<float>((i * 7 + j * 5) % 11) / 40;
            mesh.positions.push_back(p);
            if (i == 9 || j == 9) continue;
            const unsigned a = i * 10 + j;
            mesh.triangles.emplace_back(a, a + 10, a + 11);
            mesh.triangles.emplace_back(a, a + 11, a + 1);
        }
    }
    return mesh;
}

SceneDescription staged(const Mesh& mesh, Axis up = Axis::z) {
    return preview_scene(std::make_shared<const Mesh>(mesh), "model.ply", up);
}

// Where a point appears, −1 … 1 from edge to edge in both directions; the camera must not be behind it.
dvec2 on_picture(const SceneDescription& scene, const CameraDescription& camera, const dvec3& p) {
    const dvec3 forward = glm::normalize(camera.direction);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 up = glm::cross(right, forward);
    const dvec3 d = p - camera.eye;
    const double k = tan_degrees(camera.fov / 2);
    const double depth = glm::dot(d, forward);
    EXPECT_GT(depth, 0);
    const double aov = static_cast<double>(scene.render.width) / scene.render.height;
    return dvec2(glm::dot(d, right) / (depth * k * aov), glm::dot(d, up) / (depth * k));
}

const glm::vec3 outlier(900, -5000, 300);

// Points on a ball, spread evenly.
Mesh ball_cloud() {
    Mesh cloud;
    constexpr int count = 600;
    for (int i = 0; i < count; ++i) {
        const double z = (2.0 * i + 1) / count - 1, r = std::sqrt(1 - z * z), turn = 137.507764 * i;
        cloud.positions.emplace_back(r * cos_degrees(turn), r * sin_degrees(turn), z);
    }
    return cloud;
}

// How near to the edge of the picture the farthest vertex of the first object comes, without the outlier: 1
// is the edge.
double filled(const SceneDescription& scene) {
    const CameraDescription camera = fit_camera(scene);
    const Object& object = scene.objects.at(0);
    const Mesh& mesh = *std::get<MeshShape>(object.shape).data;
    double most = 0;
    for (const glm::vec3& v : mesh.positions) {
        if (v == outlier) continue;
        const dvec3 p = mesh.origin + dvec3(v);
        const dvec2 at = on_picture(scene, camera, dvec3(object.transform * dvec4(p, 1)));
        most = std::max({most, std::abs(at.x), std::abs(at.y)});
    }
    return most;
}

const PlaneShape& floor_of(const SceneDescription& scene) {
    return std::get<PlaneShape>(scene.objects.at(1).shape);
}

TEST(UpAxis, FollowsThePyramidsBase) {
    EXPECT_EQ(guess_up_axis(pyramid_along(dvec3(0, 1, 0))), Axis::y);
    EXPECT_EQ(guess_up_axis(pyramid_along(dvec3(0, 0, 1))), Axis::z);
}

TEST(UpAxis, FollowsTheLandscapesUpperSide) {
    EXPECT_EQ(guess_up_axis(landscape(1)), Axis::y);
    EXPECT_EQ(guess_up_axis(landscape(2)), Axis::z);
}

TEST(UpAxis, IsZWhereBothAreAlike) {
    EXPECT_EQ(guess_up_axis(to_mesh(geometry::make_box(dvec3(0), dvec3(1)))), Axis::z);
}

TEST(UpAxis, LooksAtPointsWithoutFaces) {
    Mesh cloud = pyramid_along(dvec3(0, 0, 1));
    cloud.triangles.clear();
    EXPECT_EQ(guess_up_axis(cloud), Axis::z);
}

TEST(UpAxis, IgnoresVerticesThatNoFaceUses) {
    Mesh mesh = pyramid_along(dvec3(0, 0, 1));
    mesh.positions.emplace_back(0, -100, -100);
    mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(guess_up_axis(mesh), Axis::z);
}

TEST(UpAxis, IsRightForRealModels) {
    const std::filesystem::path models = std::filesystem::path(GLINT_SOURCE_DIR) / ".." / "shared" / "models";
    if (!std::filesystem::exists(models)) GTEST_SKIP() << "no models in " << models;
    for (const char* name : {"bunny", "bun_zipper_res4", "dragon", "igea", "terrain"}) {
        const std::string file = (models / name).string() + ".ply";
        EXPECT_EQ(guess_up_axis(*load_mesh(file).mesh), Axis::y) << name;
    }
    for (const char* name : {"cat-2", "oacmpctf3"}) {
        const std::string file = (models / name).string() + ".ply";
        EXPECT_EQ(guess_up_axis(*load_mesh(file).mesh), Axis::z) << name;
    }
}

TEST(PreviewScene, TurnsTheUpAxisToZExactly) {
    for (int axis = 0; axis < 3; ++axis) {
        dvec4 up(0);
        up[axis] = 1;
        const Mat4 m = staged(pyramid_along(dvec3(0, 0, 1)), static_cast<Axis>(axis)).objects[0].transform;
        EXPECT_EQ(m * up, dvec4(0, 0, 1, 0)) << axis;
        EXPECT_EQ(glm::determinant(m), 1) << axis;
    }
}

TEST(PreviewScene, IsValidAndFilledForAnySizeAndPlace) {
    const geometry::Polyhedron shape = geometry::make_dodecahedron(dvec3(0), 1);
    for (double size : {1e-6, 1e-3, 1.0, 1e6}) {
        for (double offset : {0.0, 10.0, -1000.0}) {
            const SceneDescription scene = staged(to_mesh(shape, size, dvec3(offset, 2 * offset, 0) * size));
            EXPECT_TRUE(find_errors(scene).empty());
            EXPECT_NEAR(filled(scene), 0.78, 1e-3) << size << " " << offset;
        }
    }
}

TEST(PreviewScene, FillsPicturesOfAnyShapeFromAnyDirection) {
    const auto box = [](double x, double y, double z) {
        return to_mesh(geometry::make_box(dvec3(0), dvec3(x, y, z)));
    };
    Mesh with_outlier = ball_cloud(), far = pyramid_along(dvec3(1, 0, 0));
    with_outlier.positions.push_back(outlier);
    far.origin = dvec3(500120.25, 5412345.75, 312.5);
    const std::vector<Mesh> meshes{box(1, 1, 1),
                                   box(0.1, 0.2, 9),
                                   box(9, 0.1, 0.2),
                                   box(0.1, 9, 0.2),
                                   box(8, 6, 0.01),
                                   box(6, 0.01, 8),
                                   landscape(2),
                                   pyramid_along(dvec3(0, 0, 1)),
                                   to_mesh(geometry::make_icosahedron(dvec3(0), 1)),
                                   ball_cloud(),
                                   with_outlier,
                                   far};
    const std::vector<dvec3> directions{{0, 1, 0},  {1, 0, 0}, {-1, -2, -1},
                                        {0, 0, -1}, {0, 0, 1}, {3, -1, 2}};
    const std::array<std::array<int, 2>, 5> sizes{{{640, 480}, {120, 360}, {360, 120}, {64, 64}, {1000, 50}}};
    for (const Mesh& mesh : meshes) {
        SceneDescription scene = staged(mesh);
        for (const auto& [width, height] : sizes) {
            scene.render.width = width;
            scene.render.height = height;
            for (const dvec3& direction : directions) {
                scene.framing.direction = direction;
                // The spheres about the points of a cloud take up a part of it.
                const bool cloud = mesh.triangles.empty();
                EXPECT_NEAR(filled(scene), cloud ? 0.71 : 0.78, cloud ? 0.04 : 1e-3)
                    << &mesh - meshes.data() << " " << width << " " << height;
            }
        }
    }
}

TEST(PreviewScene, FloorLiesJustUnderTheLowestPoint) {
    const Mesh mesh = to_mesh(geometry::make_box(dvec3(5, 6, 7), dvec3(2, 4, 6)));
    const double radius = std::sqrt(14.0);
    EXPECT_NEAR(floor_of(staged(mesh)).offset, 4, 2e-4 * radius);
    EXPECT_LT(floor_of(staged(mesh)).offset, 4);
    EXPECT_NEAR(floor_of(staged(mesh, Axis::y)).offset, 4, 2e-4 * radius);
}

TEST(PreviewScene, LightGrowsWithTheSquareOfTheSize) {
    const geometry::Polyhedron shape = geometry::make_icosahedron(dvec3(0), 1);
    const SceneDescription small = staged(to_mesh(shape));
    const SceneDescription large = staged(to_mesh(shape, 1024));
    ASSERT_EQ(small.lights.size(), large.lights.size());
    for (std::size_t i = 0; i < small.lights.size(); ++i) {
        const auto* a = std::get_if<PointLight>(&small.lights[i].kind);
        const auto* b = std::get_if<PointLight>(&large.lights[i].kind);
        if (a == nullptr) continue;
        EXPECT_EQ(b->position, a->position * 1024.0);
        EXPECT_EQ(b->intensity, a->intensity * 1024 * 1024);
    }
}

TEST(PreviewScene, ShowsVertexColoursInWhiteLight) {
    Mesh mesh = to_mesh(geometry::make_icosahedron(dvec3(0), 1));
    EXPECT_NE(staged(mesh).materials.at(0).color, Vec3(1));
    mesh.colors.assign(mesh.positions.size(), glm::vec3(0.5f));
    EXPECT_EQ(staged(mesh).materials.at(0).color, Vec3(1));
}

TEST(PreviewScene, TakesFlatMeshes) {
    Mesh square;
    square.positions = {{0, 0, 3}, {1, 0, 3}, {1, 1, 3}, {0, 1, 3}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (Axis up : {Axis::x, Axis::y, Axis::z, Axis::minus_x, Axis::minus_y, Axis::minus_z}) {
        const SceneDescription scene = staged(square, up);
        EXPECT_TRUE(find_errors(scene).empty());
        EXPECT_NEAR(filled(scene), 0.78, 1e-9);
    }
}

TEST(PreviewScene, TakesPointCloudsDownToOnePoint) {
    Mesh cloud;
    cloud.positions = {{1, 2, 3}, {2, 2, 3}};
    // The spheres about the points are a quarter of their distance in radius.
    EXPECT_NEAR(filled(staged(cloud)), 0.78 / 1.5, 0.05);

    cloud.positions = {{1e6f, 0, 0}};
    const SceneDescription scene = staged(cloud);
    EXPECT_TRUE(find_errors(scene).empty());
    EXPECT_NEAR(filled(scene), 0, 1e-9);
    EXPECT_GT(glm::length(fit_camera(scene).eye - dvec3(1e6, 0, 0)), 2) << "outside its sphere of radius 1";
}

TEST(PreviewScene, RefusesWhatHasNothingToShow) {
    const auto message = [](std::shared_ptr<const Mesh> mesh) -> std::string {
        try {
            preview_scene(mesh, "empty.ply", Axis::z);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_EQ(error.diagnostics().at(0).location.file, "empty.ply");
            return error.diagnostics().at(0).message;
        }
        return "";
    };
    const std::string expected = "the mesh has nothing to show: no vertex that is finite and used";
    EXPECT_EQ(message(nullptr), expected);
    EXPECT_EQ(message(std::make_shared<const Mesh>()), expected);
    Mesh nan;
    nan.positions.emplace_back(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(message(std::make_shared<const Mesh>(nan)), expected);
}

Object object_of(Shape shape) {
    Object object;
    object.shape = std::move(shape);
    return object;
}

// Every corner of a box of half-edge `h` about `c` must be in the picture, one at its edge's margin.
void expect_framed(const SceneDescription& scene, const dvec3& c, double h) {
    const CameraDescription camera = fit_camera(scene);
    double most = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 side((corner & 1) ? h : -h, (corner & 2) ? h : -h, (corner & 4) ? h : -h);
        const dvec2 at = on_picture(scene, camera, c + side);
        most = std::max({most, std::abs(at.x), std::abs(at.y)});
    }
    EXPECT_NEAR(most, 0.85, 1e-9);
}

TEST(Frame, SeesABoxAtTheMarginOfThePicture) {
    SceneDescription scene;
    scene.objects.push_back(object_of(PolyhedronShape{PolyhedronKind::box, Vec3(3, 4, 5), Vec3(2)}));
    expect_framed(scene, dvec3(3, 4, 5), 1);
    scene.render.width = 200;
    expect_framed(scene, dvec3(3, 4, 5), 1);
}

TEST(Frame, ShowsAllMomentsOfAnAnimation) {
    SceneDescription scene;
    scene.objects.push_back(object_of(PolyhedronShape{PolyhedronKind::box, Vec3(0), Vec3(2)}));
    const auto moments = std::make_shared<std::vector<SceneDescription>>(2, scene);
    moments->at(1).objects[0].transform = Mat4(dmat3(3.0));
    scene.framing.moments = moments;
    expect_framed(scene, dvec3(0), 3);
}

TEST(Frame, FollowsTransformsAndInstances) {
    auto box = std::make_shared<Mesh>(to_mesh(geometry::make_box(dvec3(0), dvec3(1))));
    MeshShape shape;
    shape.data = box;
    shape.scale = Vec3(4);
    SceneDescription scene;
    scene.objects.push_back(object_of(shape));
    scene.objects[0].name = "box";
    scene.objects[0].visible = false;
    scene.objects[0].transform[3] = dvec4(1, 0, 0, 1);
    scene.objects.push_back(object_of(InstanceShape{"box"}));
    scene.objects[1].transform = Mat4(dmat3(3.0));
    expect_framed(scene, dvec3(3, 0, 0), 6);
}

TEST(Frame, IgnoresPlanesAndHiddenObjects) {
    SceneDescription scene;
    scene.objects.push_back(object_of(PolyhedronShape{PolyhedronKind::box, Vec3(0), Vec3(2)}));
    scene.objects.push_back(object_of(PlaneShape{Vec3(0, 0, 1), -1000}));
    scene.objects.push_back(object_of(SphereShape{Vec3(100), 50}));
    scene.objects[2].visible = false;
    expect_framed(scene, dvec3(0), 1);
}

TEST(Frame, SeesRoundThingsWhole) {
    SceneDescription scene;
    scene.objects.push_back(object_of(SphereShape{Vec3(1, 2, 3), 2}));
    scene.objects.push_back(object_of(CylinderShape{Vec3(-4, 0, 0), Vec3(1, 1, 2), 3, 1}));
    const CameraDescription camera = fit_camera(scene);
    const dvec3 axis = glm::normalize(dvec3(1, 1, 2));
    const dvec3 side = glm::normalize(glm::cross(axis, dvec3(0, 0, 1)));
    for (int i = 0; i < 360; i += 10) {
        const dvec3 round(cos_degrees(i), 0, sin_degrees(i));
        const dvec3 rim = side * cos_degrees(i) + glm::cross(axis, side) * sin_degrees(i);
        for (const dvec3& p :
             {dvec3(1, 2, 3) + 2.0 * round, dvec3(-4, 0, 0) + rim, dvec3(-4, 0, 0) + rim + 3.0 * axis}) {
            const dvec2 at = on_picture(scene, camera, p);
            EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 0.85 + 1e-9);
        }
    }
}

TEST(Frame, SeesConesAndDisksWhole) {
    SceneDescription scene;
    scene.objects.push_back(object_of(ConeShape{Vec3(2, 1, 0), Vec3(1, 1, 2), 5, 1}));
    scene.objects.push_back(object_of(DiskShape{Vec3(-3, 0, 1), Vec3(1, 1, 2), 2}));
    const dvec3 axis = glm::normalize(dvec3(1, 1, 2));
    const dvec3 side = glm::normalize(glm::cross(axis, dvec3(0, 0, 1)));
    std::vector<dvec3> points{dvec3(2, 1, 0) + 5.0 * axis};
    for (int i = 0; i < 360; i += 10) {
        const dvec3 rim = side * cos_degrees(i) + glm::cross(axis, side) * sin_degrees(i);
        points.push_back(dvec3(2, 1, 0) + rim);
        points.push_back(dvec3(-3, 0, 1) + 2.0 * rim);
    }
    const CameraDescription camera = fit_camera(scene);
    double farthest = 0;
    for (const dvec3& p : points) {
        const dvec2 at = on_picture(scene, camera, p);
        farthest = std::max(farthest, std::max(std::abs(at.x), std::abs(at.y)));
    }
    EXPECT_NEAR(farthest, 0.85, 0.01) << "no nearer to the edge, and as near as may be";
}

TEST(Frame, LooksAtThePlaneWhereThereIsNothingElse) {
    SceneDescription scene;
    scene.objects.push_back(object_of(PlaneShape{Vec3(0, 0, 2), -40}));
    const dvec2 at = on_picture(scene, fit_camera(scene), dvec3(0, 0, -20));
    EXPECT_NEAR(at.x, 0, 1e-9);
    EXPECT_LT(std::abs(at.y), 0.2);
    EXPECT_TRUE(std::isfinite(glm::length(fit_camera(SceneDescription{}).eye)));
}

} // namespace
} // namespace glint::scene
