// G17: no length, no axis and no side is special.

#include "gallery.h"
#include "scene_kit.h"
#include "scene_transforms.h"

#include "glint/image.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

using namespace kit;

class G17 : public testing::TestWithParam<Exhibit> {};
class G17b : public testing::TestWithParam<Exhibit> {};

INSTANTIATE_TEST_SUITE_P(Gallery, G17, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });
INSTANTIATE_TEST_SUITE_P(Gallery, G17b, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

TEST_P(G17, ScalingLengthsByPowersOfTwoKeepsEveryBit) {
    const std::string expected = picture_hash(rendered(GetParam().scene).image);
    for (int k = -20; k <= 20; ++k)
        EXPECT_EQ(picture_hash(rendered(scaled(GetParam().scene, k)).image), expected) << "k = " << k;
}

/// Pixels of `image` that are not exactly those of `mirrored` on the other side.
int unlike_mirrored(const Image& image, const Image& mirrored) {
    int unlike = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                if (image.at(x, y)[c] != mirrored.at(image.width - 1 - x, y)[c]) ++unlike;
    return unlike;
}

TEST_P(G17, MirroringXMirrorsThePictureExactly) {
    const Image expected = rendered(GetParam().scene).image;
    EXPECT_EQ(unlike_mirrored(expected, rendered(moved(GetParam().scene, mirror_x())).image), 0);
}

TEST_P(G17, ExchangingXAndYMirrorsThePictureExactly) {
    const Image expected = rendered(GetParam().scene).image;
    EXPECT_EQ(unlike_mirrored(expected, rendered(moved(GetParam().scene, swap_xy())).image), 0);
}

void expect_alike(const SceneDescription& scene, const SceneDescription& other) {
    const Comparison c = compare(rendered(scene).image, rendered(other).image, 1.0 / 255, 1);
    EXPECT_GT(c.psnr, 55);
    EXPECT_LE(c.share, 0.005);
}

SceneDescription larger(SceneDescription scene) {
    scene.render.width *= 3;
    scene.render.height *= 3;
    return scene;
}

TEST_P(G17b, RotatingSceneAndCameraKeepsThePicture) {
    const SceneDescription scene = larger(GetParam().scene);
    for (unsigned i : {1u, 6u}) expect_alike(scene, moved(scene, rotation(i)));
}

TEST_P(G17b, MovingSceneAndCameraKeepsThePicture) {
    const SceneDescription scene = larger(GetParam().scene);
    for (double step : {1.0, 8.0, 64.0}) {
        Mat4 shift(1.0);
        shift[3] = {step, -2 * step, step, 1};
        expect_alike(scene, moved(scene, shift));
    }
}

} // namespace
} // namespace glint
