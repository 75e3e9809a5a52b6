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

}  // namespace
}  // namespace oncard::vm
