#include "glint/scene.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

SampleCounts counts(std::optional<int> spp, int max_spp, Integrator integrator = Integrator::whitted) {
    RenderSettings settings;
    settings.spp = spp;
    settings.max_spp = max_spp;
    settings.integrator = integrator;
    return sample_counts(settings);
}

TEST(SampleCounts, AreAdaptiveByDefault) {
    EXPECT_EQ(sample_counts({}), (SampleCounts{1, 8}));
    EXPECT_EQ(counts({}, 64), (SampleCounts{1, 64}));
    EXPECT_EQ(counts({}, 1), (SampleCounts{1, 0}));
}

TEST(SampleCounts, AreFixedWhereStated) {
    for (const int spp : {1, 4, 100}) {
        EXPECT_EQ(counts(spp, 0), (SampleCounts{spp, 0}));
        EXPECT_EQ(counts(spp, spp), (SampleCounts{spp, 0}));
        EXPECT_EQ(counts(spp, 2 * spp), (SampleCounts{spp, 2 * spp}));
    }
}

TEST(SampleCounts, AreFixedForAmbientOcclusion) {
    EXPECT_EQ(counts({}, 0, Integrator::ambient_occlusion), (SampleCounts{4, 0}));
    EXPECT_EQ(counts({}, 16, Integrator::ambient_occlusion), (SampleCounts{4, 16}));
    EXPECT_EQ(counts(9, 0, Integrator::ambient_occlusion), (SampleCounts{9, 0}));
}

} // namespace
} // namespace glint
