// The pool runs exactly the requested number of threads, uses all and joins all.

#include "parallel/resources.h"
#include "parallel/task_pool.h"

#include <gtest/gtest.h>

#include <sched.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace glint::parallel {
namespace {

class TaskPoolOf : public testing::TestWithParam<int> {};

TEST_P(TaskPoolOf, RunsEveryTaskOnce) {
    TaskPool pool(GetParam());
    EXPECT_EQ(pool.threads(), GetParam());
    for (const std::size_t count : {0u, 1u, 2u, 63u, 1000u}) {
        std::vector<std::atomic<int>> runs(count);
        pool.run(count, [&](std::size_t task, int worker) {
            ASSERT_GE(worker, 0);
            ASSERT_LT(worker, GetParam());
            ++runs[task];
        });
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(runs[i], 1) << "task " << i << " of " << count;
    }
}

TEST_P(TaskPoolOf, StartsEveryWorkerWithItsOwnTask) {
    TaskPool pool(GetParam());
    const std::size_t count = static_cast<std::size_t>(GetParam());
    std::vector<int> worker_of(count, -1);
    std::vector<std::thread::id> thread_of(count);
    pool.run(count, [&](std::size_t task, int worker) {
        worker_of[task] = worker;
        thread_of[task] = std::this_thread::get_id();
    });
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(worker_of[i], static_cast<int>(i));
    EXPECT_EQ(std::set(thread_of.begin(), thread_of.end()).size(), count)
        << "a thread took two workers' parts";
    EXPECT_EQ(thread_of[0], std::this_thread::get_id()) << "worker 0 is the caller";
}

TEST_P(TaskPoolOf, ThrowsTheExceptionOfATaskAndWorksOn) {
    TaskPool pool(GetParam());
    for (int round = 0; round < 20; ++round) {
        try {
            pool.run(100, [](std::size_t task, int) {
                if (task == 3) throw std::runtime_error("task 3");
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "task 3");
        }
        std::atomic<int> runs = 0;
        pool.run(100, [&](std::size_t, int) { ++runs; });
        EXPECT_EQ(runs, 100);
    }
}

TEST_P(TaskPoolOf, HandsOutNothingAfterAnException) {
    TaskPool pool(GetParam());
    std::atomic<std::size_t> runs = 0;
    const std::size_t count = 1'000'000;
    EXPECT_THROW(pool.run(count,
                          [&](std::size_t, int) {
                              ++runs;
                              throw std::runtime_error("no more");
                          }),
                 std::runtime_error);
    EXPECT_LE(runs, static_cast<std::size_t>(GetParam())) << "each worker fails at its first task";
}

TEST_P(TaskPoolOf, SurvivesManyShortJobs) {
    TaskPool pool(GetParam());
    std::uint64_t sum = 0;
    std::vector<std::uint64_t> parts(8);
    for (int job = 0; job < 500; ++job) {
        pool.run(parts.size(), [&](std::size_t task, int) { parts[task] = task + 1; });
        for (std::uint64_t& part : parts) sum += std::exchange(part, 0);
    }
    EXPECT_EQ(sum, 500u * 36u);
}

INSTANTIATE_TEST_SUITE_P(Threads, TaskPoolOf, testing::Values(1, 2, 7, 64),
                         [](const auto& threads) { return std::to_string(threads.param); });

TEST(TaskPool, HasOneThreadForEachCoreUnlessToldOtherwise) {
    EXPECT_GE(available_threads(), 1);
    EXPECT_EQ(TaskPool().threads(), available_threads());
}

TEST(TaskPool, UsesOnlyTheProcessorsThatItMay) {
    int threads = 0;
    std::thread([&] {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<unsigned>(::sched_getcpu()), &one);
        if (::sched_setaffinity(0, sizeof one, &one) == 0) threads = available_threads();
    }).join();
    EXPECT_EQ(threads, 1);
}

} // namespace
} // namespace glint::parallel
