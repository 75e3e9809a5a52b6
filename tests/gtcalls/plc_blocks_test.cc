// The semantics of each PLC block, evaluated directly.
#include "gtcalls/gts/plc_blocks.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

// Ints among the globals of the test program: g, and ga[0..2].
constexpr uint16_t kOut = 0;
constexpr uint16_t kIn = 2;
constexpr uint16_t kIn2 = 3;

vm::SlotAddress Global(uint16_t id) { return {.global = true, .id = id}; }

class PlcBlocksTest : public testing::Test {
 protected:
  PlcBlocksTest() { card_.LoadTestProgram(); }

  void Bind(const PlcFunction& function, uint16_t variable = kOut, int16_t thread = -1) {
    ASSERT_TRUE(
        card_.state().plc.Bind({.thread = thread, .variable = variable, .function = function}));
  }
  void Put(uint16_t id, int64_t value) { card_.machine.WriteRaw(Global(id), value); }
  int64_t Read(uint16_t id) { return card_.machine.ReadRaw(Global(id)); }
  void Evaluate() { card_.state().plc.Evaluate(card_.machine, card_.motion); }

  /// Evaluates once for each character of the inputs ('1' = on); returns the variable after each.
  std::string Trace(std::string_view first, std::string_view second = {}) {
    std::string outputs;
    for (size_t i = 0; i < first.size(); ++i) {
      Put(kIn, first[i] == '1' ? 5 : 0);
      if (!second.empty()) Put(kIn2, second[i] == '1' ? -1 : 0);
      Evaluate();
      outputs += Read(kOut) == 0 ? '0' : '1';
    }
    return outputs;
  }

  CommandTestCard card_;
};

TEST_F(PlcBlocksTest, DiCopiesAnInputOrItsComplement) {
  Bind(DiBlock{.type = motion::DiType::kHome, .bit = 2}, kOut);
  Bind(DiBlock{.type = motion::DiType::kHome, .bit = 2, .reverse = true}, kIn);
  Evaluate();
  EXPECT_EQ(Read(kOut), 0);
  EXPECT_EQ(Read(kIn), 1);
  card_.motion.digital_io().SetPin(motion::DiType::kHome, 2, true);
  for (int i = 0; i < 3; ++i) card_.motion.Tick();
  Evaluate();
  EXPECT_EQ(Read(kOut), 1);
  EXPECT_EQ(Read(kIn), 0);
}

TEST_F(PlcBlocksTest, DoCopiesAVariableOrItsComplement) {
  Bind(DoBlock{.type = motion::DoType::kGpo, .bit = 0}, kIn);
  Bind(DoBlock{.type = motion::DoType::kGpo, .bit = 15, .reverse = true}, kIn);
  Evaluate();
  EXPECT_EQ(card_.motion.state().io.Register(motion::DoType::kGpo), 0x8000u);
  Put(kIn, 7);
  Evaluate();
  EXPECT_EQ(card_.motion.state().io.Register(motion::DoType::kGpo), 0x0001u);
}

// A cycle is 250 us: a delay of 1 ms is four cycles from the first one that has the new value.
TEST_F(PlcBlocksTest, OnDelayDelaysOnlyTheRise) {
  Bind(TimerBlock{.type = TimerType::kOnDelay, .input = kIn, .delay_us = 1000});
  EXPECT_EQ(Trace("0111111100"), "0000011100");
}

TEST_F(PlcBlocksTest, OffDelayDelaysOnlyTheFall) {
  Bind(TimerBlock{.type = TimerType::kOffDelay, .input = kIn, .delay_us = 1000});
  EXPECT_EQ(Trace("0110000000"), "0111111000");
}

TEST_F(PlcBlocksTest, BothDelaysDelayRiseAndFall) {
  Bind(TimerBlock{.type = TimerType::kBoth, .input = kIn, .delay_us = 500});
  EXPECT_EQ(Trace("0111110000"), "0001111100");
}

TEST_F(PlcBlocksTest, AChangeShorterThanTheDelayIsForgotten) {
  Bind(TimerBlock{.type = TimerType::kBoth, .input = kIn, .delay_us = 500});
  EXPECT_EQ(Trace("0110110111"), "0000000001");
}

TEST_F(PlcBlocksTest, DelayOfZeroFollowsAtOnce) {
  Bind(TimerBlock{.type = TimerType::kBoth, .input = kIn, .delay_us = 0});
  EXPECT_EQ(Trace("0101"), "0101");
}

TEST_F(PlcBlocksTest, DelayIsTimeWhateverTheCycle) {
  CommandTestCard slow({.cycle_us = 1000});
  slow.LoadTestProgram();
  slow.state().plc.Bind(
      {.thread = -1, .variable = kOut, .function = TimerBlock{.input = kIn, .delay_us = 2000}});
  slow.machine.WriteRaw(Global(kIn), 1);
  std::string outputs;
  for (int i = 0; i < 4; ++i) {
    slow.state().plc.Evaluate(slow.machine, slow.motion);
    outputs += slow.machine.ReadRaw(Global(kOut)) == 0 ? '0' : '1';
  }
  EXPECT_EQ(outputs, "0011");
}

TEST_F(PlcBlocksTest, FlankIsOneCycleLong) {
  struct {
    Edge edge;
    const char* outputs;
  } const cases[] = {{Edge::kUp, "0100010"}, {Edge::kDown, "0001001"}, {Edge::kBoth, "0101011"}};
  for (const auto& c : cases) {
    card_.state().plc.UnbindAll();
    Bind(FlankBlock{.edge = c.edge, .input = kIn});
    EXPECT_EQ(Trace("0110010"), c.outputs);
  }
}

TEST_F(PlcBlocksTest, FlipFlopKeepsAndResetWins) {
  Bind(SrffBlock{.set = kIn, .reset = kIn2});
  EXPECT_EQ(Trace("0100011", "0001001"), "0110010");
}

TEST_F(PlcBlocksTest, CounterComparesItsCountWithTheTarget) {
  struct {
    CounterType type;
    const char* outputs;  // counts 0 1 1 2 2 3 compared with 2
  } const cases[] = {{CounterType::kEqual, "000110"},
                     {CounterType::kLessEqual, "111110"},
                     {CounterType::kGreaterEqual, "000111"}};
  for (const auto& c : cases) {
    card_.state().plc.UnbindAll();
    Bind(CounterBlock{.type = c.type, .target = 2, .input = kIn});
    EXPECT_EQ(Trace("010101"), c.outputs);
  }
}

TEST_F(PlcBlocksTest, CounterCountsTheEdgesItIsAskedFor) {
  struct {
    Edge edge;
    int32_t count;
  } const cases[] = {{Edge::kUp, 3}, {Edge::kDown, 2}, {Edge::kBoth, 5}};
  for (const auto& c : cases) {
    card_.state().plc.UnbindAll();
    Bind(CounterBlock{.edge = c.edge, .input = kIn});
    Trace("0110101");
    EXPECT_EQ(std::get<CounterBlock>(card_.state().plc.blocks[0].function).count, c.count);
  }
}

TEST_F(PlcBlocksTest, CounterCountsOncePerUnit) {
  Bind(CounterBlock{.type = CounterType::kGreaterEqual, .target = 1, .unit = 3, .input = kIn});
  EXPECT_EQ(Trace("01010101"), "00000111");
}

TEST_F(PlcBlocksTest, CounterGoesRoundBetweenBeginAndEnd) {
  Bind(CounterBlock{.target = 1, .begin = 1, .end = 3, .input = kIn, .count = 1});
  EXPECT_EQ(Trace("01010101"), "10000110");  // 1 2 2 3 3 1 1 2
}

TEST_F(PlcBlocksTest, CounterCanCountDownAndGoRound) {
  Bind(CounterBlock{.target = 3, .begin = 1, .end = 3, .down = true, .input = kIn, .count = 2});
  EXPECT_EQ(Trace("0101010"), "0001100");  // 2 1 1 3 3 2 2
}

TEST_F(PlcBlocksTest, CounterWithoutBoundsWrapsAt32Bits) {
  Bind(CounterBlock{.target = INT32_MIN, .input = kIn, .count = INT32_MAX});
  EXPECT_EQ(Trace("01"), "01");
}

TEST_F(PlcBlocksTest, CounterIsHeldAtItsInitialValueByReset) {
  Bind(CounterBlock{.init = 4, .target = 5, .unit = 2, .input = kIn, .reset = kIn2, .count = 4});
  // Edges at 1, 3, 5, 7, 9. The reset at 3 discards the edge counted at 1 and the one at 3.
  EXPECT_EQ(Trace("0101010101", "0001000000"), "0000000111");
}

TEST_F(PlcBlocksTest, InputsComeFirstAndOutputsLast) {
  // Even if they are bound in the worst order, one evaluation passes an input on to an output.
  Bind(DoBlock{.type = motion::DoType::kGpo, .bit = 0}, kOut);
  Bind(TimerBlock{.input = kIn, .delay_us = 0}, kOut);
  Bind(DiBlock{.type = motion::DiType::kGpi, .bit = 0}, kIn);
  card_.motion.digital_io().SetPin(motion::DiType::kGpi, 0, true);
  for (int i = 0; i < 3; ++i) card_.motion.Tick();
  Evaluate();
  EXPECT_EQ(card_.motion.state().io.Register(motion::DoType::kGpo), 1u);
}

TEST_F(PlcBlocksTest, BlocksOfAThreadUseItsPage) {
  ASSERT_EQ(card_.Call("GT_Bind", {4, kLoopFunction, 9}), 0);
  Bind(TimerBlock{.input = 0, .delay_us = 0}, 2, 4);
  card_.machine.WriteRaw({.page = 9, .id = 0}, 1);
  Evaluate();
  EXPECT_EQ(card_.machine.ReadRaw({.page = 9, .id = 2}), 1);
}

TEST_F(PlcBlocksTest, BlocksOfAnUnboundThreadRest) {
  Bind(DiBlock{.reverse = true}, 0, 4);
  const uint64_t before = card_.Hash();
  Evaluate();
  EXPECT_EQ(card_.Hash(), before);
}

TEST_F(PlcBlocksTest, ABlockReplacesTheOneWithTheSameTarget) {
  Bind(FlankBlock{.input = kIn}, kOut);
  Bind(SrffBlock{.set = kIn, .reset = kIn2}, kOut);
  ASSERT_EQ(card_.state().plc.blocks.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<SrffBlock>(card_.state().plc.blocks[0].function));
  Bind(DoBlock{.bit = 1}, kOut);
  Bind(DoBlock{.bit = 2}, kOut);
  EXPECT_EQ(card_.state().plc.blocks.size(), 3u);
  Bind(DoBlock{.bit = 1}, kIn);
  EXPECT_EQ(card_.state().plc.blocks.size(), 3u);
}

TEST_F(PlcBlocksTest, ThereIsRoomForTheirMaximum) {
  for (size_t i = 0; i < kPlcBlockMax; ++i) {
    Bind(FlankBlock{.input = kIn}, static_cast<uint16_t>(i));
  }
  EXPECT_FALSE(card_.state().plc.Bind({.variable = 1000, .function = FlankBlock{}}));
  EXPECT_TRUE(card_.state().plc.Bind({.variable = 0, .function = FlankBlock{}}));
}

TEST_F(PlcBlocksTest, UnbindRemovesTheBlocksOfOneThread) {
  Bind(FlankBlock{}, 0, 1);
  Bind(FlankBlock{}, 0, 2);
  Bind(FlankBlock{}, 0, -1);
  card_.state().plc.Unbind(1);
  ASSERT_EQ(card_.state().plc.blocks.size(), 2u);
  card_.state().plc.Unbind(-1);
  ASSERT_EQ(card_.state().plc.blocks.size(), 1u);
  EXPECT_EQ(card_.state().plc.blocks[0].thread, 2);
}

TEST_F(PlcBlocksTest, HashSeesBlocksAndTheirState) {
  const uint64_t empty = motion::StateHash().Add(card_.state().plc).value();
  Bind(TimerBlock{.input = kIn, .delay_us = 1000});
  const uint64_t bound = motion::StateHash().Add(card_.state().plc).value();
  EXPECT_NE(bound, empty);
  const PlcBlocks kept = card_.state().plc;
  Trace("11");
  EXPECT_NE(motion::StateHash().Add(card_.state().plc).value(), bound);
  card_.state().plc = kept;
  EXPECT_EQ(motion::StateHash().Add(card_.state().plc).value(), bound);
  card_.state().plc.functions.push_back({.id = 1, .return_type = vm::DataType::kInt, .words = {1}});
  EXPECT_NE(motion::StateHash().Add(card_.state().plc).value(), bound);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
