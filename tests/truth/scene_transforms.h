#pragma once
// A scene moved, turned, mirrored or scaled as a whole: what must not change its picture.

#include "glint/scene.h"

namespace glint {

/// Lengths · 2^k, intensities · 4^k, absorption · 2^−k.
SceneDescription scaled(SceneDescription scene, int k);

/// Everything, the camera included, under a rotation, translation or reflection: objects through their
/// transforms, planes without one by their equations.
SceneDescription moved(SceneDescription scene, const Mat4& motion);

/// x → −x.
Mat4 mirror_x();
/// x ↔ y.
Mat4 swap_xy();

} // namespace glint
