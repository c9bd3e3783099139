#include "imaging/filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace {

using namespace glint;
using namespace glint::imaging;

constexpr std::array kinds{PixelFilter::box, PixelFilter::tent, PixelFilter::gaussian, PixelFilter::mitchell};

/// ∫ g(x) over the filter's support, by midpoints.
template <class F>
double integrate(PixelFilter kind, F g) {
    constexpr int steps = 100000;
    const double radius = filter_radius(kind);
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += g(radius * ((2 * i + 1.0) / steps - 1));
    return sum * 2 * radius / steps;
}

/// Mean of g(dx) · sign over u evenly spaced: what rendering converges to along one axis.
template <class F>
double sampled_mean(PixelFilter kind, F g) {
    constexpr int steps = 1 << 17;
    const PixelFilterSampler sampler(kind);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const FilterSample s = sampler.sample((static_cast<float>(i) + 0.5f) / steps, 0.5f);
        sum += g(static_cast<double>(s.dx)) * static_cast<double>(s.weight);
    }
    return sum / steps;
}

std::string name_of(const testing::TestParamInfo<PixelFilter>& kind) {
    constexpr std::array names{"box", "tent", "gaussian", "mitchell"};
    return names[static_cast<std::size_t>(kind.param)];
}

class Filter : public testing::TestWithParam<PixelFilter> {};

TEST_P(Filter, SamplesHaveTheMomentsOfTheFilter) {
    const PixelFilter kind = GetParam();
    const auto absolute = [&](double x) { return std::abs(filter_value(kind, x)); };
    const double mass = integrate(kind, absolute);
    for (const int power : {0, 2, 4}) {
        const auto weighted = [&](double x) { return std::pow(x, power) * filter_value(kind, x); };
        const auto moment = [&](double x) { return std::pow(x, power); };
        EXPECT_NEAR(sampled_mean(kind, moment), integrate(kind, weighted) / mass, 2e-5) << "power " << power;
    }
}

TEST_P(Filter, SamplesAreDistributedAsTheAbsoluteFilter) {
    const PixelFilter kind = GetParam();
    const double radius = filter_radius(kind);
    const double mass = integrate(kind, [&](double x) { return std::abs(filter_value(kind, x)); });

    // Evenly spaced u must fill each bin with its share of the integral, to within a few samples.
    constexpr int bins = 64;
    constexpr int steps = 1 << 18;
    std::array<int, bins> counts{};
    const PixelFilterSampler sampler(kind);
    for (int i = 0; i < steps; ++i) {
        const FilterSample s = sampler.sample(0.5f, (static_cast<float>(i) + 0.5f) / steps);
        ASSERT_LE(std::abs(s.dy), radius);
        const double position = (static_cast<double>(s.dy) / radius + 1) / 2 * bins;
        counts[static_cast<std::size_t>(std::min(position, bins - 1.0))] += 1;
    }
    for (int bin = 0; bin < bins; ++bin) {
        double share = 0;
        for (int i = 0; i < 1000; ++i)
            share += std::abs(filter_value(kind, radius * (2 * (bin + (i + 0.5) / 1000) / bins - 1)));
        share *= 2 * radius / bins / 1000 / mass;
        EXPECT_NEAR(counts[static_cast<std::size_t>(bin)], share * steps, 3 + 2e-4 * share * steps)
            << "bin " << bin;
    }
}

TEST_P(Filter, MirroredNumbersGiveExactlyMirroredOffsets) {
    const PixelFilterSampler sampler(GetParam());
    for (int i = 1; i < 1 << 14; ++i) {
        const float u = static_cast<float>(i) / (1 << 14);
        const FilterSample a = sampler.sample(u, 0.25f);
        const FilterSample b = sampler.sample(1 - u, 0.75f);
        ASSERT_EQ(a.dx, -b.dx) << "u = " << u;
        ASSERT_EQ(a.dy, -b.dy);
        ASSERT_EQ(a.weight, b.weight);
    }
}

TEST_P(Filter, OffsetsRiseWithTheirNumbersFromRimToRim) {
    const PixelFilterSampler sampler(GetParam());
    const auto radius = static_cast<float>(filter_radius(GetParam()));
    EXPECT_EQ(sampler.sample(0, 0).dx, -radius);
    EXPECT_EQ(sampler.sample(0.5f, 0.5f).dx, 0);
    EXPECT_LE(sampler.sample(std::nextafter(1.0f, 0.0f), 0).dx, radius);

    float last = -radius;
    for (int i = 0; i < 1 << 16; ++i) {
        const float dx = sampler.sample(static_cast<float>(i) / (1 << 16), 0).dx;
        ASSERT_GE(dx, last);
        last = dx;
    }
}

TEST_P(Filter, WeightIsTheSignOfTheFilter) {
    const PixelFilter kind = GetParam();
    const PixelFilterSampler sampler(kind);
    for (int j = 0; j < 256; ++j)
        for (int i = 0; i < 256; ++i) {
            const FilterSample s =
                sampler.sample((static_cast<float>(i) + 0.5f) / 256, (static_cast<float>(j) + 0.5f) / 256);
            const double value = filter_value(kind, s.dx) * filter_value(kind, s.dy);
            ASSERT_EQ(s.weight, value < 0 ? -1 : 1) << s.dx << ", " << s.dy;
        }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Filter, testing::ValuesIn(kinds), name_of);

TEST(FilterValue, MatchesThePublishedFormulas) {
    // Mitchell and Netravali: (16 / 18) at 0, 1 / 18 at 1, and a double zero at 2.
    EXPECT_DOUBLE_EQ(filter_value(PixelFilter::mitchell, 0), 16.0 / 18);
    EXPECT_DOUBLE_EQ(filter_value(PixelFilter::mitchell, 1), 1.0 / 18);
    EXPECT_NEAR(filter_value(PixelFilter::mitchell, std::nextafter(1.0, 0.0)), 1.0 / 18, 1e-15);
    EXPECT_EQ(filter_value(PixelFilter::mitchell, 2), 0);
    EXPECT_NEAR(filter_value(PixelFilter::mitchell, -1.5), -0.03472222222222222, 1e-15);
    EXPECT_NEAR(filter_value(PixelFilter::gaussian, 0.75), std::exp(-1.125) - std::exp(-4.5), 1e-15);
    EXPECT_EQ(filter_value(PixelFilter::gaussian, 1.5), 0);
    EXPECT_EQ(filter_value(PixelFilter::tent, 0.25), 0.75);
    EXPECT_EQ(filter_value(PixelFilter::box, 0.5), 1);
    EXPECT_EQ(filter_value(PixelFilter::box, 0.51), 0);
    for (const PixelFilter kind : {PixelFilter::box, PixelFilter::tent, PixelFilter::mitchell})
        EXPECT_NEAR(integrate(kind, [&](double x) { return filter_value(kind, x); }), 1, 1e-9);
}

} // namespace
