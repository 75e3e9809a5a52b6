#include "motion/common/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Cycles that record their own number, and ten times that.
class Recording : public ::testing::Test {
 protected:
  void Tick(int count) {
    for (; count > 0; --count) {
      ++cycle_;
      if (recorder_.Due()) recorder_.Append(std::array{cycle_, 10 * cycle_});
    }
  }

  Recorder recorder_;
  double cycle_ = 0;
};

TEST_F(Recording, ABankIsReadWhenItIsFull) {
  recorder_.SetUp(2, 3);
  recorder_.Start(0);
  Tick(2);
  EXPECT_THAT(recorder_.FullBank(), IsEmpty());
  Tick(1);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(1, 10, 2, 20, 3, 30));
  recorder_.FreeBank();
  EXPECT_THAT(recorder_.FullBank(), IsEmpty());
}

TEST_F(Recording, TheBanksTakeTurns) {
  recorder_.SetUp(2, 2);
  recorder_.Start(0);
  Tick(3);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(1, 10, 2, 20));
  recorder_.FreeBank();
  Tick(3);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(3, 30, 4, 40));
  recorder_.FreeBank();
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(5, 50, 6, 60));
}

TEST_F(Recording, WhileBothAreFullRowsAreLost) {
  recorder_.SetUp(2, 1);
  recorder_.Start(0);
  Tick(5);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(1, 10));
  recorder_.FreeBank();
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(2, 20));
  Tick(1);
  recorder_.FreeBank();
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(6, 60));
}

TEST_F(Recording, TheIntervalIsTheNumberOfCyclesLeftOut) {
  recorder_.SetUp(2, 3);
  Tick(7);
  recorder_.Start(3);
  Tick(9);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(8, 80, 12, 120, 16, 160));
}

TEST_F(Recording, LostRowsDoNotShiftTheOthers) {
  recorder_.SetUp(2, 1);
  recorder_.Start(1);
  Tick(6);
  recorder_.FreeBank();
  Tick(3);
  recorder_.FreeBank();
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(7, 70));
}

TEST_F(Recording, AStopKeepsWhatIsFullAndAStartDropsIt) {
  recorder_.SetUp(2, 2);
  Tick(1);
  EXPECT_FALSE(recorder_.running());
  recorder_.Start(0);
  Tick(3);
  recorder_.Stop();
  Tick(3);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(2, 20, 3, 30));
  recorder_.Start(0);
  EXPECT_THAT(recorder_.FullBank(), IsEmpty());
  Tick(2);
  EXPECT_THAT(recorder_.FullBank(), ElementsAre(8, 80, 9, 90));
}

TEST_F(Recording, ASetUpEndsTheRecording) {
  EXPECT_FALSE(recorder_.set_up());
  EXPECT_THAT(recorder_.FullBank(), IsEmpty());
  recorder_.SetUp(2, 1);
  EXPECT_TRUE(recorder_.set_up());
  recorder_.Start(0);
  Tick(1);
  recorder_.SetUp(2, 1);
  Tick(1);
  EXPECT_THAT(recorder_.FullBank(), IsEmpty());
}

TEST_F(Recording, EveryRowIsInTheHash) {
  recorder_.SetUp(2, 2);
  recorder_.Start(0);
  const uint64_t before = StateHash().Add(recorder_).value();
  Tick(1);
  EXPECT_NE(StateHash().Add(recorder_).value(), before);
}

}  // namespace
}  // namespace oncard::motion
