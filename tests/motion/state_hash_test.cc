// The hash of values, which are added in pieces, is that of all their bytes.
#include "motion/common/state_hash.h"

#include <gtest/gtest.h>

namespace oncard::motion {
namespace {

TEST(StateHash, IsThatOfTheBytesOfAllValues) {
  for (const size_t count : {0u, 1u, 127u, 128u, 129u, 300u}) {
    StateHash hash;
    StateWords words;
    std::vector<unsigned char> bytes;
    for (size_t i = 0; i < count; ++i) {
      const uint64_t value = 0x0123456789abcdefULL + i;
      hash.Add(value);
      words.Add(value);
      for (unsigned byte = 0; byte < 8; ++byte) {
        bytes.push_back(static_cast<unsigned char>(value >> (8 * byte)));
      }
    }
    EXPECT_EQ(hash.value(), XXH64(bytes.data(), bytes.size(), 0)) << count;
    // To ask for it changes nothing.
    EXPECT_EQ(hash.value(), XXH64(bytes.data(), bytes.size(), 0)) << count;
    EXPECT_EQ(words.words().size(), count);
  }
}

}  // namespace
}  // namespace oncard::motion
