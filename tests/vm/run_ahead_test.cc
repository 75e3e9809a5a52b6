// The machine compared with the reference machine: after any number of statements its state must be
// that of plain interleaving, however it is optimised, and a recording must have the same order.
#include <gtest/gtest.h>

#include "tests/base/random_cases.h"
#include "tests/vm/program_builder.h"
#include "tests/vm/random_program.h"
#include "tests/vm/reference_machine.h"

namespace oncard::vm {
namespace {

enum class Recorded : uint8_t { kNo, kYes };

// Both machines with the same program in the same state.
class Pair {
 public:
  Pair(const Object& object, int64_t quantum, Recorded recorded = Recorded::kNo)
      : reference(object, quantum), recorded_(recorded), machine(&commands_) {
    if (recorded == Recorded::kYes) machine.Record(&recording_);
    Policy policy;
    policy.quantum = quantum;
    machine.SetPolicy(policy);
    machine.Load(LinkRecords(object, commands_));
  }

  void Write(const SlotAddress& slot, int64_t raw) {
    machine.WriteRaw(slot, raw);
    (slot.global ? reference.globals[slot.id] : reference.pages[slot.page][slot.id]) = raw;
  }

  void Bind(const RandomProgram::Binding& binding) {
    ASSERT_EQ(machine.Bind(binding.thread, binding.function + 1, binding.page), kOk);
    reference.Bind(static_cast<size_t>(binding.thread), static_cast<size_t>(binding.function),
                   static_cast<size_t>(binding.page));
  }

  void Run(int thread) {
    ASSERT_EQ(machine.Run(thread), kOk);
    reference.Start(static_cast<size_t>(thread));
  }

  void BeginCycle(int64_t cycle) {
    machine.BeginCycle(cycle);
    reference.BeginCycle(cycle);
  }

  // True if both execute the same number of statements and are in the same state afterwards.
  testing::AssertionResult Execute(int64_t budget) {
    const int64_t expected = reference.Execute(budget);
    const int64_t executed = machine.Execute(budget);
    if (executed != expected) {
      return testing::AssertionFailure() << executed << " executed, reference " << expected;
    }
    const Stop stop = expected == budget ? Stop::kBudget : Stop::kIdle;
    if (machine.last_stop() != stop) return testing::AssertionFailure() << "wrong reason to stop";
    const std::string difference = reference.Difference(machine);
    if (!difference.empty()) return testing::AssertionFailure() << difference;
    if (recorded_ == Recorded::kYes && ScheduleOf(recording_).segments != reference.segments) {
      return testing::AssertionFailure() << "another order has been recorded";
    }
    return testing::AssertionSuccess();
  }

  ReferenceMachine reference;

 private:
  ThreadCommands commands_;
  Recorded recorded_;
  Recording recording_;

 public:
  Machine machine;
};

int64_t RandomBudget(RandomNumbers& random) {
  switch (random.Between(0, 9)) {
    case 0:
      return 1;
    case 1:
    case 2:
    case 3:
      return random.Between(1, 12);
    case 4:
      return random.OneIn(5) ? random.Between(1, 9000) : random.Between(1, 1000);
    default:
      return random.Between(1, 150);
  }
}

// Runs a program in random pieces, while the clock advances and ended threads start again.
testing::AssertionResult RunInPieces(uint64_t seed, int64_t quantum, Recorded recorded) {
  RandomNumbers random(seed);
  const RandomProgram program = MakeRandomProgram(random);
  Pair pair(program.object, quantum, recorded);
  for (const auto& value : program.values) pair.Write(value.slot, value.raw);
  for (const auto& binding : program.bindings) {
    pair.Bind(binding);
    pair.Run(binding.thread);
  }
  int64_t cycle = 0;
  for (int piece = 0; piece < 12; ++piece) {
    auto same = pair.Execute(RandomBudget(random));
    if (!same) return same << " (seed " << seed << ", piece " << piece << ")";
    if (random.OneIn(2)) pair.BeginCycle(++cycle);
    for (const auto& binding : program.bindings) {
      const ThreadRun run = pair.machine.thread(binding.thread).run;
      const bool ended = run == ThreadRun::kStopped || run == ThreadRun::kFaulted;
      if (!ended || !random.OneIn(2)) continue;
      pair.Write({false, pair.machine.thread(binding.thread).page, 6}, random.Between(0, 7));
      pair.Run(binding.thread);
    }
  }
  return testing::AssertionSuccess();
}

class RandomPrograms : public testing::TestWithParam<int64_t> {};

TEST_P(RandomPrograms, EndInTheReferenceStateAfterEveryPiece) {
  const int64_t quantum = GetParam();
  const auto programs = RandomCases(uint64_t{quantum == 1 ? 3000u : 500u});
  for (uint64_t number = 1; number <= programs; ++number) {
    const uint64_t seed = number * 1000 + static_cast<uint64_t>(quantum);
    const Recorded recorded = number % 2 == 0 ? Recorded::kYes : Recorded::kNo;
    ASSERT_TRUE(RunInPieces(seed, quantum, recorded));
  }
}

INSTANTIATE_TEST_SUITE_P(Quanta, RandomPrograms, testing::Values(1, 2, 3, 7, 1000));

// Two threads in private loops of different lengths, with one shared statement each.
TEST(RunAheadTest, ManyWindowsOfPrivateWorkBetweenSharedStatements) {
  const auto loop = [](int32_t rounds, BinaryOperator shared) {
    return MakeFunction({
        Set(Local(0), ImmediateInt(0)),
        Binary(BinaryOperator::kGreaterEqual, DataType::kInt, Local(0), ImmediateInt(rounds),
               Local(1)),
        Jump(Local(1), 4),
        Add(Local(2), Local(2), Local(0)),
        Add(Local(0), Local(0), ImmediateInt(1)),
        Goto(-4),
        Binary(shared, DataType::kInt, Global(0), ImmediateInt(3), Global(0)),
        Goto(-7),
    });
  };
  const Object object =
      MakeObject({loop(700, BinaryOperator::kAdd), loop(113, BinaryOperator::kMultiply)});
  Pair pair(object, 1, Recorded::kYes);
  pair.Bind({4, 0, 9});
  pair.Bind({2, 1, 0});
  pair.Run(4);
  pair.Run(2);
  for (const int64_t budget : {1, 2047, 2048, 2049, 4096, 7001, 20000, 3, 50001}) {
    ASSERT_TRUE(pair.Execute(budget)) << budget;
  }
}

// Threads whose statements nearly all access shared data, so that the machine changes the thread
// after each one: what ends or holds up a thread comes at another round for each of them, and at
// another statement of the round.
class SharedWork : public testing::TestWithParam<Instruction> {};

TEST_P(SharedWork, ContinuesWithTheOtherThreadsWhereOneIsHeldUp) {
  constexpr Variable kCountdown = Local(0);
  const Function function = MakeFunction({
      Add(Global(0), Global(0), ImmediateInt(3)),
      Binary(BinaryOperator::kXor, DataType::kInt, Global(0), Global(1), Global(2)),
      Binary(BinaryOperator::kSubtract, DataType::kInt, kCountdown, ImmediateInt(1), kCountdown),
      Jump(kCountdown, -3),
      GetParam(),
      Set(kCountdown, ImmediateInt(700)),
      Add(Global(1), Global(1), Global(0)),
      Goto(-7),
  });
  const Object object = MakeObject({function});
  for (const int threads : {2, 5, 32}) {
    Pair pair(object, 1, threads == 5 ? Recorded::kYes : Recorded::kNo);
    for (int thread = 0; thread < threads; ++thread) {
      pair.Bind({thread, 0, 31 - thread});
      pair.Write({false, static_cast<uint8_t>(31 - thread), 0}, 400 + 37 * thread);
      pair.Run(thread);
    }
    for (const int64_t rounds : {1, 1024, 2049, 3000, 5000, 9001}) {
      ASSERT_TRUE(pair.Execute(rounds * threads + 1)) << threads << " threads, " << rounds;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Statements, SharedWork,
    testing::Values(Return(kAlways, Global(0)), Return(Local(0), ImmediateInt(1)), Goto(1),
                    Binary(BinaryOperator::kDivide, DataType::kInt, Global(0), Local(0), Global(3)),
                    Set(Element{Storage::kLocal, 8, 4, Global(0)}, ImmediateInt(1)),
                    Command(kWaitFor, {Global(0), ImmediateInt(30000)}),
                    Command(kDelay, {ImmediateInt(5)}), Command(kUsePage, {ImmediateInt(40)}),
                    Command(kAddToEach, {Global(8), ImmediateInt(2), ImmediateInt(1)})));

// The flag is 1 for only one statement of another thread; the waiting thread has its turn then.
TEST(RunAheadTest, WaitingThreadSeesWhatHoldsAtItsTurn) {
  const Object object = MakeObject({
      MakeFunction({Set(Global(0), ImmediateInt(1)), Set(Global(0), ImmediateInt(0)), Goto(-2)}),
      MakeFunction({Command(kWaitFor, {Global(0), ImmediateInt(1)}),
                    Add(Local(0), Local(0), ImmediateInt(1)), Goto(-2)}),
      MakeFunction({Command(kWaitFor, {Global(0), ImmediateInt(1)})}),
  });
  for (const int64_t piece : {1, 2, 5, 17, 400}) {
    Pair pair(object, 1, Recorded::kYes);
    for (int thread = 0; thread < 3; ++thread) {
      pair.Bind({thread, thread, thread});
      pair.Run(thread);
    }
    for (int i = 0; i < 40; ++i) ASSERT_TRUE(pair.Execute(piece)) << piece;
  }
}

// The last statement waits for a value that exists for only one statement, which is enough.
TEST(RunAheadTest, WaitAtTheEndOfAFunctionEndsAsSoonAsTheValueHolds) {
  const Object object = MakeObject({
      MakeFunction({Command(kWaitFor, {Global(0), ImmediateInt(1)})}),
      MakeFunction({Goto(1), Goto(1), Set(Global(0), ImmediateInt(1)), Goto(-1)}),
      MakeFunction({Goto(1), Goto(1), Set(Global(0), ImmediateInt(0)), Goto(-1)}),
  });
  for (const int64_t piece : {1, 3, 40}) {
    Pair pair(object, 1, Recorded::kYes);
    for (int thread = 0; thread < 3; ++thread) {
      pair.Bind({thread, thread, thread});
      pair.Run(thread);
    }
    for (int i = 0; i < 40; ++i) ASSERT_TRUE(pair.Execute(piece)) << piece;
    EXPECT_EQ(pair.machine.thread(0).run, ThreadRun::kStopped);
  }
}

}  // namespace
}  // namespace oncard::vm
