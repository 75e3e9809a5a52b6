// Requirements in words (explore/reports/requirement_words.h).
#include "explore/reports/requirement_words.h"

#include <gtest/gtest.h>

namespace oncard::explore {
namespace {

using runtime::Scope;

TEST(RequirementWords, SayWhatIsAsked) {
  EXPECT_EQ(InWords({Scope::kFinal, "x == 1"}).en, "at the end of every run x == 1 holds");
  EXPECT_EQ(InWords({Scope::kAlways, "x == 1"}).en, "x == 1 holds in every state");
  EXPECT_EQ(InWords({Scope::kNever, "x == 1"}).zh, "x == 1 在任何状态下都不成立");
  EXPECT_EQ(InWords({Scope::kEventually, "x == 1"}).en, "in every run x == 1 holds at some time");
  EXPECT_EQ(InWords({.scope = Scope::kLeads, .text = "p", .then = "q"}).en,
            "whenever p holds, q holds then or later");
  const runtime::Requirement within = {
      .scope = Scope::kWithin, .text = "p", .then = "q", .within_us = 2500};
  EXPECT_EQ(InWords(within).en, "whenever p holds, q holds then or at most 2.5 ms later");
  EXPECT_EQ(InWords(within).zh, "每当 p 成立，此时或至多 2.5 ms 之后 q 成立");
  EXPECT_EQ(InWords({.scope = Scope::kAssert, .text = "x < 3", .at = "pick.c:31"}).en,
            "x < 3 holds whenever a thread is about to execute the statement at pick.c:31");
}

}  // namespace
}  // namespace oncard::explore
