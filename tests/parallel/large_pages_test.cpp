#include "parallel/large_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace glint::parallel {
namespace {

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

TEST(LargeVector, ReturnsItsRoomAndGrowsIntoItAgain) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, large_page / 8 + 3, large_page}) {
        LargeVector<std::uint32_t> values;
        values.reserve(3 * large_page);
        values.resize(size, 7u);
        const std::uint32_t* const begin = values.data();
        return_unused(values);
        EXPECT_EQ(values.capacity(), 3 * large_page);
        values.resize(size + large_page, 9u);
        EXPECT_EQ(values.data(), begin);
        EXPECT_EQ(std::count(values.begin(), values.end(), 7u), static_cast<std::ptrdiff_t>(size));
        EXPECT_EQ(std::count(values.begin(), values.end(), 9u), static_cast<std::ptrdiff_t>(large_page));
    }
}

} // namespace
} // namespace glint::parallel
