// Buffered commands: their ranges, and their effects between segments.
#include <gtest/gtest.h>

#include "tests/gtcalls/crd_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(Buffered, EveryCommandChecksItsRanges) {
  CrdCommandCard card;
  card.SetUp();
  struct {
    const char* name;
    std::vector<Argument> arguments;
    int code;
  } const cases[] = {{"GT_BufIO", {1, 12, 3, 1, 0}, 0},
                     {"GT_BufIO", {1, 13, 3, 1, 0}, 7},
                     {"GT_BufEnableDoBitPulse", {1, 12, 16, 1, 1, 0, 1, 0}, 0},
                     {"GT_BufEnableDoBitPulse", {1, 12, 1, 0, 1, 0, 1, 0}, 7},
                     {"GT_BufEnableDoBitPulse", {1, 12, 1, 1, 0, 0, 1, 0}, 7},
                     {"GT_BufEnableDoBitPulse", {1, 12, 1, 1, 1, -1, 1, 0}, 7},
                     {"GT_BufDisableDoBitPulse", {1, 12, 16, 0}, 0},
                     {"GT_BufDisableDoBitPulse", {1, 12, 17, 0}, 7},
                     {"GT_BufDelay", {1, 16383, 0}, 0},
                     {"GT_BufDelay", {1, 16384, 0}, 7},
                     {"GT_BufDA", {1, 8, 32767, 0}, 0},
                     {"GT_BufDA", {1, 8, -32768, 0}, 7},
                     {"GT_BufLmtsOn", {1, 1, -1, 0}, 0},
                     {"GT_BufLmtsOff", {1, 1, 2, 0}, 7},
                     {"GT_BufLmtsOff", {1, 1, 1, 0}, 0},
                     {"GT_BufSetStopIo", {1, 1, 0, 4, 16, 0}, 0},
                     {"GT_BufSetStopIo", {1, 1, 0, 4, 17, 0}, 7},
                     {"GT_BufSetStopIo", {1, 1, 0, 4, 0, 0}, 7},
                     {"GT_BufMove", {1, 3, 100, 10, 1, 1, 0}, 0},
                     {"GT_BufMove", {1, 3, 100, 0, 1, 1, 0}, 7},
                     {"GT_BufMove", {1, 3, 100, 10, 0, 1, 0}, 7},
                     {"GT_BufMove", {1, 1, 100, 10, 1, 1, 0}, 1},
                     {"GT_BufGear", {1, 3, 100, 0}, 0},
                     {"GT_BufGear", {1, 2, 100, 0}, 1},
                     {"GT_BufGearPercent", {1, 3, 100, 50, 50, 0}, 0},
                     {"GT_BufGearPercent", {1, 3, 100, 51, 50, 0}, 7},
                     {"GT_BufGearPercent", {1, 2, 100, 10, 10, 0}, 1},
                     {"GT_BufStopMotion", {1, 0}, 0},
                     {"GT_BufSynchPrfPos", {1, 1, 3, 0}, 0},
                     {"GT_BufComparePulse", {1, 1, 0, 100, 0}, 0},
                     {"GT_BufComparePulse", {1, 0, 0, 100, 0}, 7},
                     {"GT_BufComparePulse", {1, 1, 0, 0, 0}, 7},
                     {"GT_BufSetLongVar", {1, 1023, 5, 0}, 0},
                     {"GT_BufSetLongVar", {1, 1024, 5, 0}, 7},
                     {"GT_BufSetDoubleVar", {1, 0, 0.5, 0}, 0}};
  for (const auto& c : cases) {
    const double space = card.ReadFifo("GT_CrdSpace");
    EXPECT_EQ(card.Call(c.name, c.arguments), c.code) << c.name;
    // Each occupies one place.
    EXPECT_EQ(space - card.ReadFifo("GT_CrdSpace"), c.code == 0 ? 1 : 0) << c.name;
  }
}

TEST(Buffered, NeedACoordinateSystem) {
  CrdCommandCard card;
  card.ExpectRefused(1, "GT_BufDelay", {1, 10, 0});
  card.ExpectRefused(1, "GT_BufGear", {1, 3, 100, 0});
}

TEST(Buffered, ActBetweenSegments) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Line(100, 0), 0);
  EXPECT_EQ(card.Call("GT_BufIO", {1, 12, 1, 1, 0}), 0);
  EXPECT_EQ(card.Call("GT_BufDelay", {1, 30, 0}), 0);
  EXPECT_EQ(card.Call("GT_BufGear", {1, 3, 50, 0}), 0);
  EXPECT_EQ(card.Line(200, 0), 0);
  EXPECT_EQ(card.Call("GT_SetDo", {12, 0}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  const auto output = [&] { return card.motion.state().io.Register(motion::DoType::kGpo) & 1; };
  card.Cycles(19);
  EXPECT_EQ(output(), 0u);
  card.Cycle();
  EXPECT_EQ(output(), 1u);
  card.Cycles(30);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 100);
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 200);
  EXPECT_EQ(card.Read("GT_GetPrfPos", 3), 50);
}

TEST(Buffered, APulseOrALevelIsPutOutBetweenSegments) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Line(100, 0), 0);
  EXPECT_EQ(card.Call("GT_BufComparePulse", {1, 1, 0, 1500, 0}), 0);
  EXPECT_EQ(card.Line(200, 0), 0);
  EXPECT_EQ(card.Call("GT_BufComparePulse", {1, 1, 1, 0, 0}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  const auto output = [&] {
    return card.motion.state().compare.output(1).Level(card.motion.now());
  };
  card.Cycles(19);
  EXPECT_FALSE(output());
  // 1500 us from the cycle in which the first segment ends.
  card.Cycle();
  EXPECT_TRUE(output());
  card.Cycle();
  EXPECT_TRUE(output());
  card.Cycle();
  EXPECT_FALSE(output());
  card.CyclesToEnd();
  EXPECT_TRUE(output());
}

}  // namespace
}  // namespace oncard::gtcalls::gts
