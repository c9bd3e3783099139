// The window's projection against the rays that the renderer sends.

#include "../../apps/viewer/projection.h"

#include "glint/explain.h"
#include "glint/explanation.h"
#include "glint/scene_files.h"

#include <gtest/gtest.h>

namespace glint::viewer {
namespace {

constexpr const char* ball = R"(version = 1
[camera]
eye = [3, -7, 4]
look_at = [0.3, 0.1, 0.2]
up = [0.1, 0.2, 1]
fov = 35
[render]
size = [70, 40]
spp = 1
[material.m]
[[sphere]]
center = [0, 0, 0]
radius = 3
material = "m"
)";

TEST(Projection, PutsWhatAPixelsRayMeetsIntoThatPixel) {
    for (const char* axis : {"x", "y", "smaller", "larger"}) {
        LoadOptions options;
        options.overrides = {std::string("camera.fov_axis=") + axis};
        const Scene scene = build_scene(parse_scene(ball, "ball.toml", options).description);
        const Projection projection(scene.camera(), 70, 40);
        for (const auto& [x, y] : {std::pair{35, 20}, {30, 12}, {44, 27}, {22, 20}}) {
            const ExplainedRay ray = explain(scene, x, y).samples.front().rays.front();
            ASSERT_TRUE(ray.hit);
            const auto point = projection.point(Vec3(ray.position));
            ASSERT_TRUE(point);
            EXPECT_NEAR(point->x, x + 0.5, 1e-3) << axis;
            EXPECT_NEAR(point->y, y + 0.5, 1e-3) << axis;
        }
    }
}

TEST(Projection, LeavesOutWhatLiesBehindTheEye) {
    CameraDescription camera;
    camera.direction = {0, 1, 0};
    const Projection projection(camera, 100, 100);
    EXPECT_FALSE(projection.point({0, -1, 0}));
    EXPECT_FALSE(projection.line({1, -1, 0}, {2, -3, 0}));
    EXPECT_TRUE(projection.line({0, -5, -1}, {0, 5, -1}));
}

TEST(Projection, CutsALineWhereItPassesTheEyeWithoutBendingIt) {
    CameraDescription camera;
    camera.direction = {0, 1, 0};
    const Projection projection(camera, 100, 100);
    // From behind to before the eye, one unit below it: it appears vertical.
    const auto line = projection.line({0, -5, -1}, {0, 5, -1});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->first.x, 50, 1e-9);
    EXPECT_GT(line->first.y, 100) << "far below the picture";
    EXPECT_NEAR(line->second.y, projection.point({0, 5, -1})->y, 1e-9);
}

} // namespace
} // namespace glint::viewer
