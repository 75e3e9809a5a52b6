// The state of the GTS family: what its hash includes, what a reset keeps, and the values that
// paths write.
#include "gtcalls/gts/gts_state.h"

#include <gtest/gtest.h>

#include "gtcalls/gts/buffered_values.h"
#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(GtsState, HashSeesEveryPart) {
  const auto changed = [](auto change) {
    FamilyState state = GtsFamily().new_state();
    const uint64_t before = motion::StateHash().Add(state).value();
    change(*std::get_if<GtsState>(&state));
    return motion::StateHash().Add(state).value() != before;
  };
  EXPECT_TRUE(changed([](GtsState& s) { s.long_vars[3] = 1; }));
  EXPECT_TRUE(changed([](GtsState& s) { s.double_vars[3] = 1e-300; }));
  EXPECT_TRUE(changed([](GtsState& s) { s.mram.SetWord(5, 1); }));
  EXPECT_TRUE(changed([](GtsState& s) { s.plc.Bind({.function = FlankBlock{}}); }));
  EXPECT_TRUE(changed([](GtsState& s) { s.plc.functions.resize(1); }));
  EXPECT_FALSE(changed([](GtsState&) {}));
}

TEST(GtsState, ResetClearsEverythingButTheMemory) {
  FamilyState family_state = GtsFamily().new_state();
  GtsState& state = *std::get_if<GtsState>(&family_state);
  state.mram.SetWord(4, 99);
  state.mram.Start(0, 4, 1, MramAccess::kWrite);
  state.mram.Advance(1000);
  state.long_vars[1023] = 5;
  state.double_vars[0] = 2.5;
  state.plc.Bind({.function = FlankBlock{}});
  GtsFamily().reset(family_state);
  EXPECT_EQ(state.long_vars[1023], 0);
  EXPECT_EQ(state.double_vars[0], 0);
  EXPECT_TRUE(state.plc.blocks.empty());
  EXPECT_EQ(state.mram.Word(4), 0) << "the buffer";
  state.mram.Start(0, 4, 1, MramAccess::kRead);
  state.mram.Advance(1000);
  EXPECT_EQ(state.mram.Word(4), 99) << "the memory";
}

TEST(BufferedValues, AreTheSameAfterTheirWayThroughAPath) {
  const vm::SlotAddress local = {.page = 31, .id = 1023, .type = vm::DataType::kDouble};
  const vm::SlotAddress global = {.global = true, .id = 7, .type = vm::DataType::kInt};
  for (const BufferedValue& value : {BufferedValue{ValueTarget::kLong, 1023, -2147483648.0, {}},
                                     BufferedValue{ValueTarget::kDouble, 0, 0.1, {}},
                                     BufferedValue{ValueTarget::kProgram, 0, 2.5, local},
                                     BufferedValue{ValueTarget::kProgram, 0, -1, global}}) {
    const BufferedValue back = DecodeValue(EncodeValue(value));
    EXPECT_EQ(back.target, value.target);
    EXPECT_EQ(back.index, value.index);
    EXPECT_EQ(back.value, value.value);
    EXPECT_EQ(back.slot.global, value.slot.global);
    EXPECT_EQ(back.slot.page, value.slot.page);
    EXPECT_EQ(back.slot.id, value.slot.id);
    EXPECT_EQ(back.slot.type, value.slot.type);
  }
}

TEST(BufferedValues, AreWrittenInTheCycleInWhichThePathReachesThem) {
  CommandTestCard card;
  card.LoadTestProgram();
  for (const BufferedValue& value :
       {BufferedValue{ValueTarget::kLong, 7, -5, {}},
        BufferedValue{ValueTarget::kDouble, 8, 2.5, {}},
        BufferedValue{ValueTarget::kProgram, 0, 6, {.global = true, .id = 0}}}) {
    ChangeState(card.motion).reached.push_back(EncodeValue(value));
  }
  card.Cycle();
  EXPECT_EQ(card.state().long_vars[7], -5);
  EXPECT_EQ(card.state().double_vars[8], 2.5);
  EXPECT_EQ(card.machine.state().globals[0], 6);
  EXPECT_TRUE(card.motion.state().reached.empty());
}

}  // namespace
}  // namespace oncard::gtcalls::gts
