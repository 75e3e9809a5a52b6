// Sets of numbered keys (explore/models/key_set.h).
#include "explore/models/key_set.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace oncard::explore {
namespace {

/// Adds the keys, each several times, and compares with a map.
void ExpectNumbers(const std::vector<StateKey>& keys) {
  KeySet set;
  std::map<StateKey, uint32_t> numbers;
  std::vector<StateKey> in_order;
  for (int round = 0; round < 2; ++round) {
    for (const StateKey key : keys) {
      const auto [known, is_new] = numbers.try_emplace(key, static_cast<uint32_t>(numbers.size()));
      if (is_new) in_order.push_back(key);
      bool added = false;
      set.Prefetch(key);
      ASSERT_EQ(set.FindOrAdd(key, &added), known->second);
      ASSERT_EQ(added, is_new);
    }
  }
  EXPECT_EQ(set.size(), numbers.size());
  EXPECT_EQ(set.Keys(), in_order);
}

TEST(KeySetTest, NumbersKeysInTheOrderInWhichTheyAreAdded) {
  std::mt19937_64 random(5);
  std::vector<StateKey> keys;
  for (int i = 0; i < 100'000; ++i) keys.push_back({random(), random()});
  for (size_t i = 0; i < 1000; ++i) keys.push_back(keys[i * 7]);
  ExpectNumbers(keys);
}

// Keys that belong in one line, the last one of the table among them, and those that differ in one
// half only.
TEST(KeySetTest, KeysWithTheSamePlaceAreDifferent) {
  std::vector<StateKey> keys;
  for (uint64_t i = 0; i < 500; ++i) {
    keys.push_back({i, 0});
    keys.push_back({0, i});
    keys.push_back({~uint64_t{0}, i});
    keys.push_back({~uint64_t{0} - i, ~uint64_t{0}});
  }
  ExpectNumbers(keys);
}

TEST(KeySetTest, InsertTellsNewKeys) {
  KeySet set;
  EXPECT_TRUE(set.Insert({0, 0}));
  EXPECT_FALSE(set.Insert({0, 0}));
  EXPECT_TRUE(set.Insert({0, 1}));
}

}  // namespace
}  // namespace oncard::explore
