// In which order pictures are measured.

#include "render/schedule.h"
#include "render/schedule_run.h"

#include "glint/error.h"

#include <gtest/gtest.h>

#include <bit>

namespace glint::rendering {
namespace {

TEST(Schedule, PreviewsHalveTheStepAndSamplesDouble) {
    const std::vector<Pass> expected{{4, false, 0, 0}, {2, true, 0, 0},  {1, true, 0, 0}, {1, false, 0, 1},
                                     {1, false, 1, 1}, {1, false, 2, 2}, {1, false, 4, 3}};
    EXPECT_EQ(refining_passes(4, {7}), expected);
    EXPECT_EQ(refining_passes(1, {1}), (std::vector<Pass>{{1, false, 0, 0}}));
    for (const int step : {0, -2, 3, 128}) EXPECT_THROW(refining_passes(step, {1}), Error);
}

TEST(Schedule, AdaptiveSamplesBeginWithAsManyAsThePixelsHad) {
    const std::vector<Pass> expected{{1, false, 0, 0},       {1, false, 0, 1},       {1, false, 1, 1},
                                     {1, false, 0, 2, true}, {1, false, 2, 2, true}, {1, false, 4, 3, true}};
    EXPECT_EQ(refining_passes(1, {2, 7}), expected);
    EXPECT_EQ(picture_passes({1, 16}, {}), (std::vector<Pass>{{1, false, 0, 1}, {1, false, 0, 16, true}}));
}

TEST(Schedule, PreviewsBeforeAPictureTakeAtMostASixteenthOfIt) {
    RenderOptions options;
    EXPECT_EQ(picture_passes({4}, options), (std::vector<Pass>{{1, false, 0, 4}}));
    options.coarse_first = true;
    for (const int samples : {1, 2, 3, 4, 15, 16, 1 << 20}) {
        const std::vector<Pass> passes = picture_passes({samples}, options);
        EXPECT_EQ(passes.back(), (Pass{1, false, 0, samples}));
        const int step = passes[passes.size() - 2].step;
        EXPECT_LE(16, step * step * samples) << samples;
        EXPECT_TRUE(step == 1 || step * step * samples < 64) << samples;
    }
}

TEST(Schedule, ShardsOfSamplesAreAlignedBlocksThatMakeTheWhole) {
    for (int samples = 1; samples <= 70; ++samples)
        for (int shards = 1; shards <= 9; ++shards) {
            int next = 0;
            for (int i = 0; i < shards; ++i)
                for (const Pass& pass : sample_shard(samples, {i, shards})) {
                    EXPECT_EQ(pass.first, next);
                    const auto tree = static_cast<int>(std::bit_ceil(static_cast<unsigned>(pass.count)));
                    EXPECT_EQ(pass.first % tree, 0);
                    next = pass.first + pass.count;
                    EXPECT_TRUE(pass.count == tree || next == samples);
                }
            EXPECT_EQ(next, samples);
        }
    EXPECT_TRUE(sample_shard(1 << 20, {(1 << 30), 1 << 30}).empty());
}

TEST(Schedule, TilesCoverTheAreaOnce) {
    const TileGrid grid(21, 13, 8);
    ASSERT_EQ(grid.count(), 6u);
    int pixels = 0;
    for (std::size_t i = 0; i < grid.count(); ++i) pixels += grid.tile(i).width * grid.tile(i).height;
    EXPECT_EQ(pixels, 21 * 13);
    EXPECT_EQ(grid.tile(5).x, 16);
    EXPECT_EQ(grid.tile(5).y, 8);
    EXPECT_EQ(grid.tile(5).width, 5);
    EXPECT_EQ(grid.tile(5).height, 5);
}

TEST(Schedule, TheCursorCountsWorkBySamples) {
    ScheduleCursor cursor(refining_passes(2, {2}));
    EXPECT_EQ(cursor.reached(0).step, 0);
    EXPECT_EQ(cursor.reached(0).fraction, 0);
    const double all = 0.25 + 0.75 + 1 + 1;
    EXPECT_DOUBLE_EQ(cursor.reached(0.5).fraction, 0.125 / all);
    cursor.next();
    EXPECT_EQ(cursor.reached(0).step, 2);
    EXPECT_DOUBLE_EQ(cursor.reached(1).fraction, 1 / all);
    cursor.next();
    cursor.next();
    EXPECT_EQ(cursor.reached(0).samples, 1);
    EXPECT_FALSE(cursor.reached(0).finished);
    cursor.next();
    EXPECT_TRUE(cursor.reached(0).finished);
    EXPECT_EQ(cursor.reached(0).samples, 2);
    EXPECT_EQ(cursor.reached(0).fraction, 1);
}

/// Three tiles a pass, each of two units, of which a step does one.
struct SteppingExecutor {
    parallel::TaskPool threads{1};
    std::vector<std::size_t> steps; ///< their tiles

    parallel::TaskPool& pool() { return threads; }
    std::vector<std::uint32_t> begin_pass(const Pass&) { return {2, 2, 2}; }
    std::uint32_t step(std::size_t tile, int) {
        steps.push_back(tile);
        return 1;
    }
    void end_pass() {}
    RayCounts rays(int) const {
        RayCounts rays;
        rays.primary = steps.size();
        return rays;
    }
};

TEST(ScheduleRun, EndsTheFirstPassAndLaterMakesOneStepAtLeast) {
    SteppingExecutor executor;
    ScheduleRun run(executor, refining_passes(2, {1}));
    run.run(0);
    EXPECT_EQ(executor.steps, (std::vector<std::size_t>{0, 0, 1, 1, 2, 2}));
    EXPECT_EQ(run.reached().step, 2);
    run.run(0);
    EXPECT_EQ(executor.steps.size(), 7u);
    EXPECT_EQ(run.reached().step, 2);
    EXPECT_FALSE(run.is_finished());
    run.run(no_deadline);
    EXPECT_EQ(executor.steps.size(), 12u);
    EXPECT_TRUE(run.reached().finished);
    EXPECT_EQ(run.reached().rays, 12u);
    RenderStats stats;
    run.add_stats(stats);
    EXPECT_EQ(stats.primary_rays, 12u);
    EXPECT_EQ(stats.threads, 1);
}

TEST(ScheduleRun, GoesOnWithinATileThatWasCancelled) {
    SteppingExecutor executor;
    CancelFlag cancel{false};
    Progress last;
    ScheduleRun run(executor, picture_passes({1}, {}), &cancel, [&](const Progress& progress) {
        last = progress;
        cancel = executor.steps.size() == 3;
    });
    run.run(no_deadline);
    EXPECT_EQ(executor.steps, (std::vector<std::size_t>{0, 0, 1}));
    EXPECT_EQ(last.tiles_done, 3u);
    EXPECT_EQ(last.tiles, 6u);
    EXPECT_FALSE(run.is_finished());
    EXPECT_EQ(run.reached().fraction, 0.5);
    cancel = false;
    run.run(no_deadline);
    EXPECT_EQ(executor.steps, (std::vector<std::size_t>{0, 0, 1, 1, 2, 2}));
    EXPECT_TRUE(run.is_finished());
    EXPECT_EQ(last.tiles_done, last.tiles);
}

} // namespace
} // namespace glint::rendering
