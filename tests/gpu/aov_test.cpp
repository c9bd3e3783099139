// Every debug view of the GPU against the CPU's.

#include "gallery.h"
#include "gpu_kit.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

namespace glint::gpu {
namespace {

Image shown_on_gpu(Aov aov) {
    RenderOptions options;
    options.show = aov;
    return gpu()->render(options).image;
}

Image shown_on_cpu(const Scene& scene, Aov aov) {
    RenderOptions options;
    options.show = aov;
    return render(scene, options).image;
}

TEST(GpuAovs, EveryViewOfEverySceneLooksAsOnTheCpu) {
    GLINT_NEEDS_GPU();
    int term = 0;
    for (const kit::Exhibit& exhibit : kit::gallery()) {
        const Scene scene = build_scene(exhibit.scene);
        gpu()->prepare(scene);
        // Terms take turns; cost counts the steps of another walk.
        term = term % term_count + 1;
        for (const Aov aov : {Aov::shadows, Aov::normal, Aov::depth, static_cast<Aov>(term)})
            expect_agreement(shown_on_gpu(aov), shown_on_cpu(scene, aov),
                             exhibit.name + ", " + aov_name(aov));
    }
}

TEST(GpuAovs, NumbersOfFirstHitsDependOnNoSamples) {
    GLINT_NEEDS_GPU();
    SceneDescription scene = kit::gallery().front().scene;
    for (const Aov aov : {Aov::shadows, Aov::normal, Aov::depth}) {
        scene.render.spp = 1;
        gpu()->prepare(build_scene(scene));
        const std::string one = picture_hash(shown_on_gpu(aov));
        scene.render.spp = 9;
        gpu()->prepare(build_scene(scene));
        EXPECT_EQ(picture_hash(shown_on_gpu(aov)), one) << aov_name(aov);
    }
}

TEST(GpuAovs, CostIsThatOfTheGpusOwnTree) {
    GLINT_NEEDS_GPU();
    SceneDescription scene = kit::empty_scene(Vec3(0, -4, 0), Vec3(0, 1, 0), 17, 45);
    kit::add(scene, kit::mesh_of(kit::sphere_mesh(1, 40)), kit::matte());
    kit::add(scene, PlaneShape{Vec3(0, 0, 1), -2}, kit::matte());
    gpu()->prepare(build_scene(scene));
    const Image cost = shown_on_gpu(Aov::cost);
    EXPECT_GE(cost.at(8, 8)[0], 2) << "nodes";
    EXPECT_GE(cost.at(8, 8)[1], 2) << "the plane, and a triangle";
    EXPECT_LT(cost.at(8, 8)[1], 200) << "that is what the tree is for";
    EXPECT_EQ(cost.at(8, 8)[2], 0);
    EXPECT_EQ(cost.at(0, 0)[0], 1) << "the root";
    EXPECT_EQ(cost.at(0, 0)[1], 1) << "the plane is always tested";
    EXPECT_EQ(picture_hash(shown_on_gpu(Aov::cost)), picture_hash(cost));
}

TEST(GpuAovs, LightOnABackThatIsLitAsStored) {
    GLINT_NEEDS_GPU();
    // Inside out, in a mirror, and both, as triangles in the world and as instances.
    for (const double mirrored : {1.0, -1.0}) {
        SceneDescription scene = kit::empty_scene(Vec3(0, -5, 0), Vec3(0, 1, 0), 33, 50);
        Mesh outward = kit::sphere_mesh(1, 12);
        Mesh inward = outward;
        for (uvec3& triangle : inward.triangles) std::swap(triangle.x, triangle.y);
        for (Mesh* mesh : {&outward, &inward}) {
            MeshShape shape = kit::mesh_of(*mesh);
            shape.facing = Facing::stored;
            Object& object = kit::add(scene, shape, kit::matte());
            object.transform = Mat4(1);
            object.transform[0][0] = mirrored;
            object.transform[3][0] = mesh == &outward ? -1.2 : 1.2;
        }
        kit::add_light(scene, Vec3(3, -4, 5), 40);
        kit::add_light(scene, Vec3(0, 6, 1), 40);
        expect_agreement(scene, mirrored < 0 ? "mirrored" : "as stored");
    }
}

} // namespace
} // namespace glint::gpu
