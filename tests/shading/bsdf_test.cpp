// BSDFs: what is sampled, its density and its value belong together (shading/bsdf.shared.h).

#include "shading/bsdf.shared.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

TEST(Bsdf, SamplesADiffuseSurfaceByTheCosine) {
    MaterialRecord m{};
    m.diffuse = 1;
    SurfaceRecord s{};
    s.n = s.n_g = s.v = vec3(0, 0, 1);
    s.color = vec3(0.5f);
    const Bsdf b = bsdf_at(m, s, BsdfSides{1, 1, false}, WhittedModes{});
    const BsdfSample x = bsdf_sample(b, 0.5f, 0.3f, 0.4f);
    EXPECT_NEAR(sum_of(x.weight).x, 0.5, 1e-6);
    EXPECT_EQ(x.pdf, bsdf_pdf(b, x.direction));
}

} // namespace
} // namespace glint
