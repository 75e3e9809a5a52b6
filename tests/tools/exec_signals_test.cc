// Signal handlers of host programs that call the card and read clocks (clients/interrupted.c).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::StartsWith;

/// Runs the client in virtual time or, without `oncard exec`, by the wall clock.
ProcessResult Interrupt(bool virtual_time, const std::string& mode, int signals) {
  const std::string client = ONCARD_BUILD_DIR "/tests/runtime/interrupted";
  std::vector<std::string> command = {client, mode, std::to_string(signals)};
  if (!virtual_time) return RunProgram(command);
  command.insert(command.begin(), {"exec", "--"});
  return RunOncard(command);
}

class ExecHandlerTest : public testing::TestWithParam<bool> {};

TEST_P(ExecHandlerTest, StopsAnAxisBetweenTwoCalls) {
  const ProcessResult result = Interrupt(GetParam(), "stop", 300);
  EXPECT_EQ(result.out, "300 handled, unexpected 0, none refused\n") << result.exit_code;
  EXPECT_EQ(result.err, "");
}

TEST_P(ExecHandlerTest, ClosesTheCardBetweenTwoCalls) {
  const ProcessResult result = Interrupt(GetParam(), "close", 100);
  EXPECT_EQ(result.out, "100 handled, unexpected 0, none refused\n") << result.exit_code;
}

TEST_P(ExecHandlerTest, EndsTheHost) {
  for (const int signals : {1, 1, 1, 1, 1, 20}) {
    EXPECT_EQ(Interrupt(GetParam(), "exit", signals).exit_code, 3);
  }
}

// The other thread has the card, and waits until the interrupted wait is over.
TEST_P(ExecHandlerTest, CallsACardThatAnotherThreadHas) {
  const ProcessResult result = Interrupt(GetParam(), "wait", 30);
  EXPECT_EQ(result.out, "30 handled, unexpected 0, none refused\n") << result.exit_code;
}

// All locks are taken for fork().
TEST_P(ExecHandlerTest, StopsAnAxisWhileTheHostForks) {
  const ProcessResult result = Interrupt(GetParam(), "fork", 300);
  EXPECT_EQ(result.out, "300 handled, unexpected 0, none refused\n") << result.exit_code;
}

TEST_P(ExecHandlerTest, ReadsClocksAndSleeps) {
  const ProcessResult result = Interrupt(GetParam(), "clock", 300);
  EXPECT_EQ(result.out, "300 handled, unexpected 0, none refused\n") << result.exit_code;
}

TEST_P(ExecHandlerTest, EndsSleeps) { EXPECT_EQ(Interrupt(GetParam(), "sleep", 0).exit_code, 0); }

// As Sleep() of compat/windows.h does; what is left of such a sleep is slept after the handler.
TEST(ExecRealSleepTest, LetsHandlersRun) { EXPECT_EQ(Interrupt(false, "nap", 5).exit_code, 3); }

TEST_P(ExecHandlerTest, IsRefusedWhereTheSignalCannotWait) {
  const ProcessResult result = Interrupt(GetParam(), "direct", 300);
  EXPECT_EQ(result.out, "300 handled, unexpected 0, some refused\n") << result.exit_code;
  EXPECT_THAT(result.err, StartsWith("oncard: GT_Stop is refused: the signal handler that calls it "
                                     "has interrupted another call of its thread\n"));
}

INSTANTIATE_TEST_SUITE_P(Clocks, ExecHandlerTest, testing::Bool(), [](const auto& is_virtual) {
  return std::string(is_virtual.param ? "Virtual" : "Real");
});

}  // namespace
}  // namespace oncard::tools
