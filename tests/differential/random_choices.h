// Random choices for generators of programs, the same with every standard library.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <string_view>

namespace oncard::differential {

class RandomChoices {
 public:
  explicit RandomChoices(uint64_t seed) : random_(seed) {}

  /// A number from `low` to `high`, both included.
  int Between(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<uint64_t>(high - low + 1));
  }
  /// Any 64 bits.
  uint64_t Bits() { return random_(); }
  /// True in so many of a hundred cases.
  bool Chance(int percent) { return Between(1, 100) <= percent; }
  /// One of the texts.
  std::string Pick(std::initializer_list<std::string_view> from) {
    return std::string(from.begin()[Between(0, static_cast<int>(from.size()) - 1)]);
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace oncard::differential
