// Keys of states that are sequences of words. Not for headers: the libraries that use it link
// xxhash.
#pragma once

// The keys are short, so that a call would take as long as the work.
#ifndef XXH_INLINE_ALL
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <cstdint>
#include <span>
#include <vector>

#include "explore/models/state_key.h"

namespace oncard::explore {

/// Equal sequences with the same number have equal keys, and others have different keys for all
/// practical purposes.
template <typename Word>
StateKey KeyOfWords(std::span<const Word> words, uint64_t number = 0) {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(words.data(), words.size_bytes(), number);
  return {hash.low64, hash.high64};
}
template <typename Word>
StateKey KeyOfWords(const std::vector<Word>& words) {
  return KeyOfWords(std::span(words));
}

}  // namespace oncard::explore
