// The bits of the status word have the positions in the GTS manual (chapter 6 and the description
// of GT_GetSts).
#include "gtcalls/gts/status_word.h"

#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(StatusWord, HasTheLatchedConditionsAtTheirPlaces) {
  const struct {
    motion::AxisCondition condition;
    uint32_t word;
  } cases[] = {{motion::kAlarmBit, 0x002},         {motion::kFollowingErrorBit, 0x010},
               {motion::kPositiveLimitBit, 0x020}, {motion::kNegativeLimitBit, 0x040},
               {motion::kSmoothStopBit, 0x080},    {motion::kAbruptStopBit, 0x100}};
  CommandTestCard card;
  uint32_t all = 0;
  for (const auto& c : cases) {
    ChangeState(card.motion).axes[2].latched = c.condition;
    EXPECT_EQ(card.card.view().StatusWord(2), c.word) << c.word;
    EXPECT_EQ(card.card.view().StatusWord(1), 0u) << "another axis";
    all |= c.condition;
  }
  ChangeState(card.motion).axes[2].latched = all;
  EXPECT_EQ(card.card.view().StatusWord(2), 0x1f2u);
}

TEST(StatusWord, ShowsTheDriveAndTheMotion) {
  CommandTestCard card;
  motion::Axis& axis = ChangeState(card.motion).axes[0];
  EXPECT_EQ(card.card.view().StatusWord(0), 0u);
  axis.servo_on = true;
  EXPECT_EQ(card.card.view().StatusWord(0), 0x200u);
  axis.in_position = true;
  EXPECT_EQ(card.card.view().StatusWord(0), 0xa00u);
  ChangeState(card.motion).profiles[0].now.moving = true;
  EXPECT_EQ(card.card.view().StatusWord(0), 0x600u) << "a moving axis is not in position";
}

TEST(StatusWord, IsWhatGtGetStsGives) {
  CommandTestCard card;
  ChangeState(card.motion).axes[0].latched = motion::kAlarmBit;
  ChangeState(card.motion).axes[1].servo_on = true;
  std::vector<double> words(2);
  card.Expect(0, "GT_GetSts", {1, &words, 2, nullptr});
  EXPECT_EQ(words, (std::vector<double>{0x002, 0x200}));
}

}  // namespace
}  // namespace oncard::gtcalls::gts
