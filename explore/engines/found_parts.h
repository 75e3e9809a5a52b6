// Merges the results of parts of a search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "explore/models/state_key.h"

namespace oncard::explore {

/// The union of two sorted sets of keys.
inline std::vector<StateKey> UnionOf(const std::vector<StateKey>& a,
                                     const std::vector<StateKey>& b) {
  std::vector<StateKey> both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

/// Keeps the simpler one of two failing runs, independent of their order; an empty run
/// means none.
inline void TakeSimpler(const std::vector<uint8_t>& other, std::vector<uint8_t>* failing) {
  if (other.empty()) return;
  const auto simpler = [](const auto& a, const auto& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  };
  if (failing->empty() || simpler(other, *failing)) *failing = other;
}

}  // namespace oncard::explore
