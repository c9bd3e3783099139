#pragma once
// Scenes that are path traced.

#include "scene_kit.h"

namespace glint::kit {

inline SceneDescription path_scene(const Vec3& eye = Vec3(0), const Vec3& direction = Vec3(0, 1, 0)) {
    SceneDescription scene = empty_scene(eye, direction);
    scene.render.integrator = Integrator::path;
    return scene;
}

/// A room with a lamp, a mirror, a pane, a glass ball and a glossy one.
inline SceneDescription room() {
    SceneDescription scene = empty_scene(Vec3(0, -3.5, 1), Vec3(0, 1, 0), 24, 40);
    scene.render.spp = 16;
    scene.path.max_depth = 8;
    add(scene, PlaneShape{Vec3(0, 0, 1), 0}, matte(0.7));
    add(scene, PlaneShape{Vec3(0, 0, -1), -2}, matte(0.7));
    add(scene, PlaneShape{Vec3(0, -1, 0), -1}, matte(0.7));
    add(scene, PlaneShape{Vec3(1, 0, 0), -1}, matte(0.4));
    add(scene, PlaneShape{Vec3(-1, 0, 0), -1}, mirror(0.6));
    add(scene, RectangleShape{Vec3(-0.4, -0.4, 1.99), Vec3(0.8, 0, 0), Vec3(0, 0.8, 0)}, lamp(Vec3(4)));
    Material glossy = matte(0.3);
    glossy.highlight = 0.5;
    glossy.shininess = 20;
    add(scene, SphereShape{Vec3(0.4, 0.3, 0.4), 0.4}, glossy);
    Material ball = glass(1.5);
    ball.fresnel = true;
    add(scene, SphereShape{Vec3(-0.4, -0.2, 0.4), 0.3}, ball);
    Material pane = glass(1.5, 0.5);
    pane.reflectivity = 0.25;
    add(scene, RectangleShape{Vec3(-0.8, -0.6, 1.2), Vec3(0.9, 0, 0), Vec3(0, 0.9, 0)}, pane);
    return scene;
}

} // namespace glint::kit
