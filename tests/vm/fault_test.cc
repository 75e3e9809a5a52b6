// Run-time faults: all kinds, their recorded data, and that only their thread stops.
#include <gtest/gtest.h>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

using FaultTest = MachineTest;

// Slots 8..11 are an array; slot 0 of either storage is its index.
Element At(Storage array, Storage index) { return {array, 8, 4, {index, 0}}; }

struct FaultCase {
  const char* name;
  Instruction statement;
  Fault fault;
  int64_t value;
  int64_t limit;
};

constexpr DataType kInt = DataType::kInt;
constexpr DataType kDouble = DataType::kDouble;

// Slot 0, local and global, has the invalid index -1; slot 1 is 0.
std::vector<FaultCase> Cases() {
  const auto divide = [](DataType type, const Operand& a, const Operand& b, const Operand& dst) {
    return Binary(BinaryOperator::kDivide, type, a, b, dst);
  };
  const auto remainder = [](const Operand& a, const Operand& b, const Operand& dst) {
    return Binary(BinaryOperator::kRemainder, kInt, a, b, dst);
  };
  constexpr Fault kZero = Fault::kDivisionByZero;
  constexpr Fault kIndex = Fault::kIndexOutOfBounds;
  return {
      {"int by local", divide(kInt, Local(2), Local(1), Local(3)), kZero, 0, 0},
      {"int by literal", divide(kInt, Local(2), ImmediateInt(0), Local(3)), kZero, 0, 0},
      {"literal by local", divide(kInt, ImmediateInt(5), Local(1), Local(3)), kZero, 0, 0},
      {"literal by literal", divide(kInt, ImmediateInt(5), ImmediateInt(0), Local(3)), kZero, 0, 0},
      {"global by local", divide(kInt, Global(2), Local(1), Global(2)), kZero, 0, 0},
      {"global by literal", divide(kInt, Global(2), ImmediateInt(0), Global(2)), kZero, 0, 0},
      {"by global", divide(kInt, Local(2), Global(1), Local(3)), kZero, 0, 0},
      {"remainder by local", remainder(Local(2), Local(1), Local(3)), kZero, 0, 0},
      {"remainder by literal", remainder(Local(2), ImmediateInt(0), Local(3)), kZero, 0, 0},
      {"double by local", divide(kDouble, Local(2), Local(1), Local(3)), kZero, 0, 0},
      {"double by literal", divide(kDouble, Local(2), Raw(0), Local(3)), kZero, 0, 0},
      {"double literal by local", divide(kDouble, Raw(1), Local(1), Local(3)), kZero, 0, 0},
      {"double by global", divide(kDouble, Local(2), Global(1), Local(3)), kZero, 0, 0},
      {"read l[l]", Set(Local(3), At(kL, kL)), kIndex, -1, 4},
      {"read l[g]", Set(Local(3), At(kL, kG)), kIndex, -1, 4},
      {"read g[l]", Set(Local(3), At(kG, kL)), kIndex, -1, 4},
      {"read g[g]", Set(Local(3), At(kG, kG)), kIndex, -1, 4},
      {"write l[l]", Set(At(kL, kL), Local(3)), kIndex, -1, 4},
      {"write l[g]", Set(At(kL, kG), Local(3)), kIndex, -1, 4},
      {"write g[l]", Set(At(kG, kL), Local(3)), kIndex, -1, 4},
      {"write g[g]", Set(At(kG, kG), Local(3)), kIndex, -1, 4},
      {"left operand", Add(Local(3), At(kL, kL), Local(2)), kIndex, -1, 4},
      {"right operand", Add(Local(3), Local(2), At(kL, kL)), kIndex, -1, 4},
      {"double right operand",
       Binary(BinaryOperator::kAdd, kDouble, Local(2), At(kL, kL), Local(3)), kIndex, -1, 4},
      {"target", Add(At(kL, kL), Local(2), Local(3)), kIndex, -1, 4},
      {"return value", Return(kAlways, At(kL, kL)), kIndex, -1, 4},
      {"command argument", Command(kDelay, {At(kL, kL)}), kIndex, -1, 4},
      {"command output", Command(kHalve, {At(kL, kL)}), kIndex, -1, 4},
      {"command storage", Command(kAddToEach, {Local(1000), Local(4), ImmediateInt(1)}),
       Fault::kOutputBeyondStorage, 25, 24},
  };
}

TEST_F(FaultTest, StopsTheThreadAtItsStatementAndChangesNothing) {
  for (const FaultCase& c : Cases()) {
    SCOPED_TRACE(c.name);
    Load({MakeFunction({Goto(1), c.statement, Goto(-1)})});
    for (const bool global : {false, true}) {
      for (uint16_t id = 0; id < 12; ++id) machine_.WriteRaw({global, 0, id}, 70000 + id);
      machine_.WriteRaw({global, 0, 0}, -1);
      machine_.WriteRaw({global, 0, 1}, 0);
      machine_.WriteRaw({global, 0, 4}, 25);
    }
    Start(0);
    const MachineState before = machine_.state();
    EXPECT_EQ(machine_.Execute(10), 2) << "the statement that faults counts";
    EXPECT_EQ(machine_.last_stop(), Stop::kIdle);
    const ThreadState& thread = machine_.thread(0);
    EXPECT_EQ(thread.run, ThreadRun::kFaulted);
    EXPECT_EQ(thread.error, static_cast<int16_t>(c.fault));
    EXPECT_EQ(thread.fault_value, c.value);
    EXPECT_EQ(thread.fault_limit, c.limit);
    EXPECT_EQ(thread.pc, 1);
    EXPECT_EQ(machine_.Line(0), 20);
    EXPECT_EQ(machine_.state().globals, before.globals);
    EXPECT_EQ(machine_.state().pages[0], before.pages[0]);
  }
}

TEST_F(FaultTest, FaultCodesAreAboveTheCardsOwn) {
  EXPECT_EQ(static_cast<int>(Fault::kDivisionByZero), 100);
  EXPECT_EQ(static_cast<int>(Fault::kIndexOutOfBounds), 101);
  EXPECT_EQ(static_cast<int>(Fault::kOutputBeyondStorage), 102);
}

TEST_F(FaultTest, IndicesAreCheckedAtBothEnds) {
  const struct {
    int32_t index;
    bool faults;
  } kCases[] = {{0, false},    {3, false},        {4, true},        {-1, true},
                {65536, true}, {INT32_MAX, true}, {INT32_MIN, true}};
  for (const auto& c : kCases) {
    LoadAndStart({Set(At(kL, kL), ImmediateInt(5))});
    SetLocalInt(0, 0, c.index);
    machine_.Execute(1);
    EXPECT_EQ(machine_.thread(0).run == ThreadRun::kFaulted, c.faults) << c.index;
    EXPECT_EQ(machine_.thread(0).fault_value, c.faults ? c.index : 0);
  }
}

TEST_F(FaultTest, FaultsAreCounted) {
  LoadAndStart({Set(At(kL, kL), ImmediateInt(5))});
  SetLocalInt(0, 0, -1);
  EXPECT_EQ(machine_.state().faults, 0);
  machine_.Execute(1);
  EXPECT_EQ(machine_.state().faults, 1);
  machine_.Run(0);
  machine_.Execute(1);
  EXPECT_EQ(machine_.state().faults, 2);
}

TEST_F(FaultTest, OtherThreadsRunOn) {
  Load({MakeFunction({Binary(BinaryOperator::kDivide, kInt, Local(0), Local(1), Local(0))}),
        MakeFunction({Add(Local(0), Local(0), ImmediateInt(1)), Goto(-1)})});
  Start(0, 1);
  Start(1, 2);
  EXPECT_EQ(machine_.Execute(101), 101);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kFaulted);
  EXPECT_EQ(LocalInt(1, 0), 50);
}

TEST_F(FaultTest, FaultedThreadCanBeStartedOrBoundAgain) {
  LoadAndStart({Binary(BinaryOperator::kDivide, kInt, Local(0), Local(1), Local(0))});
  machine_.Execute(1);
  EXPECT_TRUE(machine_.Quiet());
  EXPECT_EQ(machine_.Pause(0), kRefused);
  EXPECT_EQ(machine_.StopThread(0), kOk);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kFaulted) << "stopping keeps the reason";
  SetLocalInt(0, 1, 1);
  EXPECT_EQ(machine_.Run(0), kOk);
  EXPECT_EQ(machine_.thread(0).error, 0);
  EXPECT_EQ(machine_.Execute(10), 1);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kStopped);
  EXPECT_EQ(machine_.Bind(0, 1, 4), kOk);
}

TEST_F(FaultTest, FaultEndsPeriodicStarts) {
  Load({MakeFunction({Binary(BinaryOperator::kDivide, kInt, Local(0), Local(1), Local(0))})});
  machine_.Bind(0, 1, 0);
  machine_.RunPeriodic(0, 4, 4);
  machine_.Execute(1);
  machine_.BeginCycle(4);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kFaulted);
  EXPECT_TRUE(machine_.Quiet());
}

}  // namespace
}  // namespace oncard::vm
