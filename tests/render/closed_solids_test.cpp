// No ray leaves a closed solid, or begins outside of the one it is in.

#include "closed_solids.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint {
namespace {

/// The number of values in a picture that are not as they should be.
std::ptrdiff_t wrong_values(const SceneDescription& scene, float right) {
    const Picture picture = kit::rendered(scene);
    return std::count_if(picture.image.pixels.begin(), picture.image.pixels.end(),
                         [right](float value) { return value != right; });
}

TEST(ClosedSolids, WithMirrorsInsideAreBlack) {
    for (const kit::Exhibit& room : kit::mirror_rooms())
        EXPECT_EQ(wrong_values(room.scene, 0), 0) << room.name;
}

TEST(ClosedSolids, OfGlassOfIndexOneAreInvisible) {
    for (const kit::Exhibit& solid : kit::invisible_solids())
        EXPECT_EQ(wrong_values(solid.scene, 1), 0) << solid.name;
}

} // namespace
} // namespace glint
