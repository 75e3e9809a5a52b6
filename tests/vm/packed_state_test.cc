#include "vm/packed_state.h"

#include <gtest/gtest.h>

#include "tests/vm/program_builder.h"
#include "tests/vm/random_program.h"

namespace oncard::vm {
namespace {

using PackedStateTest = MachineTest;

TEST_F(PackedStateTest, AMachineContinuesFromItAsFromTheStateItself) {
  const auto scratch = std::make_unique<MachineState>();
  for (const char* policy : {"rr:4", "priority", "random:11", "pct:11:5:200"}) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
      RandomNumbers random(seed);
      const RandomProgram program = MakeRandomProgram(random);
      StartProgram(program, ParsePolicy(policy).value(), commands_, &machine_);
      machine_.Execute(random.Between(1, 100));
      const PackedState packed(machine_.state());
      const uint64_t hash = machine_.Hash();
      machine_.Execute(100);
      const uint64_t later = machine_.Hash();
      packed.Unpack(scratch.get());
      machine_.Restore(*scratch);
      EXPECT_EQ(machine_.Hash(), hash) << policy << ' ' << seed;
      machine_.Execute(100);
      EXPECT_EQ(machine_.Hash(), later) << policy << ' ' << seed;
    }
  }
}

TEST_F(PackedStateTest, PagesThatWereNotInUseAreEmptied) {
  const PackedState empty(machine_.state());
  machine_.WriteRaw({false, 7, 3, DataType::kInt}, 5);
  MachineState state = machine_.state();
  empty.Unpack(&state);
  EXPECT_EQ(state.pages[7][3], 0);
}

TEST_F(PackedStateTest, EqualVariablesArePackedEqually) {
  MachineState state = machine_.state();
  PackedVariables before;
  before.Pack(state);
  EXPECT_TRUE(before.Globals().empty());
  state.globals[20] = 5;
  state.pages.Use(3)[900] = -1;
  PackedVariables packed;
  packed.Pack(state);
  EXPECT_EQ(packed.Globals()[20], 5);
  EXPECT_LT(packed.Globals().size(), 30u);
  EXPECT_EQ(packed.used_pages, 8u);
  state.globals[20] = 0;
  state.pages.Use(3)[900] = 0;
  state.pages.Use(4);
  packed.Pack(state);
  EXPECT_EQ(packed.slots, before.slots);
  EXPECT_EQ(packed.used_pages, 0u);
}

}  // namespace
}  // namespace oncard::vm
