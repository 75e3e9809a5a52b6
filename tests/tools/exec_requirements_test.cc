// What a scenario requires of a host program under `oncard exec`: the client `one_thread_c` adds
// 1..100 with samples/01_sum/sum.c, in line 17.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

ProcessResult ExecSum(const std::string& scenario) {
  const ScratchFolder folder;
  folder.Write("sum.c", ReadFile(ONCARD_SOURCE_DIR "/samples/01_sum/sum.c").value());
  folder.Write("s.toml", scenario);
  return RunOncard(
      {"exec", "--scenario=s.toml", "--", ONCARD_BUILD_DIR "/tests/runtime/one_thread_c", "sum.c"},
      folder.path());
}

TEST(ExecRequirements, SaysWhatHeldAndOverWhat) {
  const ProcessResult result = ExecSum(
      "always = [\"sum <= 5050\", \"axis1.prfPos == 0\"]\nnever = [\"page0.i > 101\"]\n"
      "final = [\"sum == 5050 && thread0.result == sum\"]\neventually = [\"sum == 4950\"]\n");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(
      result.err,
      AllOf(ContainsRegex("oncard: card 0: 'always: sum <= 5050': held in all [0-9]+ states from "),
            ContainsRegex("'always: axis1.prfPos == 0': held in all [0-9]+ states from 0 ms on"),
            ContainsRegex("'never: page0.i > 101': held in none of [0-9]+ states from "),
            HasSubstr("'final: sum == 5050 && thread0.result == sum': held at the end, "),
            HasSubstr("'eventually: sum == 4950': held at "), Not(HasSubstr("does not"))));
}

TEST(ExecRequirements, SayWhatNoStatePutToTheTest) {
  const ProcessResult result = ExecSum("never = [\"sum > 6000 && sum < 7000\"]\n");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("oncard: warning: card 0: 'never: sum > 6000 && sum < 7000' was "
                        "met by its left side alone: 'sum > 6000' never held"));
}

TEST(ExecRequirements, ReportsWhatDoesNotHoldAsARunDoes) {
  const ProcessResult result = ExecSum(
      "always = [\"sum < 3\"]\nnever = [\"sum == 10\"]\nfinal = [\"sum == 5051\"]\n"
      "eventually = [\"sum == 2\"]\n");
  EXPECT_EQ(result.exit_code, 120);
  const std::string card = "oncard: card 0: '";
  EXPECT_THAT(
      result.err,
      AllOf(ContainsRegex(card + "always: sum < 3' does not hold after thread 0 has executed "
                                 "sum.c:17, at [0-9.]+ ms: sum is 3\n"),
            ContainsRegex(card + "never: sum == 10' holds after thread 0 has executed sum.c:17, at "
                                 "[0-9.]+ ms: sum is 10\n"),
            HasSubstr(card + "final: sum == 5051' does not hold at the end: sum is 5050\n"),
            HasSubstr(card + "eventually: sum == 2' held in no state of the run; at its end: sum "
                             "is 5050\n")));
}

TEST(ExecRequirements, FollowResponses) {
  const std::string good = "leads = [\"sum == 1 -> sum == 5050\"]\n";
  const ProcessResult held =
      ExecSum(good + "within = [{ after = \"sum == 1\", then = \"sum == 5050\", ms = 1000 }]\n");
  EXPECT_EQ(held.exit_code, 0) << held.err;
  EXPECT_THAT(held.err,
              AllOf(ContainsRegex("'leads: sum == 1 -> sum == 5050': held in all [0-9]+ states"),
                    ContainsRegex("'within 1000 ms: sum == 1 -> sum == 5050': held in all ")));
  const ProcessResult failed = ExecSum(
      "leads = [\"sum == 5050 -> sum == 1\"]\n"
      "within = [{ after = \"sum == 1\", then = \"sum == 5050\", ms = 0 }]\n");
  EXPECT_EQ(failed.exit_code, 120);
  EXPECT_THAT(
      failed.err,
      AllOf(HasSubstr("oncard: card 0: 'leads: sum == 5050 -> sum == 1' 'sum == 5050' held"),
            HasSubstr("and 'sum == 1' neither then nor later: sum is 5050\n"),
            HasSubstr("and 'sum == 5050' did not within 0 ms; too late at ")));
  const ProcessResult wrong = ExecSum("leads = [\"sum == 1\"]\n");
  EXPECT_THAT(wrong.err, HasSubstr("s.toml:1:10: 'sum == 1' must be two conditions with '->'"));
}

TEST(ExecRequirements, AreNotMetByAHostThatOpensNoCard) {
  const ScratchFolder folder;
  const std::string host = ONCARD_BUILD_DIR "/tests/runtime/no_card_c";
  const auto run = [&](const std::string& scenario, const char* exit_code) {
    folder.Write("s.toml", scenario);
    return RunOncard({"exec", "--scenario=s.toml", "--", host, exit_code}, folder.path());
  };
  const ProcessResult result = run("final = [\"1 == 1\"]\n", "0");
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_EQ(result.err,
            "oncard: the host has opened no card: nothing of the scenario was checked\n");
  EXPECT_EQ(run("expect = [\"1 == 1\"]\n", "0").exit_code, 120);
  EXPECT_EQ(run("expect = [\"1 == 1\"]\n", "5").exit_code, 5);
  EXPECT_EQ(run("rate = 50\n", "0").exit_code, 0) << "nothing to check";
}

TEST(ExecRequirements, RefusesToPassWhatWasNeverChecked) {
  const ProcessResult result = ExecSum("always = [\"sun <= 5050\"]\n");
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.err, HasSubstr("s.toml:1:11: card 0: never checked: nothing is named 'sun'"));
}

TEST(ExecRequirements, RefusesWhatIsNoConditionBeforeTheHostBegins) {
  const ProcessResult result = ExecSum("never = [\"sum <\"]\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("s.toml:1:10: "));
}

constexpr const char* kReactionToSum =
    "[[world.react]]\nwhen = \"sum >= 10\"\nindex = 1\nvalue = 1\n";

TEST(ExecRequirements, TheWorldReactsToTheHostsProgram) {
  const ProcessResult result = ExecSum(
      std::string("eventually = [\"gpi[1] == 1\"]\nnever = [\"gpi[1] == 1 && sum < 10\"]\n") +
      kReactionToSum);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("'eventually: gpi[1] == 1': held at "),
                                HasSubstr("'never: gpi[1] == 1 && sum < 10': held in none of ")));
}

TEST(ExecRequirements, ReportsReactionsThatNothingStarted) {
  const ProcessResult idle = ExecSum("[[world.react]]\nwhen = \"sum < 0\"\nindex = 1\nvalue = 1\n");
  EXPECT_EQ(idle.exit_code, 0) << idle.err;
  EXPECT_THAT(idle.err, HasSubstr("oncard: warning: card 0: nothing started the [[world.react]] of "
                                  "'sum < 0': it held at no boundary of profile cycles"));
  const ProcessResult unknown =
      ExecSum("[[world.react]]\nwhen = \"sun > 0\"\nindex = 1\nvalue = 1\n");
  EXPECT_EQ(unknown.exit_code, 120);
  EXPECT_THAT(unknown.err, AllOf(HasSubstr("s.toml:2:8: card 0: never looked at: nothing is named "
                                           "'sun'"),
                                 Not(HasSubstr("nothing started"))));
}

// The host is cut off: its end says nothing of what must hold at the end.
TEST(ExecRequirements, LeavesTheEndOfAHostThatIsCutOffAlone) {
  const ProcessResult result =
      ExecSum("limit_ms = 2\nalways = [\"sum <= 5050\"]\nfinal = [\"sum == 5050\"]\n");
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("the host still runs at the time limit of 2 ms"),
                    HasSubstr("'always: sum <= 5050': held in all "), Not(HasSubstr("final"))));
}

TEST(ExecRequirements, AreCheckedInTheFirstCaseOfChoices) {
  const ProcessResult result = ExecSum(
      "final = [\"gpi[1] == 1\"]\n[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [0, 1]\n");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("oncard: warning: choice: gpi[1] = 1 at 0 ms\n"));
  const ProcessResult wrong =
      ExecSum("until_ms = 5\n[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [0, 10]\n");
  EXPECT_NE(wrong.exit_code, 0);
  EXPECT_THAT(wrong.err, HasSubstr("gpi[1] comes from 0 to 10 ms, and the run ends at 5 ms"));
}

}  // namespace
}  // namespace oncard::tools
