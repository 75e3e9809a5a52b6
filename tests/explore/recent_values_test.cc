// A small table of what was looked up last (explore/models/recent_values.h).
#include "explore/models/recent_values.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace oncard::explore {
namespace {

using Numbers = RecentValues<uint64_t>::Numbers;

TEST(RecentValuesTest, AsksOnceForWhatIsLookedUpAgain) {
  RecentValues<uint64_t> recent;
  const uint64_t value = 42;
  int asked = 0;
  const auto find = [&]() -> const uint64_t& {
    ++asked;
    return value;
  };
  EXPECT_EQ(&recent.Of({1, 2, 3, 4}, find), &value);
  EXPECT_EQ(&recent.Of({1, 2, 3, 4}, find), &value);
  EXPECT_EQ(asked, 1);
}

TEST(RecentValuesTest, NeverGivesTheValueOfOtherNumbers) {
  RecentValues<uint64_t> recent;
  std::map<Numbers, uint64_t> values;
  std::mt19937 random(1);
  for (int i = 0; i < 100'000; ++i) {
    // Many more than there is room for, and some with a zero at each place.
    Numbers numbers;
    for (uint32_t& number : numbers) number = static_cast<uint32_t>(random() % 20);
    const auto [place, added] = values.try_emplace(numbers, values.size());
    const uint64_t& value = place->second;
    EXPECT_EQ(recent.Of(numbers, [&]() -> const uint64_t& { return value; }), value);
  }
}

}  // namespace
}  // namespace oncard::explore
