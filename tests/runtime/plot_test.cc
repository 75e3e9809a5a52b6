#include "runtime/observe/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/run/scenario_card.h"
#include "tests/motion/change_state.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

constexpr const char* kIdle = "int n;\nint f()\n{\n  return 0;\n}\n";

class PlotTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(controller_.Load(CompileForTest(kIdle)).ok()); }

  motion::MotionState& state() { return ChangeState(controller_.motion()); }

  // Another cycle, which ends with these positions.
  void Cycle(double first, double second) {
    trace();  // begins before the first cycle
    controller_.RunCycle();
    state().axes[0].profile.position = first;
    state().axes[1].profile.position = second;
    trace().Sample(controller_);
  }
  Trace& trace() {
    if (!trace_) {
      std::vector<TraceColumn> columns;
      for (const std::string& name : names_) {
        columns.push_back({ResolveQuantity(name, controller_).value().front()});
      }
      trace_.emplace(std::move(columns));
      trace_->Sample(controller_);
    }
    return *trace_;
  }
  std::string Script(PictureFormat format = PictureFormat::kSvg) {
    trace().Finish(controller_);
    const auto script = PlotScript(trace(), {"It's a title", format});
    EXPECT_TRUE(script.ok());
    return script.ok() ? script.value() : "";
  }
  static bool Contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  std::vector<std::string> names_ = {"axis1.prfPos", "axis2.prfPos"};
  Controller controller_;
  std::optional<Trace> trace_;
};

TEST_F(PlotTest, GivesEveryPartItsOwnColour) {
  Cycle(1, 2);
  Cycle(2, 1);
  const std::string script = Script();
  EXPECT_TRUE(Contains(script,
                       "plot $p0c0 with lines lw 2 lc rgb '#0072B2' title 'axis1.prfPos', "
                       "\\\n     $p0c1 with lines lw 2 lc rgb '#D55E00' title "
                       "'axis2.prfPos'\n"))
      << script;
}

TEST_F(PlotTest, NamesUnitsAndTime) {
  Cycle(1, 2);
  const std::string script = Script();
  EXPECT_TRUE(Contains(script, "set ylabel 'position [pulse]'"));
  EXPECT_TRUE(Contains(script, "set xlabel 'time [ms]'"));
  EXPECT_TRUE(Contains(script, "set xrange [0:0.25]\n"));
}

TEST_F(PlotTest, QuotesTheTitle) {
  Cycle(1, 2);
  EXPECT_TRUE(Contains(Script(), "set multiplot title 'It''s a title'"));
}

TEST_F(PlotTest, DrawsSvgAndPng) {
  Cycle(1, 2);
  EXPECT_TRUE(Contains(Script(), "set terminal svg "));
  EXPECT_TRUE(Contains(Script(PictureFormat::kPng), "set terminal pngcairo "));
}

TEST_F(PlotTest, LeavesOutPointsOfAStraightLine) {
  for (int i = 1; i <= 8; ++i) Cycle(i <= 4 ? i : 8 - i, 0);
  // Rises to 4 at 1 ms and falls to 0 at 2 ms; no other points are needed.
  EXPECT_TRUE(Contains(Script(), "$p0c0 << EOD\n0 0\n1 4\n2 0\nEOD\n"));
}

TEST_F(PlotTest, HoldsAValueUntilTheCycleBeforeItChanges) {
  for (int i = 1; i <= 8; ++i) Cycle(i == 8 ? 4 : 0, 0);
  EXPECT_TRUE(Contains(Script(), "$p0c0 << EOD\n0 0\n1.75 0\n2 4\nEOD\n"));
}

TEST_F(PlotTest, StacksSignalsWithTheFirstAtTheTop) {
  names_ = {"gpo", "axis1.alarm"};
  Cycle(0, 0);
  state().io.Write(motion::DoType::kGpo, 0x2, 0x2);
  Cycle(0, 0);
  state().axes[0].latched = motion::kAlarmBit;
  Cycle(0, 0);
  const std::string script = Script();
  EXPECT_TRUE(Contains(script, "set ytics ('gpo[2]' 1.35, 'axis1.alarm' 0.35)")) << script;
  EXPECT_TRUE(Contains(script, "$p5c0 << EOD\n0 1\n0.5 1.7\n0.75 1.7\nEOD\n")) << script;
  EXPECT_TRUE(Contains(script, "$p5c1 << EOD\n0 0\n0.75 0.7\nEOD\n")) << script;
}

TEST_F(PlotTest, DrawsVariablesAsSteps) {
  names_ = {"n"};
  Cycle(0, 0);
  controller_.machine().Write({true, 0, 0, vm::DataType::kInt}, 7);
  Cycle(0, 0);
  Cycle(0, 0);
  const std::string script = Script();
  EXPECT_TRUE(Contains(script, "$p4c0 << EOD\n0 0\n0.5 7\n0.75 7\nEOD\n")) << script;
  EXPECT_TRUE(Contains(script, "plot $p4c0 with steps lw 2 lc rgb '#0072B2' title 'n'\n"));
}

TEST(PlotOfADrive, NamesItsStatesModesAndPhasesOfHoming) {
  const Scenario scenario =
      ParseScenario("program = \"x.c\"\n[[ethercat.slave]]\n[[ethercat.slave]]\n", "bus.toml")
          .value();
  Controller controller(CardOptions(scenario));
  ApplyWorld(scenario, &controller);
  motion::bus::Bus& bus = ChangeState(controller.motion()).bus->line;
  ASSERT_EQ(bus.Init(0), motion::bus::InitOutcome::kDone);
  std::vector<TraceColumn> columns;
  for (const char* name : {"drive1.state", "drive2.state", "drive1.mode"}) {
    columns.push_back({ResolveQuantity(name, controller).value().front()});
  }
  Trace trace(std::move(columns));
  trace.Sample(controller);
  while (controller.NowMs() < 200) {
    controller.RunCycle();
    trace.Sample(controller);
  }
  trace.Finish(controller);
  const std::string script = PlotScript(trace, {}).value();
  EXPECT_THAT(script, HasSubstr("set yrange [-0.5:1.5]\nset ytics ('not ready' 0, "
                                "'switch-on disabled' 1, 'ready' 2, 'switched on' 3, "
                                "'operation enabled' 4, 'quick stop' 5, 'fault reaction' 6, "
                                "'fault' 7) scale 0\n"));
  EXPECT_THAT(script, HasSubstr("('none' 0, 'PP' 1, 'PV' 3, 'PT' 4, 'HM' 6, 'CSP' 8, 'CSV' 9, "
                                "'CST' 10) scale 0\n"));
  // The drives share a panel.
  EXPECT_THAT(script, HasSubstr("title 'drive1.state', \\\n"));
}

// The cards of the first type count milliseconds, those of the second one sample times.
TEST(PlotUnits, AreThoseOfTheCardsCommands) {
  const struct {
    const char* card;
    const char* unit;
  } cases[] = {{"GTS-800", "ms"}, {"GT-400-SG", "cycle"}};
  for (const auto& c : cases) {
    const std::string text = std::string("card = \"") + c.card + "\"\n";
    const auto scenario = ParseScenario(text, "units.toml", ScenarioUse::kHost);
    ASSERT_TRUE(scenario.ok()) << scenario.error().message.en;
    Controller controller(CardOptions(scenario.value()));
    std::vector<TraceColumn> columns;
    for (const char* name : {"axis1.prfVel", "axis1.prfAcc"}) {
      columns.push_back({ResolveQuantity(name, controller).value().front()});
    }
    Trace trace(std::move(columns));
    trace.Sample(controller);
    controller.RunCycle();
    motion::Axis& axis = ChangeState(controller.motion()).axes[0];
    axis.profile.velocity = axis.profile.acceleration = 1;
    trace.Finish(controller);
    const std::string script = PlotScript(trace, {}).value();
    EXPECT_THAT(script, HasSubstr(std::string("velocity [pulse/") + c.unit + "]"));
    EXPECT_THAT(script, HasSubstr(std::string("acceleration [pulse/") + c.unit + "²]"));
  }
}

TEST_F(PlotTest, MarksWhatTheHostDoes) {
  trace().Mark(controller_, "go = 1");
  Cycle(1, 2);
  EXPECT_TRUE(Contains(Script(), "set arrow from 0, graph 0 to 0, graph 1 nohead"));
}

TEST_F(PlotTest, RefusesToDrawNothing) {
  Cycle(0, 0);
  trace().Finish(controller_);
  const auto script = PlotScript(trace(), {});
  ASSERT_FALSE(script.ok());
  EXPECT_EQ(script.error().message.en, "nothing to draw: no value changed during the run");
}

}  // namespace
}  // namespace oncard::runtime
