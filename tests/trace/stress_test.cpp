// Some cases of every stress family; glint-stress runs more.

#include "cases.h"

#include "parallel/task_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <string>

namespace glint::stress {
namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GLINT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GLINT_SANITIZED
#endif

#ifdef GLINT_SANITIZED
constexpr std::uint64_t cases = 6;
#else
constexpr std::uint64_t cases = 120;
#endif
constexpr std::uint32_t rays_a_case = 12288;

class Stress : public testing::TestWithParam<Family> {};

TEST_P(Stress, FindsNothing) {
    const Family family = GetParam();
    parallel::TaskPool pool;
    std::mutex mutex;
    Tally total;
    pool.run(cases, [&](std::size_t index, int) {
        const std::uint64_t seed = case_seed(2024, index);
        const Tally tally = family.run(seed, rays_a_case);
        const std::lock_guard lock(mutex);
        total.add(tally);
        EXPECT_EQ(tally.failures, 0u) << tally.first_failure << "\nagain: glint-stress --family "
                                      << family.name << " --replay " << seed;
    });
    EXPECT_GE(total.rays, cases * rays_a_case * 9 / 10);
    for (std::size_t variant = 0; variant < kernel_variants().size() && family.property <= Property::closed;
         ++variant)
        EXPECT_GE(total.by_variant[variant], cases * rays_a_case / 20) << kernel_variants()[variant].name;
    EXPECT_GT(total.hits, total.rays / 20) << "the rays miss everything";
    if (family.property == Property::closed || family.property == Property::crosses) {
        EXPECT_GT(total.on_edge, total.rays / 100) << "no ray meets an edge";
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Stress, testing::ValuesIn(families().begin(), families().end()),
                         [](const auto& family) {
                             std::string name = family.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace glint::stress
