#include "runtime/sim/controller.h"
#include "gtcalls/gts/catalogue.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "compiler/compiler.h"
#include "gtcalls/gts/buffered_values.h"
#include "runtime/host/call_log.h"
#include "test_programs.h"
#include "tests/compiler/memory_files.h"
#include "tests/motion/change_state.h"

namespace oncard::runtime {
namespace {

/// Compiles a program that is known to be correct.
vm::Object CompileProgram(std::string_view text) {
  const auto compilation = compiler::CompileText("program.c", std::string(text),
                                                 compiler::Options{}, compiler::NoFiles());
  EXPECT_TRUE(compilation.ok());
  return compilation.ok() ? *compilation.object : vm::Object{};
}

/// A card with a program.
struct LoadedCard {
  explicit LoadedCard(std::string_view program, const ControllerOptions& options = {})
      : controller(options) {
    const auto loaded = controller.Load(CompileProgram(program));
    EXPECT_TRUE(loaded.ok()) << loaded.error().message.en;
  }

  vm::SlotAddress Global(std::string_view name) const {
    const vm::Symbol* symbol = vm::FindGlobal(*controller.machine().image(), name);
    EXPECT_NE(symbol, nullptr) << name;
    return {true, 0, symbol->id, symbol->type};
  }
  double Read(std::string_view name) const { return controller.machine().Read(Global(name)); }
  void Run(int thread, int page) {
    EXPECT_EQ(controller.machine().Bind(thread, 1, page), vm::kOk);
    EXPECT_EQ(controller.machine().Run(thread), vm::kOk);
  }
  void SetLocal(int page, uint16_t id, double value) {
    EXPECT_TRUE(controller.machine().Write(
        {false, static_cast<uint8_t>(page), id, vm::DataType::kInt}, value));
  }

  Controller controller;
};

int16_t CallByName(Controller& controller, std::string_view name,
                   std::span<vm::CommandArgument> arguments, Message* reason = nullptr) {
  return controller.Call(*gtcalls::GtsCatalogue().Find(name), arguments, reason);
}

/// GT_GetClockHighPrecision in its units of 125 us.
double HighPrecisionClock(Controller& controller) {
  double clock = -1;
  std::array<vm::CommandArgument, 1> arguments;
  arguments[0].cells = std::span(&clock, 1);
  EXPECT_EQ(CallByName(controller, "GT_GetClockHighPrecision", arguments), 0);
  return clock;
}

// --- Programs ------------------------------------------------------------------------------------

TEST(ControllerTest, RunsTheSumOfTheManual) {
  LoadedCard card(kSumProgram);
  ASSERT_EQ(card.controller.machine().Bind(0, 1, 0), vm::kOk);
  card.SetLocal(0, 0, 1);
  card.SetLocal(0, 1, 100);
  ASSERT_EQ(card.controller.machine().Run(0), vm::kOk);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kQuiet);
  EXPECT_EQ(card.Read("sum"), 5050);
  EXPECT_EQ(card.controller.machine().thread(0).result, 5050);
  // i = begin, five statements for each of 100 numbers, the comparison and jump that end the loop,
  // the return; 25 statements per cycle.
  EXPECT_EQ(card.controller.machine().state().executed, 1 + 100 * 5 + 2 + 1);
  EXPECT_EQ(card.controller.cycle(), 21);
}

TEST(ControllerTest, TwoThreadsShareTheSum) {
  LoadedCard card(kSumProgram);
  for (int thread : {0, 1}) {
    ASSERT_EQ(card.controller.machine().Bind(thread, 1, thread), vm::kOk);
    card.SetLocal(thread, 0, thread == 0 ? 1 : 51);
    card.SetLocal(thread, 1, thread == 0 ? 50 : 100);
    ASSERT_EQ(card.controller.machine().Run(thread), vm::kOk);
  }
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kQuiet);
  EXPECT_EQ(card.Read("sum"), 5050);
  // Both execute the same number of statements in turns, so thread 1 is the last to return.
  EXPECT_EQ(card.controller.machine().thread(1).result, 5050);
}

TEST(ControllerTest, ARefusedObjectLeavesTheOldProgramRunning) {
  LoadedCard card(kEndlessProgram);
  card.Run(0, 0);
  card.controller.RunCycle();
  const auto* image = card.controller.machine().image();
  vm::Object broken = CompileProgram(kSumProgram);
  broken.functions[0].instructions[2].displacement = 1000;
  const auto loaded = card.controller.Load(broken);
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().code, 2008);
  EXPECT_EQ(card.controller.machine().image(), image);
  const int64_t before = card.controller.machine().state().executed;
  card.controller.RunCycle();
  EXPECT_EQ(card.controller.machine().state().executed, before + 25);
}

TEST(ControllerTest, ALoadRemovesTheBlocksBoundToTheOldVariables) {
  LoadedCard card(kEndlessProgram);
  ASSERT_TRUE(card.controller.card().state<gtcalls::GtsState>().plc.Bind(
      {gtcalls::gts::kGlobalVariables, 0, gtcalls::gts::DiBlock{}}));
  ASSERT_TRUE(card.controller.Load(CompileProgram(kSumProgram)).ok());
  EXPECT_TRUE(card.controller.card().state<gtcalls::GtsState>().plc.blocks.empty());
}

TEST(ControllerTest, AProgramReadsItsWholeListOfCaptureOffsets) {
  LoadedCard card(R"(int back[4];
int count;
int loop;
int f()
{
  int offsets[3];
  offsets[0] = 10;
  offsets[1] = -20;
  offsets[2] = 30;
  GT_SetCaptureOffset(1, &offsets[0], 3, 2);
  GT_GetCaptureOffset(1, &back[0], &count, &loop);
  return 0;
}
)");
  card.Run(0, 0);
  EXPECT_EQ(card.controller.RunUntilQuiet(10), RunEnd::kQuiet);
  const vm::SlotAddress back = card.Global("back");
  const double expected[] = {10, -20, 30, 0};
  for (uint16_t i = 0; i < 4; ++i) {
    const vm::SlotAddress slot = {true, 0, static_cast<uint16_t>(back.id + i), back.type};
    EXPECT_EQ(card.controller.machine().Read(slot), expected[i]) << i;
  }
  EXPECT_EQ(card.Read("count"), 3);
  EXPECT_EQ(card.Read("loop"), 2);
}

// --- Time ----------------------------------------------------------------------------------------

TEST(ControllerTest, ACycleRunsWhenAWholeOneHasPassed) {
  Controller controller;
  controller.AdvanceUs(249);
  EXPECT_EQ(controller.cycle(), 0);
  EXPECT_EQ(controller.NowUs(), 249);
  controller.AdvanceUs(1);
  EXPECT_EQ(controller.cycle(), 1);
  controller.AdvanceUs(1000);
  EXPECT_EQ(controller.cycle(), 5);
  EXPECT_EQ(controller.NowUs(), 1250);
  EXPECT_EQ(controller.NowMs(), 1.25);
}

TEST(ControllerTest, TheBudgetIsExactInTheLongRun) {
  struct Case {
    int rate;
    int64_t cycle_us;
    std::array<int64_t, 4> executed;  // after 1, 2, 3, 4 cycles
  };
  const Case cases[] = {
      {100, 250, {25, 50, 75, 100}}, {100, 1000, {100, 200, 300, 400}},
      {10, 250, {2, 5, 7, 10}},      {1, 250, {0, 0, 0, 1}},
      {3, 125, {0, 0, 1, 1}},        {0, 250, {0, 0, 0, 0}},
  };
  for (const Case& c : cases) {
    LoadedCard card(kEndlessProgram, {{8, c.cycle_us}, c.rate});
    card.Run(0, 0);
    for (const int64_t expected : c.executed) {
      card.controller.RunCycle();
      EXPECT_EQ(card.controller.machine().state().executed, expected)
          << "rate " << c.rate << ", cycle " << c.cycle_us;
    }
  }
}

TEST(ControllerTest, AnIdleCardSavesUpNoStatements) {
  LoadedCard card(kEndlessProgram);
  for (int i = 0; i < 10; ++i) card.controller.RunCycle();
  card.Run(0, 0);
  card.controller.RunCycle();
  EXPECT_EQ(card.controller.machine().state().executed, 25);
}

int64_t CostUs(const char* command) {
  const gtcalls::Family& family = gtcalls::GtsFamily();
  return family.cost_us(*family.catalogue.Find(command));
}

TEST(ControllerTest, HostCallsCostWhatTheManualSays) {
  EXPECT_EQ(CostUs("GT_GetPrfPos"), 50);
  EXPECT_EQ(CostUs("GT_Open"), 0);
  for (const char* name : {"GT_Update", "GT_PtStart", "GT_GearStart", "GT_FollowStart"}) {
    EXPECT_EQ(CostUs(name), 1000) << name;
  }
}

TEST(ControllerTest, AHostCallActsAfterItsTime) {
  Controller controller;
  for (int call = 1; call <= 4; ++call) EXPECT_EQ(HighPrecisionClock(controller), 0) << call;
  EXPECT_EQ(HighPrecisionClock(controller), 2);  // 5 * 50 us = one cycle of 2 * 125 us
  for (int call = 6; call <= 9; ++call) EXPECT_EQ(HighPrecisionClock(controller), 2) << call;
  EXPECT_EQ(HighPrecisionClock(controller), 4);
}

TEST(ControllerTest, ExecuteLetsNoTimePass) {
  Controller controller;
  double clock = -1;
  std::array<vm::CommandArgument, 1> arguments;
  arguments[0].cells = std::span(&clock, 1);
  for (int call = 0; call < 100; ++call) {
    ASSERT_EQ(
        controller.Execute(*gtcalls::GtsCatalogue().Find("GT_GetClockHighPrecision"), arguments),
        0);
  }
  EXPECT_EQ(controller.NowUs(), 0);
}

TEST(ControllerTest, ARefusedCallGivesItsReason) {
  Controller controller;
  std::array<vm::CommandArgument, 1> arguments;
  arguments[0].value = 32;
  Message reason;
  EXPECT_EQ(CallByName(controller, "GT_RunThread", arguments, &reason), 7);
  EXPECT_FALSE(reason.en.empty());
  EXPECT_FALSE(reason.zh.empty());
}

TEST(ControllerTest, ADelayEndsWithItsCycle) {
  LoadedCard card(R"(int done;
int wait()
{
  GT_Delay(10);
  done = 1;
  return done;
}
)");
  card.Run(0, 0);
  // The first cycle executes the command; ten milliseconds are forty more cycles.
  for (int cycle = 1; cycle <= 40; ++cycle) {
    card.controller.RunCycle();
    EXPECT_EQ(card.Read("done"), 0) << cycle;
  }
  card.controller.RunCycle();
  EXPECT_EQ(card.Read("done"), 1);
}

TEST(ControllerTest, InputsReachThePlcBlocksAndThreadsInOneCycle) {
  LoadedCard card(R"(int in;
int out;
int run()
{
loop:
  out = in;
  goto loop;
}
)");
  motion::DigitalIo& io = ChangeState(card.controller.motion()).io;
  io.SetFilterTicks(motion::DiType::kGpi, 0, 1);
  io.SetPin(motion::DiType::kGpi, 0, false);
  ASSERT_TRUE(card.controller.card().state<gtcalls::GtsState>().plc.Bind(
      {gtcalls::gts::kGlobalVariables, card.Global("in").id,
       gtcalls::gts::DiBlock{motion::DiType::kGpi, 0, false}}));
  card.Run(0, 0);
  card.controller.RunCycle();
  const double before = card.Read("out");
  io.SetPin(motion::DiType::kGpi, 0, true);
  card.controller.RunCycle();
  EXPECT_NE(card.Read("out"), before);
}

// --- Ends of a run -------------------------------------------------------------------------------

TEST(ControllerTest, ACoordinateSystemWritesVariablesBetweenItsSegments) {
  LoadedCard card("int reached;\ndouble part;\nint main() { return 0; }\n",
                  {.motion = {.cycle_us = 1000}});
  const auto call = [&](std::string_view name, std::vector<double> values,
                        std::vector<double> cells = {}, size_t pointer = 1) {
    std::vector<vm::CommandArgument> arguments(values.size());
    for (size_t i = 0; i < values.size(); ++i) arguments[i].value = values[i];
    if (!cells.empty()) arguments[pointer].cells = cells;
    return card.controller.Execute(*gtcalls::GtsCatalogue().Find(name), arguments);
  };
  // X is profile 1, Y is profile 2; 100 pulse/ms and 10 pulse/ms^2 at most.
  std::vector<double> parameters(1 + 8 + 2 + 2 + 8);
  parameters[0] = 2;
  parameters[1] = 1;
  parameters[2] = 2;
  parameters[9] = 100;
  parameters[10] = 10;
  ASSERT_EQ(call("GT_SetCrdPrm", {1, 0}, parameters), 0);
  const auto info = [&](std::string_view name) {
    const vm::SlotAddress slot = card.Global(name);
    std::vector<double> cells(2 + 32);
    cells[0] = slot.id;
    cells[1] = static_cast<double>(slot.type);
    return cells;
  };
  ASSERT_EQ(call("GT_LnXY", {1, 100, 0, 10, 1, 0, 0}), 0);
  ASSERT_EQ(call("GT_BufSetVarValue", {1, -1, 0, 7, 0}, info("reached"), 2), 0);
  ASSERT_EQ(call("GT_BufSetVarValue", {1, -1, 0, 0.25, 0}, info("part"), 2), 0);
  EXPECT_EQ(call("GT_BufSetVarValue", {1, -1, 0, 3e9, 0}, info("reached"), 2), 7);
  EXPECT_EQ(call("GT_BufSetVarValue", {1, 5, 0, 1, 0}, info("reached"), 2), 7);
  ASSERT_EQ(call("GT_LnXY", {1, 200, 0, 10, 1, 0, 0}), 0);
  ASSERT_EQ(call("GT_CrdStart", {1, 0}), 0);
  // 100 pulses from rest to rest at 10 pulse/ms and 1 pulse/ms^2 take 20 ms.
  for (int i = 0; i < 19; ++i) card.controller.RunCycle();
  EXPECT_EQ(card.Read("reached"), 0);
  card.controller.RunCycle();
  EXPECT_EQ(card.Read("reached"), 7);
  EXPECT_EQ(card.Read("part"), 0.25);
}

TEST(RunUntilQuietTest, StopsAtTheTimeLimit) {
  LoadedCard card(kEndlessProgram);
  card.Run(0, 0);
  EXPECT_EQ(card.controller.RunUntilQuiet(7), RunEnd::kTimeLimit);
  EXPECT_EQ(card.controller.cycle(), 7);
}

TEST(RunUntilQuietTest, AStillCardIsQuietAtOnce) {
  Controller controller;
  EXPECT_EQ(controller.RunUntilQuiet(100), RunEnd::kQuiet);
  EXPECT_EQ(controller.cycle(), 0);
}

constexpr std::string_view kWaitingProgram = R"(int go;
int wait()
{
  GT_WaitForVarEq(&go, 1);
  return go;
}
int helper()
{
  GT_Delay(5);
  go = 1;
  return go;
}
)";

TEST(RunUntilQuietTest, SeesThatNothingIsLeftToChangeAValue) {
  LoadedCard card(kWaitingProgram);
  card.Run(0, 0);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kDeadlock);
  EXPECT_LT(card.controller.cycle(), 1000);
  EXPECT_TRUE(card.controller.Deadlocked());
  card.controller.machine().Write(card.Global("go"), 1);
  EXPECT_FALSE(card.controller.Deadlocked());
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kQuiet);
}

TEST(RunUntilQuietTest, ACoordinateSystemCanStillHelp) {
  LoadedCard card(kWaitingProgram);
  card.Run(0, 0);
  motion::MotionCore& motion = card.controller.motion();
  motion::CrdParameters parameters;
  parameters.dimension = 2;
  parameters.coordinates = {1, 2};
  motion.CrdAt(0).SetUp(parameters);
  motion::PathSlot delay;
  delay.command = {.kind = motion::BufferedKind::kDelay, .values = {5}};
  motion::PathSlot write;
  write.command = gtcalls::gts::EncodeValue(
      {.target = gtcalls::gts::ValueTarget::kProgram, .value = 1, .slot = card.Global("go")});
  gtcalls::gts::ReserveValues(motion);
  ASSERT_TRUE(motion.CrdAt(0).Append(0, delay));
  ASSERT_TRUE(motion.CrdAt(0).Append(0, write));
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kDeadlock) << "before it is started";
  motion.CrdAt(0).Start(0, false);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kQuiet);
  EXPECT_EQ(card.Read("go"), 1);
  // Values that have been written are not written again.
  card.controller.machine().Write(card.Global("go"), 0);
  ASSERT_EQ(card.controller.machine().Run(0), vm::kOk);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kDeadlock);
}

TEST(RunUntilQuietTest, ADelayedThreadCanStillHelp) {
  LoadedCard card(kWaitingProgram);
  card.Run(0, 0);
  ASSERT_EQ(card.controller.machine().Bind(1, 2, 1), vm::kOk);
  ASSERT_EQ(card.controller.machine().Run(1), vm::kOk);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kQuiet);
  EXPECT_EQ(card.controller.machine().thread(0).result, 1);
}

TEST(RunUntilQuietTest, APeriodicThreadCanStillHelp) {
  LoadedCard card(kWaitingProgram);
  card.Run(0, 0);
  ASSERT_EQ(card.controller.machine().Bind(1, 2, 1), vm::kOk);
  ASSERT_EQ(card.controller.machine().RunPeriodic(1, 400, 4), vm::kOk);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kTimeLimit);
  EXPECT_EQ(card.controller.machine().thread(0).result, 1);
}

TEST(RunUntilQuietTest, APlcBlockCanStillHelp) {
  LoadedCard card(kWaitingProgram);
  card.Run(0, 0);
  ASSERT_TRUE(card.controller.card().state<gtcalls::GtsState>().plc.Bind(
      {gtcalls::gts::kGlobalVariables, card.Global("go").id,
       gtcalls::gts::DiBlock{motion::DiType::kGpi, 0, false}}));
  EXPECT_EQ(card.controller.RunUntilQuiet(100), RunEnd::kTimeLimit);
  card.controller.motion().digital_io().SetPin(motion::DiType::kGpi, 0, true);
  const RunEnd high = card.controller.RunUntilQuiet(100);
  card.controller.motion().digital_io().SetPin(motion::DiType::kGpi, 0, false);
  const RunEnd low = card.controller.RunUntilQuiet(100);
  EXPECT_TRUE(high == RunEnd::kQuiet || low == RunEnd::kQuiet);  // whichever level reads 1
}

TEST(RunUntilQuietTest, SaysWhenAReplayedScheduleEndsOrLeavesItsPath) {
  auto schedule = std::make_shared<vm::Schedule>();
  LoadedCard card(kEndlessProgram);
  schedule->program_hash = card.controller.machine().image()->hash;
  schedule->segments = {{0, 40}};
  vm::Policy policy;
  policy.kind = vm::PolicyKind::kReplay;
  policy.schedule = schedule;
  card.controller.machine().SetPolicy(policy);
  card.Run(0, 0);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kScheduleEnd);
  EXPECT_EQ(card.controller.machine().state().executed, 40);

  schedule->segments = {{5, 40}};  // thread 5 is not bound
  card.controller.machine().SetPolicy(policy);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kScheduleDiverged);
}

// --- State ---------------------------------------------------------------------------------------

TEST(ControllerStateTest, ARestoredRunContinuesAsTheFirstOne) {
  LoadedCard card(kSumProgram);
  card.SetLocal(0, 1, 100);
  card.Run(0, 0);
  card.controller.AdvanceUs(1130);  // in the middle of a cycle
  const ControllerSnapshot snapshot = card.controller.Snapshot();
  const uint64_t hash = card.controller.Hash();
  card.controller.AdvanceUs(2345);
  const uint64_t later = card.controller.Hash();
  EXPECT_NE(later, hash);
  card.controller.Restore(snapshot);
  EXPECT_EQ(card.controller.Hash(), hash);
  EXPECT_EQ(card.controller.NowUs(), 1130);
  card.controller.AdvanceUs(2345);
  EXPECT_EQ(card.controller.Hash(), later);
}

TEST(ControllerTimeTest, ARefusedCommandHasTheTimeOfItsCycleInALongWait) {
  LoadedCard card(R"(int f()
{
  int axis;
  axis = 99;
  GT_Delay(3);
  GT_SetVel(axis, 1);
  return axis;
}
)");
  RefusedCommands refused;
  card.controller.CollectRefusals(&refused);
  card.Run(0, 0);
  card.controller.AdvanceUs(100'000);
  ASSERT_EQ(refused.list().size(), 1u);
  EXPECT_LT(refused.list().front().first_us, 5000);
}

TEST(ControllerStateTest, TheHashCoversEveryPart) {
  LoadedCard card(kSumProgram);
  const ControllerSnapshot clean = card.controller.Snapshot();
  const uint64_t hash = card.controller.Hash();
  const auto changes_the_hash = [&](const char* what, const auto& change) {
    change();
    EXPECT_NE(card.controller.Hash(), hash) << what;
    card.controller.Restore(clean);
    EXPECT_EQ(card.controller.Hash(), hash) << what;
  };
  changes_the_hash("variable", [&] { card.SetLocal(31, 1023, 1); });
  changes_the_hash("thread", [&] { card.controller.machine().Bind(31, 1, 31); });
  changes_the_hash(
      "pin", [&] { card.controller.motion().digital_io().SetPin(motion::DiType::kMpg, 0, true); });
  changes_the_hash("block", [&] {
    card.controller.card().state<gtcalls::GtsState>().plc.Bind(
        {gtcalls::gts::kGlobalVariables, 0, gtcalls::gts::DiBlock{}});
  });
  changes_the_hash("part of a cycle", [&] { card.controller.AdvanceUs(50); });
  changes_the_hash("cycle", [&] { card.controller.RunCycle(); });
}

TEST(ControllerStateTest, EqualRunsHaveEqualHashes) {
  uint64_t hashes[2];
  for (uint64_t& hash : hashes) {
    LoadedCard card(kSumProgram);
    card.SetLocal(0, 1, 100);
    card.Run(0, 0);
    card.controller.RunUntilQuiet(1000);
    hash = card.controller.Hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(ControllerStateTest, ResetIsAPowerOnThatKeepsTheWorld) {
  LoadedCard card(kSumProgram);
  card.SetLocal(0, 1, 100);
  card.Run(0, 0);
  card.controller.card().state<gtcalls::GtsState>().plc.Bind(
      {gtcalls::gts::kGlobalVariables, 0, gtcalls::gts::DiBlock{}});
  card.controller.motion().digital_io().SetPin(motion::DiType::kGpi, 3, true);
  const uint32_t pins = card.controller.motion().state().io.Pins(motion::DiType::kGpi);
  card.controller.AdvanceUs(10'000);
  card.controller.Reset();
  EXPECT_EQ(card.controller.machine().image(), nullptr);
  EXPECT_EQ(card.controller.machine().thread(0).run, vm::ThreadRun::kUnbound);
  EXPECT_EQ(card.controller.machine().state().globals[0], 0);
  EXPECT_EQ(card.controller.machine().state().pages[0][1], 0);
  EXPECT_TRUE(card.controller.card().state<gtcalls::GtsState>().plc.blocks.empty());
  EXPECT_EQ(card.controller.motion().ClockMs(), 0);
  EXPECT_EQ(card.controller.cycle(), 40);  // time since power-on continues
  EXPECT_EQ(card.controller.motion().state().io.Pins(motion::DiType::kGpi), pins);
  EXPECT_EQ(card.controller.machine().Bind(0, 1, 0), vm::kBadParameter);
}

TEST(ControllerStateTest, DelaysAfterALoadStillTakeTheirTime) {
  LoadedCard card(kEndlessProgram);
  card.controller.AdvanceUs(100'000);
  ASSERT_TRUE(card.controller.Load(CompileProgram(kWaitingProgram)).ok());
  ASSERT_EQ(card.controller.machine().Bind(0, 2, 0), vm::kOk);
  ASSERT_EQ(card.controller.machine().Run(0), vm::kOk);
  EXPECT_EQ(card.controller.RunUntilQuiet(1000), RunEnd::kQuiet);
  EXPECT_EQ(card.controller.cycle(), 400 + 1 + 20);  // 100 ms, the command, 5 ms
}

TEST(ControllerTest, ARefusalInAProgramIsLoggedWithItsReason) {
  constexpr std::string_view kProgram = R"(int f()
{
  int bit;
  bit = 99;
  GT_SetDoBit(12, bit, 1);
  GT_SetDoBit(12, 1, 1);
  return bit;
}
)";
  LoadedCard card(kProgram);
  testing::internal::CaptureStderr();
  CallLog log("calls", Language::kEnglish);
  card.controller.LogRefusals(&log, 2);
  card.Run(5, 0);
  card.controller.RunCycle();
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "0.250 card2 thread 5: GT_SetDoBit(12, 99, 1) = 7: parameter doIndex is 99; the range "
            "is [1, 16]\n");
}

TEST(ControllerTest, AStopOfTheCardIsLoggedWithItsInstant) {
  Controller controller;
  testing::internal::CaptureStderr();
  CallLog log("calls", Language::kChinese);
  controller.LogEvents(&log, 1);
  ChangeState(controller.motion()).axes[2].soft_negative = 10;
  controller.AdvanceUs(500);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "0.250 card1: 轴 3 在 0 处越过负软限位 10：调用 GT_ClrSts 前不能向该方向运动\n");
}

}  // namespace
}  // namespace oncard::runtime
