// Captures of GE axes. Source: GE manual chapter 7.
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/ge_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::DiType;

TEST(GeCapture, IsArmedOnceUntilItsEventIsCleared) {
  GeTestCard card;
  card.SetInput(DiType::kHome, 0, true);
  card.Do("GT_CaptHome", {1});
  for (const char* command : {"GT_CaptHome", "GT_CaptIndex"}) {
    card.Refuses(1, kCaptureBusy, command, {1});
  }
  card.Do("GT_SetAtlPos", {1, 321});
  ChangeState(card.motion).capture.Edge(DiType::kHome, 0, false, [](size_t) { return 320.75; });
  EXPECT_TRUE(card.StatusBit(1, 3));
  EXPECT_FALSE(card.StatusBit(1, 14));
  EXPECT_EQ(card.Read("GT_GetCapt", {1}), 321);
  card.Refuses(1, kCaptureBusy, "GT_CaptIndex", {1});
  card.Do("GT_RstSts", {1, 0x77});
  EXPECT_FALSE(card.StatusBit(1, 3));
  card.Do("GT_CaptIndex", {1});
  EXPECT_TRUE(card.StatusBit(1, 15));
  EXPECT_EQ(card.Read("GT_GetCapt", {1}), 321) << "stays until the next capture";
}

TEST(GeCapture, OfTheHomeInputIsByDefaultAtTheFallingEdge) {
  const struct {
    double sense;
    bool rising;
  } cases[] = {{0, false}, {4, true}, {3, false}};
  for (const auto& c : cases) {
    GeTestCard card;
    card.Do("GT_HomeSns", {c.sense});
    card.Do("GT_CaptHome", {3});
    auto& captures = card.motion.capture();
    captures.Edge(DiType::kHome, 2, !c.rising, [](size_t) { return 1.0; });
    EXPECT_FALSE(card.StatusBit(3, 3)) << c.sense;
    captures.Edge(DiType::kHome, 2, c.rising, [](size_t) { return 2.0; });
    EXPECT_TRUE(card.StatusBit(3, 3)) << c.sense;
    EXPECT_EQ(card.Read("GT_GetCapt", {3}), 2) << c.sense;
  }
}

}  // namespace
}  // namespace oncard::gtcalls::ge
