#pragma once
// A picture depends on scene and seed alone.

#include "scene_kit.h"

#include <gtest/gtest.h>

namespace glint::kit {

/// Expects the same bits of the recursive kernel, other threads and tiles, and a crop of 7 × 9 pixels at
/// (3, 5).
inline void expect_one_picture(const SceneDescription& scene) {
    const Image expected = rendered(scene).image;
    RenderOptions options;
    options.kernel.kernel = Kernel::scalar;
    EXPECT_EQ(picture_hash(rendered(scene, options).image), picture_hash(expected));
    options = {};
    options.threads = 3;
    options.tile_size = 7;
    EXPECT_EQ(picture_hash(render(build_scene(scene), options).image), picture_hash(expected));
    options.crop = Rect{3, 5, 7, 9};
    const Image part = rendered(scene, options).image;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 7; ++x) EXPECT_EQ(part.at(x, y)[1], expected.at(x + 3, y + 5)[1]);
}

} // namespace glint::kit
