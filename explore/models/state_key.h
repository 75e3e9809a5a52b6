// 128-bit keys of states.
#pragma once

#include <compare>
#include <cstdint>

namespace oncard::explore {

/// The exclusive or of the results of AddToKey() for (place, value) pairs: equal sets of pairs have
/// equal keys, and different sets have different keys for all practical purposes.
struct StateKey {
  uint64_t low = 0;
  uint64_t high = 0;
  auto operator<=>(const StateKey&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// The key of two sets without common pairs, or of one without another that it contains.
constexpr StateKey operator^(StateKey a, StateKey b) { return {a.low ^ b.low, a.high ^ b.high}; }

/// Sums of keys, for sets that can contain the same key several times.
constexpr StateKey operator+(StateKey a, StateKey b) { return {a.low + b.low, a.high + b.high}; }
constexpr StateKey operator-(StateKey a, StateKey b) { return {a.low - b.low, a.high - b.high}; }

/// Scrambles a value at a place into 64 bits (the finaliser of MurmurHash3 over a Weyl step).
constexpr uint64_t MixPlace(uint64_t seed, uint32_t place, int64_t value) {
  uint64_t x = static_cast<uint64_t>(value) + seed * (uint64_t{place} + 1);
  x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
  x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

/// Adds a pair, or removes it again.
constexpr void AddToKey(uint32_t place, int64_t value, StateKey* key) {
  key->low ^= MixPlace(0x9e3779b97f4a7c15ULL, place, value);
  key->high ^= MixPlace(0xd1b54a32d192ed03ULL, place, value);
}

}  // namespace oncard::explore
