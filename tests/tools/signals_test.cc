// Commands that are stopped by a signal keep their results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

using Json = nlohmann::json;

// Counts forever; its trace has a row for every cycle.
constexpr const char* kCounts = "int n;\nint f()\n{\nlbl:\n  n = n + 1;\n  goto lbl;\n}\n";

class SignalTest : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { scratch_.Write("p.c", kCounts); }
  ScratchFolder scratch_;
};

TEST_P(SignalTest, ARunKeepsItsTraceAndItsRecord) {
  const ProcessResult run = InterruptOncard(
      {"run", "p.c", "--limit=1000000000", "--trace=t.csv", "--record=r.schedule", "--format=json"},
      GetParam(), scratch_.path());
  EXPECT_EQ(run.exit_code, 6) << run.err;
  EXPECT_THAT(run.err, HasSubstr("interrupted at "));
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["end"], "interrupted");
  EXPECT_THAT(scratch_.Read("t.csv"), HasSubstr("time_ms,n,gpo\n0,0,0\n"));
  const ProcessResult replay =
      RunOncard({"replay", "r.schedule", "--format=json"}, scratch_.path());
  // The replay also ends there, in the same state, and gives the reason.
  EXPECT_EQ(replay.exit_code, 6);
  EXPECT_THAT(replay.err, HasSubstr("warning: the recording ends at "));
  EXPECT_EQ(Json::parse(replay.out)["failures"], Json::array());
  for (const char* key : {"end", "time_ms", "statements", "state_hash"}) {
    EXPECT_EQ(Json::parse(replay.out)[key], json[key]) << key;
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, SignalTest, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace oncard::tools
