// Which globals threads only add to.
#include "explore/models/added_globals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The slots of `a`, `b`, `c` (0, 1, 2) and the rest to which threads with these statements only
/// add.
std::vector<uint16_t> AddedIn(const std::string& statements, size_t threads = 2) {
  const CardModel model = CardOf(
      "int a;\nint b;\nint c;\nint t[2];\ndouble d;\nTTrapPrm trap;\n"
      "int t0() { int n; " +
          statements + " return 0; }\n",
      {});
  return GlobalsOnlyAddedTo(model.image()->object,
                            std::vector<ThreadSetup>(threads, model.setup(0)));
}

TEST(AddedGlobals, AreIntsThatOnlySumsName) {
  EXPECT_THAT(AddedIn("a = a + 1; b = 2 + b; c = c - n;"), ElementsAre(0, 1, 2));
  EXPECT_THAT(AddedIn("a = a + t[1]; a = a - t[n]; b = 1; c = 1;"), ElementsAre(0));
}

// What a single thread sets is its own.
TEST(AddedGlobals, AreThoseOfSeveralThreads) {
  EXPECT_THAT(AddedIn("a = a + 1;", 1), IsEmpty());
  EXPECT_THAT(AddedIn("a = a + 1;", 3), ElementsAre(0));
}

TEST(AddedGlobals, AreNotReadOtherwise) {
  EXPECT_THAT(AddedIn("a = a + 1; n = a; b = b + c;"), ElementsAre(1));
  EXPECT_THAT(AddedIn("a = a + 1; if (a) goto L; L: b = b + a;"), ElementsAre(1));
  EXPECT_THAT(AddedIn("GT_GetDi(4, &a); n = t[b]; return c;"), IsEmpty());
}

TEST(AddedGlobals, HaveNoOtherOperators) {
  EXPECT_THAT(AddedIn("a = 1 - a; b = b * 2; c = c + c;"), IsEmpty());
  EXPECT_THAT(AddedIn("a = b + 1; c = c - c;"), IsEmpty());
  EXPECT_THAT(AddedIn("a = a + b; b = b + a;"), IsEmpty());
}

TEST(AddedGlobals, AreNoPartsOfSomething) {
  EXPECT_THAT(AddedIn("t[1] = t[1] + 1; d = d + 1.0; a = 1; b = 1; c = 1;"), IsEmpty());
}

}  // namespace
}  // namespace oncard::explore
