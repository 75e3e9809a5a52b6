// Keys of states that are sequences of words. Not for headers: the libraries that use it link
// xxhash.
#pragma once

#include <xxhash.h>

#include <span>
#include <vector>

#include "explore/models/state_key.h"

namespace oncard::explore {

/// Equal sequences have equal keys, and different ones have different keys for all practical
/// purposes.
template <typename Word>
StateKey KeyOfWords(std::span<const Word> words) {
  const XXH128_hash_t hash = XXH3_128bits(words.data(), words.size_bytes());
  return {hash.low64, hash.high64};
}
template <typename Word>
StateKey KeyOfWords(const std::vector<Word>& words) {
  return KeyOfWords(std::span(words));
}

}  // namespace oncard::explore
