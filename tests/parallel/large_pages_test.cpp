#include "parallel/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

namespace glint {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21U;

/// Counts up from `first`.
std::vector<std::uint32_t> counted(std::size_t size, std::uint32_t first) {
    std::vector<std::uint32_t> values(size);
    std::iota(values.begin(), values.end(), first);
    return values;
}

TEST(PageArena, KeepsArraysApart) {
    PageArena arena(100000);
    std::vector<std::span<const std::uint32_t>> copies;
    for (std::uint32_t i = 0; i < 100; ++i) copies.push_back(arena.copy(counted(i * i * i / 2, i)));
    const auto bytes = arena.copy(std::vector<std::uint8_t>{1, 2, 3});
    const auto doubles = arena.copy(std::vector<double>{0.5, 0.25});
    for (std::uint32_t i = 0; i < 100; ++i) {
        ASSERT_EQ(copies[i].size(), i * i * i / 2);
        EXPECT_TRUE(std::equal(copies[i].begin(), copies[i].end(), counted(i * i * i / 2, i).begin())) << i;
    }
    EXPECT_EQ(bytes[2], 3);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(doubles.data()) % alignof(double), 0u);
    EXPECT_EQ(doubles[1], 0.25);
}

TEST(PageArena, CanBeUsedAgain) {
    PageArena arena(0);
    for (std::uint32_t round = 0; round < 4; ++round) {
        const auto copy = arena.copy(counted(large_page / 2, round));
        EXPECT_EQ(copy.front(), round);
        EXPECT_EQ(copy.back(), round + large_page / 2 - 1);
        arena.clear();
    }
}

TEST(LargeVector, BeginsWithALargePageWhereItIsLong) {
    const LargeVector<std::uint32_t> values(3 * large_page / 4 + 5, 7u);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(values.data()) % large_page, 0u);
    EXPECT_EQ(std::accumulate(values.begin(), values.end(), std::size_t{0}), 7 * values.size());
}

TEST(LargeVector, GrowsAsAVectorDoes) {
    LargeVector<std::uint32_t> values;
    for (std::uint32_t i = 0; i < 2000000; ++i) values.push_back(i);
    values.resize(3000000);
    values.resize(3000001, 9u);
    for (std::uint32_t i = 0; i < 2000000; i += 997) ASSERT_EQ(values[i], i);
    EXPECT_EQ(values.back(), 9u);
    const LargeVector<std::uint32_t> copy = values;
    EXPECT_TRUE(std::equal(copy.begin(), copy.begin() + 2000000, values.begin()));
    values = LargeVector<std::uint32_t>{};
    EXPECT_TRUE(values.empty());
}

} // namespace
} // namespace glint
