// Textures that come back, from wherever they are let go.

#include "gpu_kit.h"

#include "gpu/context.h"
#include "gpu/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <epoxy/gl.h>
#include <memory>
#include <thread>
#include <vector>

namespace glint::gpu {
namespace {

TEST(GpuPictures, ThoseLetGoWithoutAContextAreKeptUntilThereIsOne) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    const GpuScope scope(context);
    GpuPicturePool pool(context);
    std::vector<std::shared_ptr<GpuPicture>> pictures;
    std::vector<std::uint32_t> textures;
    for (int i = 0; i < 6; ++i) {
        pictures.push_back(pool.take(16, 8));
        textures.push_back(pictures.back()->texture());
    }
    const auto alive = [&] {
        return std::count_if(textures.begin(), textures.end(),
                             [](std::uint32_t texture) { return glIsTexture(texture) == GL_TRUE; });
    };
    std::thread([&] { pictures.clear(); }).join();
    EXPECT_EQ(alive(), 6);
    const auto next = pool.take(16, 8);
    EXPECT_NE(std::find(textures.begin(), textures.end(), next->texture()), textures.end());
    EXPECT_EQ(alive(), 3) << "the one that is used, and two to spare";
    const auto other = pool.take(8, 16);
    EXPECT_EQ(alive(), 1) << "those of another size are of no use";
    context.check("testing");
}

TEST(GpuPictures, OneThatCouldNotBeMadeIsNotKept) {
    GLINT_NEEDS_GPU();
    const GpuContext context(-1);
    const GpuScope scope(context);
    GpuPicturePool pool(context);
    for (int i = 0; i < 2; ++i)
        EXPECT_NE(refusal([&] { pool.take(1 << 24, 8); }).find("making room for the picture"),
                  std::string::npos);
    EXPECT_NE(pool.take(8, 8)->texture(), 0u);
    context.check("testing");
}

} // namespace
} // namespace glint::gpu
