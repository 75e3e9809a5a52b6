// The file of the ferroelectric memory.
#include "gtcalls/gts/mram_text.h"

#include <gtest/gtest.h>

#include "gtcalls/gts/family.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(MramText, HoldsTheWordsThatDifferFrom0) {
  EXPECT_EQ(FormatMram(Mram()), "oncard-mram 1\n");
  Mram mram;
  mram.Keep(0, -32768);
  mram.Keep(4095, 32767);
  mram.Keep(17, 5);
  mram.Keep(17, 0);
  mram.SetWord(3, 9);  // only in the buffer
  EXPECT_EQ(FormatMram(mram), "oncard-mram 1\n0 -32768\n4095 32767\n");
}

TEST(MramText, IsReadBack) {
  const auto mram = ParseMram("oncard-mram 1\r\n4095 -7\n\n  12\t 3", "m");
  ASSERT_TRUE(mram.ok()) << mram.error().message.en;
  EXPECT_EQ(FormatMram(mram.value()), "oncard-mram 1\n12 3\n4095 -7\n");
  EXPECT_EQ(mram.value().Word(12), 0) << "the buffer is clear";
}

TEST(MramText, EveryLineIsChecked) {
  const std::string range = "expected an address from 0 to 4095 and a value from -32768 to 32767";
  const struct {
    const char* text;
    std::string message;
  } cases[] = {
      {"", "m: this is no memory of a card: the first line must be 'oncard-mram 1'"},
      {"oncard-mram 2\n", "m: this is no memory of a card: the first line must be 'oncard-mram 1'"},
      {"oncard-mram 1\n5\n", "m:2: " + range},
      {"oncard-mram 1\n5 x\n", "m:2: " + range},
      {"oncard-mram 1\n5 1 2\n", "m:2: " + range},
      {"oncard-mram 1\n0 1\n4096 1\n", "m:3: " + range},
      {"oncard-mram 1\n-1 1\n", "m:2: " + range},
      {"oncard-mram 1\n0 32768\n", "m:2: " + range},
      {"oncard-mram 1\n7 1\n7 1\n", "m:3: address 7 already has a value"},
  };
  for (const auto& c : cases) {
    const auto mram = ParseMram(c.text, "m");
    ASSERT_FALSE(mram.ok()) << c.text;
    EXPECT_EQ(mram.error().message.en, c.message);
  }
}

TEST(MramText, AFamilyPutsItBackIntoACardOrChangesNothing) {
  const Family& family = GtsFamily();
  FamilyState state = family.new_state();
  std::get<GtsState>(state).long_vars[1] = 4;
  ASSERT_TRUE(family.restore_memory("oncard-mram 1\n2 3\n", "m", state).ok());
  EXPECT_EQ(family.memory_text(state), "oncard-mram 1\n2 3\n");
  EXPECT_EQ(std::get<GtsState>(state).long_vars[1], 4);
  EXPECT_FALSE(family.restore_memory("oncard-mram 1\n2 4\nbad\n", "m", state).ok());
  EXPECT_EQ(family.memory_text(state), "oncard-mram 1\n2 3\n");
}

}  // namespace
}  // namespace oncard::gtcalls::gts
