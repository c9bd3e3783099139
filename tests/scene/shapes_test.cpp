// Shapes under transforms, against the same shape at rest.

#include "scene_kit.h"

#include "scene/scene_data.h"
#include "scene/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace glint::scene {

using trace::Hit;
namespace {

using namespace kit;

/// Numbers in [-1, 1) that are the same everywhere.
class Numbers {
  public:
    double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1.0; }
    dvec3 point() {
        const double x = (*this)();
        const double y = (*this)();
        const double z = (*this)();
        return {x, y, z};
    }

  private:
    std::mt19937_64 engine_{11};
};

const std::vector<Shape>& finite_shapes() {
    PolyhedronShape prism{PolyhedronKind::prism};
    prism.axis = Vec3(0.3, 0.1, 1);
    static const std::vector<Shape> shapes{
        SphereShape{Vec3(0.1, 0.2, 0.3), 0.8},
        CylinderShape{Vec3(0, 0.1, -0.5), Vec3(0.2, 0.4, 1), 1.1, 0.6},
        TriangleShape{{Vec3(-1, 0, 0), Vec3(1, 0, 0.2), Vec3(0, 1, 0.5)}},
        prism,
        RectangleShape{Vec3(-0.8, -0.7, 0.1), Vec3(1.5, 0.1, 0.3), Vec3(0.4, 1.2, -0.2)},
        DiskShape{Vec3(0.1, -0.1, 0.2), Vec3(0.3, -0.2, 2), 0.9},
        ConeShape{Vec3(0.1, 0, -0.6), Vec3(0.2, -0.1, 1), 1.4, 0.7},
    };
    return shapes;
}

Scene scene_of(const Shape& shape, const Mat4& transform) {
    SceneDescription scene = empty_scene();
    add(scene, shape, matte()).transform = transform;
    return build_scene(scene);
}

Ray ray_between(const dvec3& from, const dvec3& to) {
    Ray ray;
    ray.origin = vec3(from);
    ray.direction = vec3(to - from);
    return ray;
}

/// A turn and a stretch, a squeezed one, and a mirror.
std::vector<Mat4> transforms() {
    Mat4 similar(0.6, 0.8, 0, 0, -0.8, 0.6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    for (int column = 0; column < 3; ++column) similar[column] *= 1.5;
    similar[3] = {3, -2, 1, 1};
    const Mat4 squeezed(1, 0.2, 0, 0, -0.5, 0.7, 0.3, 0, 0.1, 0, 1.6, 0, -1, 2, 3, 1);
    const Mat4 mirror(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1);
    return {similar, squeezed, mirror};
}

TEST(Shapes, AreHitUnderATransformWhereTheyAreHitAtRest) {
    for (const Shape& shape : finite_shapes()) {
        const Scene rest = scene_of(shape, Mat4(1));
        for (const Mat4& m : transforms()) {
            const Scene moved = scene_of(shape, m);
            Numbers random;
            int both = 0;
            int different = 0;
            for (int i = 0; i < 4000; ++i) {
                const dvec3 from = random.point() * 3.0;
                const dvec3 to = random.point() * 0.8;
                const Hit a = rest.data().world.closest(ray_between(from, to));
                const Ray ray = ray_between(dvec3(m * dvec4(from, 1)), dvec3(m * dvec4(to, 1)));
                const Hit b = moved.data().world.closest(ray);
                if (bool(a) != bool(b)) ++different;
                if (!a || !b) continue;
                ++both;
                ASSERT_NEAR(a.t, b.t, 1e-3 * a.t + 1e-5) << shape.index();
                const SurfacePoint p = rest.data().world.surface(ray_between(from, to), a);
                const SurfacePoint q = moved.data().world.surface(ray, b);
                if (glm::length(dvec3(m * dvec4(dvec3(p.p), 1)) - dvec3(q.p)) > 1e-4) continue;
                const dvec3 normal = glm::normalize(glm::transpose(glm::inverse(dmat3(m))) * dvec3(p.n));
                const bool flat_mesh = std::holds_alternative<TriangleShape>(shape) ||
                                       std::holds_alternative<RectangleShape>(shape);
                const double mirrored = flat_mesh && glm::determinant(dmat3(m)) < 0 ? -1 : 1;
                if (glm::dot(normal * mirrored, dvec3(q.n)) < 0.99) ++different; // across a rim
            }
            EXPECT_GT(both, 500) << shape.index();
            EXPECT_LE(different, 8) << shape.index();
        }
    }
}

TEST(Shapes, SupportIsThatOfThePointsThatAreHit) {
    for (const Shape& shape : finite_shapes()) {
        for (const Mat4& m : transforms()) {
            const Scene scene = scene_of(shape, m);
            const Object& object = scene.description().objects[0];
            Numbers random;
            const dvec3 d = random.point();
            double most = -1e9;
            std::vector<Hit> hits;
            for (int i = 0; i < 20'000; ++i) {
                const Ray ray = ray_between(dvec3(m * dvec4(random.point() * 3.0, 1)),
                                            dvec3(m * dvec4(random.point() * 0.8, 1)));
                scene.data().world.all_hits(ray, hits);
                for (const Hit& hit : hits)
                    most = std::max(most, glm::dot(d, dvec3(scene.data().world.surface(ray, hit).p)));
            }
            const double expected = support(scene.description(), object, d).value();
            const bool bounded = std::holds_alternative<PolyhedronShape>(shape); // by its cylinder
            EXPECT_LE(most, expected + 1e-5) << shape.index();
            EXPECT_GE(most, expected - (bounded ? 0.5 : 0.1)) << shape.index();
        }
    }
}

TEST(Support, OfManyInstancesLooksAtTheMeshForFew) {
    SceneDescription scene = empty_scene();
    Object& mesh = add(scene, mesh_of(sphere_mesh(1, 100)), matte());
    mesh.name = "ball";
    mesh.visible = false;
    std::get<MeshShape>(mesh.shape).scale = Vec3(1, 2, 3);
    Numbers random;
    for (unsigned i = 0; i < 2000; ++i) {
        Object& ball = add(scene, InstanceShape{"ball"}, std::string());
        ball.transform = rotation(i);
        ball.transform[3] = dvec4(random.point() * 100.0, 1);
    }
    const dvec3 d = random.point();
    double most = -1e9;
    for (const Object& object : scene.objects)
        if (object.visible) most = std::max(most, support(scene, object, d).value());
    EXPECT_EQ(support(scene, d), most);
    for (int i = 0; i < 200; ++i) EXPECT_GT(support(scene, random.point()), 0);
}

TEST(Shapes, KnowWhetherTheyBoundAVolume) {
    for (const Shape& shape : finite_shapes()) {
        const bool thin = std::holds_alternative<TriangleShape>(shape) ||
                          std::holds_alternative<RectangleShape>(shape) ||
                          std::holds_alternative<DiskShape>(shape);
        EXPECT_EQ(is_solid(shape), !thin) << shape.index();
        EXPECT_EQ(scene_of(shape, Mat4(1)).data().objects[0].solid, !thin) << shape.index();
    }
    EXPECT_FALSE(is_solid(PlaneShape{}));
    EXPECT_TRUE(is_solid(PlaneShape{Vec3(0, 0, 1), 0, true}));
}

} // namespace
} // namespace glint::scene
