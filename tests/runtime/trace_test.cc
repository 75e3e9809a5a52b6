#include "runtime/observe/trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/motion/change_state.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Trace TraceOf(const std::string& program, const std::string& scenario,
              const std::vector<std::string>& show = {}) {
  RunOptions options;
  options.trace = true;
  options.show = show;
  return *RunForTest(program, scenario, options).trace;
}

std::string Whole(const TextSource& source) {
  std::string text;
  source([&](std::string_view piece) { text += piece; });
  return text;
}

std::string Csv(const Trace& trace) { return Whole(std::bind_front(&Trace::WriteCsv, &trace)); }
std::string Vcd(const Trace& trace) { return Whole(std::bind_front(&Trace::WriteVcd, &trace)); }
std::string TraceEvents(const Trace& trace) {
  return Whole(std::bind_front(&Trace::WriteJson, &trace));
}

TEST(Trace, KeepsTheCyclesInWhichSomethingChanged) {
  // Two statements per iteration, 25 per cycle.
  EXPECT_EQ(Csv(TraceOf(kSpin, "until_ms = 0.5", {"n"})),
            "time_ms,n,gpo\n0,0,0\n0.25,13,0\n0.5,25,0\n");
}

TEST(Trace, HoldsWhatTheScenarioNames) {
  EXPECT_EQ(Csv(TraceOf(kSpin, "until_ms = 0.5\ntrace = [\"axis2.prfPos\", \"gpo[1]\", \"n\"]")),
            "time_ms,axis2.prfPos,gpo[1],n\n0,0.0,0,0\n0.25,0.0,0,13\n0.5,0.0,0,25\n");
}

TEST(Trace, RefusesAnUnknownName) {
  RunOptions options;
  options.trace = true;
  const auto result =
      RunScenario(ScenarioForTest("trace = [\"axis2.prfPso\"]"), CompileForTest(kSpin), options);
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(result.error().message.en, HasSubstr("did you mean 'axis2.prfPos'"));
}

TEST(Trace, ShowsInputsAndOutputsThatChange) {
  const Trace trace =
      TraceOf("int f()\n{\n  GT_SetDoBit(11, 2, 1);\n  GT_Delay(2);\n  return 0;\n}\n",
              "[[world.input]]\ntype = \"home\"\nindex = 3\nvalue = 1\nat_ms = 0.25\n");
  EXPECT_EQ(Csv(trace), "time_ms,gpo,home,clear\n0,0,0,0\n0.25,0,0,2\n1,0,4,2\n2.25,0,4,2\n");
}

// An axis that moves without a program: the state of the core is set directly.
Trace MovingAxis() {
  Controller controller;
  EXPECT_TRUE(controller.Load(CompileForTest("int f()\n{\n  return 0;\n}\n")).ok());
  controller.motion().AxisAt(2).ServoOn();
  Trace trace(DefaultColumns(controller));
  trace.Sample(controller);
  motion::Profile& profile = ChangeState(controller.motion()).profiles[2];
  profile.trap.target = 4;
  profile.trap.velocity = 2;
  profile.trap.parameters = {4, 4, 0, 0};  // 0.5 ms up, 1.5 ms at 2, 0.5 ms down
  profile.Start(0);
  trace.Mark(controller, "start \"3\"");
  while (controller.cycle() < 11) {
    controller.RunCycle();
    trace.Sample(controller);
  }
  trace.Finish(controller);
  return trace;
}

TEST(Trace, ShowsTheAxesThatMoveAndNoOthers) {
  const std::string csv = Csv(MovingAxis());
  EXPECT_THAT(
      csv, StartsWith(
               "time_ms,axis3.prfPos,axis3.prfVel,axis3.prfAcc\n0,0.0,0.0,0.0\n0.25,0.125,1.0,4.0\n"
               "0.5,0.5,2.0,"));
  EXPECT_THAT(csv, HasSubstr("\n1,1.5,2.0,0.0\n"));
  EXPECT_THAT(csv, EndsWith("\n2.5,4.0,0.0,0.0\n2.75,4.0,0.0,0.0\n"));
}

TEST(Trace, WritesRealsAndScopesForWaveformViewers) {
  const std::string vcd = Vcd(MovingAxis());
  EXPECT_THAT(vcd, StartsWith("$timescale 1 us $end\n$scope module oncard $end\n"
                              "$scope module axis3 $end\n$var real 64 ! prfPos $end\n"));
  EXPECT_THAT(vcd, HasSubstr("$upscope $end\n$upscope $end\n$enddefinitions $end\n#0\nr0.0 !\n"));
  EXPECT_THAT(vcd, HasSubstr("#250\nr0.125 !\nr1.0 \"\nr4.0 #\n"));
}

// The program runs at 250 us; both outputs have a pulse of 100 us between two cycles.
constexpr const char* kPulse =
    "int f()\n{\n  GT_ComparePulse(1, 0, 100);\n  GT_Delay(1);\n  return 0;\n}\n";

TEST(Trace, ShowsPulsesOfHighSpeedOutputsInsideACycle) {
  const Trace trace = TraceOf(kPulse, "");
  EXPECT_EQ(Csv(trace), "time_ms,gpo,hsio0,hsio1\n0,0,0,0\n0.25,0,1,1\n0.35,0,0,0\n1.25,0,0,0\n");
  EXPECT_THAT(Vcd(trace), HasSubstr("#350\n0\"\n0#\n"));
  EXPECT_THAT(TraceEvents(trace),
              HasSubstr(R"({"name":"hsio1","ph":"C","pid":1,"ts":350,"args":{"value":0}})"));
}

TEST(Trace, HoldsTheOutputThatTheScenarioNames) {
  EXPECT_EQ(Csv(TraceOf(kPulse, "trace = [\"hsio1\"]")),
            "time_ms,hsio1\n0,0\n0.25,1\n0.35,0\n1.25,0\n");
}

TEST(Trace, WritesTraceEvents) {
  const std::string json = TraceEvents(MovingAxis());
  for (const char* event :
       {R"({"name":"axis3.prfPos","ph":"C","pid":1,"ts":250,"args":{"value":0.125}})",
        R"({"name":"start \"3\"","cat":"host","ph":"i","s":"p","pid":1,"tid":32,"ts":0})"}) {
    EXPECT_THAT(json, HasSubstr(event));
  }
}

TEST(Trace, WritesWhenThreadsRan) {
  const std::string json = TraceEvents(TraceOf("int f()\n{\n  GT_Delay(2);\n  return 0;\n}\n",
                                               "[[thread]]\nthread = 3\nfunction = \"f\"\n"));
  for (const char* event :
       {R"({"name":"thread_name","ph":"M","pid":1,"tid":3,"args":{"name":"thread 3"}})",
        R"({"name":"f","cat":"thread","ph":"X","pid":1,"tid":3,"ts":0,"dur":2250})"}) {
    EXPECT_THAT(json, HasSubstr(event));
  }
}

TEST(Trace, MarksWhatTheCardDoesByItself) {
  // The alarm is active at power-on; axis 2 reaches its limit switch during the move, 1 ms and the
  // filter time late.
  const std::string json =
      TraceEvents(TraceOf(kSpin,
                          "until_ms = 3\n[[world.input]]\ntype = \"alarm\"\nindex = 1\n"
                          "value = 1\n[[world.input]]\ntype = \"limit_positive\"\n"
                          "index = 2\nvalue = 1\nat_ms = 1\n"));
  for (
      const char* event :
      {R"({"name":"the drive of axis 1 reports an alarm at 0: it is switched off","cat":"card",)"
       R"("ph":"i","s":"p","pid":1,"tid":32,"ts":0})",
       R"({"name":"axis 2 reached its positive limit switch at 0: no motion in that direction until GT_ClrSts",)"
       R"("cat":"card","ph":"i","s":"p","pid":1,"tid":32,"ts":1750})"}) {
    EXPECT_THAT(json, HasSubstr(event));
  }
}

TEST(Trace, WritesTheSignOfAZero) {
  Controller controller;
  ASSERT_TRUE(controller.Load(CompileForTest("int f()\n{\n  return 0;\n}\n")).ok());
  std::vector<TraceColumn> columns;
  for (const char* name : {"axis1.prfPos", "axis2.prfPos"}) {
    columns.push_back({ResolveQuantity(name, controller).value().front()});
  }
  Trace trace(std::move(columns));
  for (const auto& [first, second] : {std::pair{0.0, 1.0}, {-0.0, 2.0}, {0.0, 3.0}}) {
    controller.RunCycle();
    ChangeState(controller.motion()).axes[0].profile.position = first;
    ChangeState(controller.motion()).axes[1].profile.position = second;
    trace.Sample(controller);
  }
  EXPECT_EQ(Csv(trace),
            "time_ms,axis1.prfPos,axis2.prfPos\n0.25,0.0,1.0\n0.5,-0.0,2.0\n0.75,0.0,3.0\n");
}

// Every format passes on pieces of bounded size, however long the run is.
TEST(Trace, IsNeverInMemoryAsAWholeText) {
  const Trace trace = TraceOf(kSpin, "until_ms = 5000", {"n"});
  for (const auto write : {&Trace::WriteCsv, &Trace::WriteVcd, &Trace::WriteJson}) {
    size_t pieces = 0;
    (trace.*write)([&](std::string_view piece) {
      ++pieces;
      EXPECT_LE(piece.size(), TextBuffer::kPieceSize + 200);
    });
    EXPECT_GE(pieces, 3u);
  }
}

TEST(Trace, MarksWhatTheHostWrites) {
  const std::string json =
      TraceEvents(TraceOf(kSpin, "until_ms = 2\n[[host]]\nat_ms = 1\nset = { n = 5 }\n"));
  EXPECT_THAT(json, HasSubstr(R"({"name":"n = 5","cat":"host","ph":"i")"));
}

}  // namespace
}  // namespace oncard::runtime
