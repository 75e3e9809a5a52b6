// Keys of states that are sequences of words. Not for headers: the libraries that use it link
// xxhash.
#pragma once

#include <xxhash.h>

#include <vector>

#include "explore/models/state_key.h"

namespace oncard::explore {

/// Equal sequences have equal keys, and different ones have different keys for all practical
/// purposes.
template <typename Word>
StateKey KeyOfWords(const std::vector<Word>& words) {
  const XXH128_hash_t hash = XXH3_128bits(words.data(), words.size() * sizeof(Word));
  return {hash.low64, hash.high64};
}

}  // namespace oncard::explore
