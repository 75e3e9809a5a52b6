// Touch probes: what is captured, and what the status says of it.
#include "motion/bus/touch_probes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/motion/bus/bus_card.h"
#include "tests/motion/change_state.h"

namespace oncard::motion::bus {
namespace {

class Probes : public ::testing::Test {
 protected:
  void Function(uint16_t word) {
    values_.Set(ObjectId::kProbeFunction, word);
    TouchProbes::TakeFunction(values_);
  }
  int64_t status() const { return values_[ObjectId::kProbeStatus]; }
  int64_t rising() const { return values_[ObjectId::kProbe1Rising]; }
  int64_t falling() const { return values_[ObjectId::kProbe1Falling]; }

  ObjectValues values_;
  TouchProbes probes_;
};

TEST_F(Probes, ASingleCaptureKeepsTheFirstEdge) {
  Function(kProbeEnable | kProbeRising);
  EXPECT_EQ(status(), kProbeEnabled);
  probes_.Edge(0, true, 10, values_);
  probes_.Edge(0, false, 20, values_);
  probes_.Edge(0, true, 30, values_);
  EXPECT_EQ(status(), kProbeEnabled | kProbeRisen);
  EXPECT_EQ(rising(), 10);
  EXPECT_EQ(falling(), 0);
}

TEST_F(Probes, AContinuousCaptureTogglesItsBitAtEachEdge) {
  Function(kProbeEnable | kProbeContinuous | kProbeRising);
  const int64_t captured = kProbeEnabled | kProbeRisen;
  for (int i = 0; i < 4; ++i) {
    probes_.Edge(0, true, 10 * i, values_);
    EXPECT_EQ(status(), captured | (i % 2 == 0 ? kProbeRisenAgain : 0)) << i;
    EXPECT_EQ(rising(), 10 * i);
    probes_.Edge(0, false, 5, values_);
  }
}

TEST_F(Probes, TheStatusIsResetByDisablingOnly) {
  Function(kProbeEnable | kProbeRising | kProbeFalling);
  probes_.Edge(0, true, 10, values_);
  probes_.Edge(0, false, 20, values_);
  Function(kProbeEnable | kProbeRising);
  EXPECT_EQ(status(), kProbeEnabled | kProbeRisen | kProbeFallen);
  Function(0);
  EXPECT_EQ(status(), 0);
  EXPECT_EQ(rising(), 10);
  Function(kProbeEnable | kProbeRising);
  probes_.Edge(0, true, 30, values_);
  EXPECT_EQ(rising(), 30);
}

TEST_F(Probes, TheSecondOneHasTheUpperByte) {
  Function((kProbeEnable | kProbeContinuous | kProbeFalling) << 8);
  probes_.Edge(1, true, 10, values_);
  probes_.Edge(1, false, 20, values_);
  EXPECT_EQ(status(), (kProbeEnabled | kProbeFallen | kProbeFallenAgain) << 8);
  EXPECT_EQ(values_[ObjectId::kProbe2Falling], 20);
  EXPECT_EQ(values_[ObjectId::kProbe2Rising], 0);
}

/// Edges at random microseconds of a motion with acceleration, in their order.
TEST(ProbesOfADrive, CaptureWithinOneCountOfTheMotor) {
  std::mt19937 random(1);
  std::vector<Micros> instants(1000);
  constexpr Micros kBegin = 300'000;
  for (Micros& at : instants) at = kBegin + static_cast<Micros>(random() % 1'000'000);
  std::ranges::sort(instants);
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  WorldEvents events;
  bool level = false;
  for (const Micros at : instants) {
    level = !level;
    events.push_back({at, WorldEventKind::kBusProbe, 0, 0, level ? 1.0 : 0.0});
  }
  BusCard card({FullDrive(0)});
  card.Power(events);
  card.Enable();
  const uint16_t function = kProbeEnable | kProbeContinuous | kProbeRising | kProbeFalling;
  card.bus().SetOutput(0, ObjectId::kProbeFunction, function);
  Profile& profile = ChangeState(card.core).profiles[0];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = 200;
  profile.jog.parameters = {.acc = 0.5, .dec = 0.5};
  profile.Start(card.core.now());
  size_t seen = 0;
  while (seen < instants.size()) {
    const double from = card.motor().position;
    const Micros begin = card.core.now();
    card.Ticks(1);
    const double to = card.motor().position;
    std::array<std::pair<bool, double>, 2> last{};  // of falling and rising edges
    for (; seen < instants.size() && instants[seen] <= card.core.now(); ++seen) {
      const double fraction = static_cast<double>(instants[seen] - begin) / 250;
      last[seen % 2 == 0 ? 1 : 0] = {true, from + fraction * (to - from)};
    }
    const double captured[] = {static_cast<double>(card.object(ObjectId::kProbe1Falling)),
                               static_cast<double>(card.object(ObjectId::kProbe1Rising))};
    for (size_t i = 0; i < 2; ++i) {
      if (!last[i].first) continue;
      EXPECT_LE(std::fabs(captured[i] - last[i].second), 1);
    }
  }
  EXPECT_GT(card.motor().position, 50'000);
}

}  // namespace
}  // namespace oncard::motion::bus
