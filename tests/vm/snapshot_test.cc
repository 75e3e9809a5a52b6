// A snapshot is a copy of the state: the machine can continue from it any number of times, and the
// hash distinguishes states.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/vm/program_builder.h"
#include "tests/vm/random_program.h"

namespace oncard::vm {
namespace {

using SnapshotTest = MachineTest;

TEST_F(SnapshotTest, ContinuingTwiceGivesTheSameStates) {
  for (const char* policy : {"rr", "rr:4", "priority", "random:11", "pct:11:5:200"}) {
    for (uint64_t seed = 1; seed <= 40; ++seed) {
      RandomNumbers random(seed);
      const RandomProgram program = MakeRandomProgram(random);
      StartProgram(program, ParsePolicy(policy).value(), commands_, &machine_);
      machine_.Execute(random.Between(1, 100));
      const MachineState snapshot = machine_.state();
      const uint64_t hash = machine_.Hash();
      std::vector<uint64_t> hashes[2];
      for (auto& sequence : hashes) {
        machine_.Restore(snapshot);
        EXPECT_EQ(machine_.Hash(), hash);
        for (const int64_t budget : {1, 30, 7, 200}) {
          machine_.Execute(budget);
          machine_.BeginCycle(machine_.state().cycle + 1);
          sequence.push_back(machine_.Hash());
        }
      }
      EXPECT_EQ(hashes[0], hashes[1]) << policy << ' ' << seed;
    }
  }
}

TEST_F(SnapshotTest, AnotherMachineWithTheSameImageCanGoOn) {
  LoadAndStart({Add(Local(0), Local(0), ImmediateInt(3)), Goto(-1)});
  machine_.Execute(5);
  Machine other(&commands_);
  other.Load(machine_.shared_image());
  other.Restore(machine_.state());
  machine_.Execute(9);
  other.Execute(9);
  EXPECT_EQ(machine_.Hash(), other.Hash());
}

TEST_F(SnapshotTest, HashDependsOnEveryVariable) {
  constexpr uint16_t kIds[] = {0, 1, 511, 1023};
  const uint64_t hash = machine_.Hash();
  for (const bool global : {false, true}) {
    for (int page = 0; page < (global ? 1 : kPageCount); ++page) {
      for (const uint16_t id : kIds) {
        const SlotAddress slot{global, static_cast<uint8_t>(page), id, DataType::kDouble};
        machine_.WriteRaw(slot, 1);
        EXPECT_NE(machine_.Hash(), hash) << global << ' ' << page << ' ' << id;
        machine_.WriteRaw(slot, 0);
      }
    }
  }
  EXPECT_EQ(machine_.Hash(), hash);
}

TEST_F(SnapshotTest, HashDependsOnEveryFieldOfAThreadAndTheCounters) {
  const std::function<void(MachineState&)> changes[] = {
      [](auto& s) { s.threads[31].run = ThreadRun::kStopped; },
      [](auto& s) { s.threads[31].page = 1; },
      [](auto& s) { s.threads[31].function = 1; },
      [](auto& s) { s.threads[31].started = true; },
      [](auto& s) { s.threads[31].pc = 1; },
      [](auto& s) { s.threads[31].error = 1; },
      [](auto& s) { s.threads[31].result_type = DataType::kDouble; },
      [](auto& s) { s.threads[31].result = 1; },
      [](auto& s) { s.threads[31].fault_value = 1; },
      [](auto& s) { s.threads[31].fault_limit = 1; },
      [](auto& s) { s.threads[31].wake_cycle = 1; },
      [](auto& s) { s.threads[31].waiting = true; },
      [](auto& s) { s.threads[31].wait_slot.global = true; },
      [](auto& s) { s.threads[31].wait_slot.page = 1; },
      [](auto& s) { s.threads[31].wait_slot.id = 1; },
      [](auto& s) { s.threads[31].wait_slot.type = DataType::kDouble; },
      [](auto& s) { s.threads[31].wait_value = 1; },
      [](auto& s) { s.threads[31].breakpoint_line = 1; },
      [](auto& s) { s.threads[31].period_cycles = 1; },
      [](auto& s) { s.threads[31].next_start = 1; },
      [](auto& s) { s.threads[31].overruns = 1; },
      [](auto& s) { s.threads[31].priority = 1; },
      [](auto& s) { s.threads[31].executed = 1; },
      [](auto& s) { s.threads[31].executed_max = 1; },
      [](auto& s) { s.executed = 1; },
      [](auto& s) { s.cycle = 1; },
  };
  const MachineState original = machine_.state();
  const uint64_t hash = machine_.Hash();
  std::vector<uint64_t> hashes{hash};
  for (const auto& change : changes) {
    MachineState state = original;
    change(state);
    machine_.Restore(state);
    hashes.push_back(machine_.Hash());
  }
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
}

TEST_F(SnapshotTest, HashDoesNotDependOnThePolicy) {
  const uint64_t hash = machine_.Hash();
  machine_.SetPolicy(ParsePolicy("random:9").value());
  EXPECT_EQ(machine_.Hash(), hash);
}

}  // namespace
}  // namespace oncard::vm
