// oncard debug: the session protocol on the standard streams; its requests are tested by
// tests/session/host_test.cc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(DebugCommand, AnswersEachLineAndReadsFiles) {
  const ScratchFolder scratch;
  scratch.Write("p.c", "int x;\nint f()\n{\n  x = 5;\n  return x;\n}\n");
  scratch.Write("requests",
                "{\"id\":1,\"request\":\"load\",\"arguments\":{\"main\":\"p.c\"}}\n\n"
                "{\"id\":2,\"request\":\"forward\",\"arguments\":{\"goal\":\"stop\"}}\n");
  const ProcessResult result = RunProgram(
      {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard debug --stdio < requests"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, StartsWith(R"({"id":1,"ok":true,"result":{"compiled":true)"));
  EXPECT_THAT(result.out,
              HasSubstr("\n{\"id\":2,\"ok\":true,\"result\":{\"stop\":{\"reason\":\"end\","));
}

TEST(DebugCommand, WalksACounterexampleOfTheExplorer) {
  const ScratchFolder scratch;
  scratch.Write("p.c",
                "int x;\nint f()\n{\n  int a;\n  a = x;\n  a = a + 1;\n  x = a;\n  return 0;\n}\n");
  scratch.Write("p.toml",
                "program = \"p.c\"\nfinal = [\"x == 2\"]\n[[thread]]\nfunction = \"f\"\n"
                "[[thread]]\nthread = 1\nfunction = \"f\"\n");
  RunOncard({"explore", "p.toml", "--save", "lost.schedule"}, scratch.path());
  scratch.Write("requests",
                "{\"request\":\"load\",\"arguments\":{\"main\":\"lost.schedule\"}}\n"
                "{\"request\":\"forward\",\"arguments\":{\"goal\":\"stop\"}}\n");
  const ProcessResult result = RunProgram(
      {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard debug --stdio < requests"}, scratch.path());
  EXPECT_THAT(result.out, HasSubstr("\"follows_schedule\":true"));
  EXPECT_THAT(result.out, HasSubstr("\"failed\":[\"final: x == 2 does not hold: x is 1\"]"));
}

TEST(DebugCommand, TakesTheThreadsAndRequirementsOfASourceFromItsComments) {
  const ScratchFolder scratch;
  scratch.Write(
      "p.c", "//@ final: x == 3\nint x;\nvoid t0()\n{\n  x = 1;\n}\nvoid t1()\n{\n  x = 2;\n}\n");
  scratch.Write("requests",
                "{\"request\":\"load\",\"arguments\":{\"main\":\"p.c\"}}\n"
                "{\"request\":\"forward\",\"arguments\":{\"goal\":\"stop\"}}\n");
  const ProcessResult result = RunProgram(
      {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard debug --stdio < requests"}, scratch.path());
  EXPECT_THAT(result.out, HasSubstr("\"thread\":1,\"function\":\"t1\""));
  EXPECT_THAT(result.out, HasSubstr("\"failed\":[\"final: x == 3 does not hold: x is 2\"]"));
}

TEST(DebugCommand, NeedsItsStreams) {
  const ProcessResult result = RunOncard({"debug"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("--stdio"));
}

}  // namespace
}  // namespace oncard::tools
