// Arrays for large tables (base/large_array.h).
#include "base/large_array.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

namespace oncard {
namespace {

using testing::Each;
using testing::ElementsAre;

// From the heap, into large pages, and from these into more of them.
TEST(LargeArrayTest, KeepsElementsWhileItGrowsAndBeginsNewOnesAsZero) {
  constexpr size_t kPage = (size_t{2} << 20) / sizeof(uint64_t);
  LargeArray<uint64_t> array(3);
  size_t before = 0;
  for (const size_t size : {size_t{3}, size_t{1000}, kPage - 1, kPage, kPage + 1, 7 * kPage / 2,
                            4 * kPage, 4 * kPage + 1}) {
    array.Grow(size);
    ASSERT_EQ(array.size(), size);
    for (size_t i = 0; i < before; ++i) ASSERT_EQ(array[i], i + 1) << size;
    for (size_t i = before; i < size; ++i) {
      ASSERT_EQ(array[i], 0u) << size;
      array[i] = i + 1;
    }
    before = size;
  }
}

TEST(LargeArrayTest, AppendsValues) {
  LargeArray<uint32_t> array;
  EXPECT_EQ(array.size(), 0u);
  array.Append(1, 5);
  array.Append(3, 6);
  EXPECT_THAT(array, ElementsAre(5, 6, 6, 6));
  array.Append(2'000'000, 7);
  EXPECT_EQ(array.size(), 2'000'004u);
  EXPECT_EQ(array[3], 6u);
  EXPECT_EQ(array[4], 7u);
  EXPECT_EQ(array[2'000'003], 7u);
}

TEST(LargeArrayTest, IsMovedWithItsElements) {
  LargeArray<uint32_t> array;
  array.Append(2, 5);
  LargeArray<uint32_t> other = std::move(array);
  EXPECT_THAT(other, ElementsAre(5, 5));
  other = LargeArray<uint32_t>(1'000'000);
  EXPECT_EQ(other.size(), 1'000'000u);
  EXPECT_THAT(other, Each(0u));
}

TEST(LargeArrayTest, ComparesElements) {
  LargeArray<uint32_t> a;
  LargeArray<uint32_t> b;
  EXPECT_TRUE(a == b);
  a.Append(2, 5);
  EXPECT_FALSE(a == b);
  b.Append(1, 5);
  b.Append(1, 5);
  EXPECT_TRUE(a == b);
}

}  // namespace
}  // namespace oncard
