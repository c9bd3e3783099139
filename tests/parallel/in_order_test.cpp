// Items produced on many threads and consumed in order.

#include "parallel/in_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace glint::parallel {
namespace {

class InOrderOn : public testing::TestWithParam<int> {};

TEST_P(InOrderOn, TakesEachThingOnceInOrderAndNeverTwoAtATime) {
    TaskPool pool(GetParam());
    for (const std::size_t count : {0u, 1u, 2u, 500u}) {
        std::vector<std::size_t> taken;
        std::atomic<int> takers = 0;
        run_in_order<std::vector<std::size_t>>(
            pool, count,
            [&](std::size_t task, int worker, std::vector<std::size_t>& made) {
                ASSERT_GE(worker, 0);
                ASSERT_LT(worker, pool.threads());
                // Delay some, so that later ones finish first.
                if (task % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
                made.assign(task % 5 + 1, task);
            },
            [&](std::size_t task, const std::vector<std::size_t>& made) {
                EXPECT_EQ(++takers, 1);
                EXPECT_EQ(made, std::vector<std::size_t>(task % 5 + 1, task));
                taken.push_back(task);
                --takers;
            });
        ASSERT_EQ(taken.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(taken[i], i);
    }
}

TEST(InOrder, TakesAtOnceAndUsesAThingAgain) {
    TaskPool pool(1);
    std::size_t taken = 0;
    run_in_order<std::vector<std::size_t>>(
        pool, 200,
        [&](std::size_t task, int, std::vector<std::size_t>& made) {
            EXPECT_EQ(taken, task);
            EXPECT_EQ(made.size(), task) << "the same vector each time";
            made.push_back(task);
        },
        [&](std::size_t, const std::vector<std::size_t>&) { ++taken; });
    EXPECT_EQ(taken, 200u);
}

TEST_P(InOrderOn, ThrowsWhatMakingOrTakingThrows) {
    TaskPool pool(GetParam());
    const auto fail_at = [&](std::size_t bad_make, std::size_t bad_take) {
        std::vector<std::size_t> taken;
        bool failed = false;
        EXPECT_THROW(run_in_order<int>(
                         pool, 100,
                         [&](std::size_t task, int, int&) {
                             if (task == bad_make) throw std::runtime_error("make");
                         },
                         [&](std::size_t task, const int&) {
                             if (task == bad_take && !std::exchange(failed, true))
                                 throw std::runtime_error("take");
                             taken.push_back(task);
                         }),
                     std::runtime_error);
        return taken;
    };
    for (int round = 0; round < 50; ++round) {
        for (const std::size_t task : fail_at(5, 1000)) EXPECT_LT(task, 5u);
        EXPECT_EQ(fail_at(1000, 5), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    }
}

INSTANTIATE_TEST_SUITE_P(Threads, InOrderOn, testing::Values(1, 2, 7));

} // namespace
} // namespace glint::parallel
