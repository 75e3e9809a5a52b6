// The courses of homing: where each mode searches, how fast, where it ends, and what ends it early.
//
// In all tests a search accelerates with 0.1 pulse/ms^2 to 5 pulse/ms, in 50 ms and 125 pulses, or
// to 1 pulse/ms, in 10 ms and 5 pulses. A cycle of 0.25 ms takes 1.25 or 0.25 pulses then.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

constexpr int kMostCycles = 1'000'000;

/// An axis that is homed; records what it does.
class HomedAxis {
 public:
  HomedAxis() {
    core_.SetIndexMarks(0, {.offset = 300, .period = 1000});
    core_.AxisAt(0).ServoOn();
    core_.ProfileAt(0).SetStopDecelerations(0.1, 100);
  }

  MotionCore& core() { return core_; }
  const Homing& state() const { return core_.state().homing[0]; }
  double position() const { return core_.profile(0).now.position; }
  const std::vector<HomeStage>& stages() const { return stages_; }
  /// The largest velocity in a stage.
  double Fastest(HomeStage stage) { return fastest_[stage]; }
  double highest() const { return highest_; }

  void AddSwitch(DiType type, double first, double last) {
    core_.AddSwitch({.axis = 0, .type = type, .first = first, .last = last});
    // Until the filter has accepted its level.
    Ticks(core_, 4);
  }
  void PlaceAt(int32_t position) {
    core_.PlaceMotor(0, position);
    core_.ProfileAt(0).SetPosition(position);
    core_.EncoderAt(0).SetPosition(position);
    core_.AxisAt(0).SynchPosition();
  }
  void Begin(const HomeParameters& parameters) {
    ASSERT_EQ(core_.CheckHoming(0, parameters.mode), HomeError::kNone);
    core_.HomingAt(0).Begin(parameters);
    Record();
  }
  /// Returns the number of cycles until it ends.
  int Run() {
    int cycles = 0;
    for (; state().running && cycles < kMostCycles; ++cycles) {
      core_.Tick();
      Record();
    }
    return cycles;
  }

 private:
  void Record() {
    const HomeStage stage = state().stage;
    if (stages_.empty() || stages_.back() != stage) stages_.push_back(stage);
    fastest_[stage] = std::max(fastest_[stage], std::fabs(core_.profile(0).now.velocity));
    highest_ = std::max(highest_, position());
  }

  MotionCore core_{MotionConfig{}};
  std::vector<HomeStage> stages_;
  std::map<HomeStage, double> fastest_;
  double highest_ = 0;
};

HomeParameters Parameters(HomeMode mode) {
  return {
      .mode = mode, .rising = true, .high = 5, .low = 1, .acc = 0.1, .dec = 0.1, .escape = 1000};
}

// --- The modes ---------------------------------------------------------------------------------

struct Course {
  const char* name;
  HomeMode mode;
  int8_t index_direction;
  double captured;
  std::vector<HomeStage> stages;
};

// The home switch is at 4000 to 6000, the positive limit from 18000 on, the index marks at 300,
// 1300 ... Searches begin at 0, forwards. A limit mode comes to the switch from above.
const Course kCourses[] = {
    {"limit",
     HomeMode::kLimit,
     1,
     18000,
     {HomeStage::kSearchLimit, HomeStage::kSearchLimitStop, HomeStage::kLimitEscape,
      HomeStage::kLimitReturn, HomeStage::kLimitReturnStop, HomeStage::kGoHome, HomeStage::kEnd}},
    {"limit, home",
     HomeMode::kLimitHome,
     1,
     6000,
     {HomeStage::kSearchLimit, HomeStage::kSearchLimitStop, HomeStage::kSearchHome,
      HomeStage::kSearchHomeStop, HomeStage::kGoHome, HomeStage::kEnd}},
    {"limit, index",
     HomeMode::kLimitIndex,
     -1,
     17300,
     {HomeStage::kSearchLimit, HomeStage::kSearchLimitStop, HomeStage::kSearchIndex,
      HomeStage::kGoHome, HomeStage::kEnd}},
    {"limit, home, index",
     HomeMode::kLimitHomeIndex,
     -1,
     5300,
     {HomeStage::kSearchLimit, HomeStage::kSearchLimitStop, HomeStage::kSearchHome,
      HomeStage::kSearchHomeStop, HomeStage::kHomeReturn, HomeStage::kSearchIndex,
      HomeStage::kGoHome, HomeStage::kEnd}},
    {"home",
     HomeMode::kHome,
     1,
     4000,
     {HomeStage::kSearchHome, HomeStage::kSearchHomeStop, HomeStage::kGoHome, HomeStage::kEnd}},
    {"home, index",
     HomeMode::kHomeIndex,
     1,
     4300,
     {HomeStage::kSearchHome, HomeStage::kSearchHomeStop, HomeStage::kHomeReturn,
      HomeStage::kSearchIndex, HomeStage::kGoHome, HomeStage::kEnd}},
    {"index",
     HomeMode::kIndex,
     1,
     300,
     {HomeStage::kSearchIndex, HomeStage::kGoHome, HomeStage::kEnd}},
    {"forced home",
     HomeMode::kForcedHome,
     1,
     4000,
     {HomeStage::kSearchHome, HomeStage::kSearchHomeStop, HomeStage::kGoHome, HomeStage::kEnd}},
    {"forced home, index",
     HomeMode::kForcedHomeIndex,
     -1,
     3300,
     {HomeStage::kSearchHome, HomeStage::kSearchHomeStop, HomeStage::kHomeReturn,
      HomeStage::kSearchIndex, HomeStage::kGoHome, HomeStage::kEnd}},
};

TEST(Homing, EachModeTakesItsCourseToItsOrigin) {
  for (const Course& course : kCourses) {
    SCOPED_TRACE(course.name);
    HomedAxis axis;
    axis.AddSwitch(DiType::kHome, 4000, 6000);
    axis.AddSwitch(DiType::kLimitPositive, 18000, 1e9);
    HomeParameters parameters = Parameters(course.mode);
    parameters.index_direction = course.index_direction;
    parameters.offset = -40;
    axis.Begin(parameters);
    axis.Run();
    EXPECT_EQ(axis.state().error, HomeError::kNone);
    EXPECT_EQ(axis.stages(), course.stages);
    EXPECT_EQ(axis.state().captured, course.captured);
    EXPECT_EQ(axis.position(), course.captured - 40);
    EXPECT_EQ(axis.core().state().plants[0].position, course.captured - 40);
    EXPECT_EQ(axis.core().encoder(0).position, course.captured - 40) << "it is not set to 0";
    for (const HomeStage stage : course.stages) {
      const bool fast = stage == HomeStage::kSearchLimit || stage == HomeStage::kSearchHome ||
                        stage == HomeStage::kLimitEscape;
      const bool slow = stage == HomeStage::kSearchIndex || stage == HomeStage::kLimitReturn ||
                        stage == HomeStage::kHomeReturn || stage == HomeStage::kGoHome;
      if (!fast && !slow) continue;
      EXPECT_NEAR(axis.Fastest(stage), fast ? 5 : 1, 1e-9);
    }
  }
}

// Up to 4000: 125 pulses in 50 ms, the others in 775 ms: 3300 cycles. The edge is at the end of
// the last of them. Its stop takes 200 cycles and 125 pulses. Back to 4000: 5 pulses in 10 ms, 115
// in 115 ms, 5 in 10 ms, 540 cycles.
TEST(Homing, TakesTheTimeOfItsMotions) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kHome, 4000, 6000);
  axis.Begin(Parameters(HomeMode::kHome));
  EXPECT_EQ(axis.Run(), 3300 + 200 + 540);
  EXPECT_NEAR(axis.highest(), 4125, 1e-9);
  EXPECT_EQ(axis.position(), 4000);
}

TEST(Homing, TheLastWayIsFastIfItShallBe) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kHome, 4000, 6000);
  HomeParameters parameters = Parameters(HomeMode::kHome);
  parameters.final_fast = true;
  parameters.offset = -2000;
  axis.Begin(parameters);
  axis.Run();
  EXPECT_NEAR(axis.Fastest(HomeStage::kGoHome), 5, 1e-9);
  EXPECT_EQ(axis.position(), 2000);
}

TEST(Homing, SearchesBackwardsAndForTheFallingEdge) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kHome, -6000, -4000);
  HomeParameters parameters = Parameters(HomeMode::kHome);
  parameters.move_direction = -1;
  parameters.rising = false;
  axis.Begin(parameters);
  axis.Run();
  EXPECT_EQ(axis.state().captured, -6000);
  EXPECT_EQ(axis.position(), -6000);
}

// --- Distances ---------------------------------------------------------------------------------

// 1000 pulses at 5 pulse/ms: 50 + 150 + 50 ms; 200 pulses at 1 pulse/ms: 10 + 190 + 10 ms.
TEST(Homing, EndsWithAnErrorBehindItsDistance) {
  const struct {
    HomeMode mode;
    HomeError error;
    double distance;
    int cycles;
  } cases[] = {{HomeMode::kHome, HomeError::kNoHome, 1000, 1000},
               {HomeMode::kIndex, HomeError::kNoIndex, 200, 840}};
  for (const auto& c : cases) {
    HomedAxis axis;
    HomeParameters parameters = Parameters(c.mode);
    parameters.home_distance = 1000;
    parameters.index_distance = 200;
    axis.Begin(parameters);
    EXPECT_EQ(axis.Run(), c.cycles);
    EXPECT_EQ(axis.state().error, c.error);
    EXPECT_EQ(axis.position(), c.distance);
    EXPECT_FALSE(axis.core().state().capture.capture(0).armed);
  }
}

// --- Limits ------------------------------------------------------------------------------------

// The filter of the limit takes three cycles and the abrupt stop 0.125 pulses.
TEST(Homing, ALimitInTheWayEndsTheSearchForAHomeSwitch) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kHome, 4000, 6000);
  axis.AddSwitch(DiType::kLimitPositive, 3000, 1e9);
  axis.Begin(Parameters(HomeMode::kHome));
  axis.Run();
  EXPECT_EQ(axis.state().error, HomeError::kStop);
  EXPECT_GT(axis.position(), 3000 + 2 * 1.25);
  EXPECT_LT(axis.position(), 3000 + 5 * 1.25);
}

TEST(Homing, AForcedModeTurnsAtALimitInTheWay) {
  const struct {
    HomeMode mode;
    double captured;
  } cases[] = {{HomeMode::kForcedHome, -4000}, {HomeMode::kForcedHomeIndex, -4700}};
  for (const auto& c : cases) {
    HomedAxis axis;
    axis.AddSwitch(DiType::kHome, -6000, -4000);
    axis.AddSwitch(DiType::kLimitPositive, 3000, 1e9);
    HomeParameters parameters = Parameters(c.mode);
    parameters.index_direction = -1;
    axis.Begin(parameters);
    axis.Run();
    EXPECT_EQ(axis.state().error, HomeError::kNone);
    EXPECT_GT(axis.highest(), 3000);
    EXPECT_EQ(axis.position(), c.captured);
  }
}

TEST(Homing, AForcedModeTurnsOnce) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kLimitPositive, 3000, 1e9);
  axis.AddSwitch(DiType::kLimitNegative, -1e9, -3000);
  axis.Begin(Parameters(HomeMode::kForcedHome));
  axis.Run();
  EXPECT_EQ(axis.state().error, HomeError::kStop);
  EXPECT_LT(axis.position(), -3000);
}

// The limit is passed by more than two cycles of 1.25 pulses.
TEST(Homing, ALimitThatTheEscapeDoesNotLeaveIsAnError) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kLimitPositive, 3000, 1e9);
  HomeParameters parameters = Parameters(HomeMode::kLimit);
  parameters.escape = 1;
  axis.Begin(parameters);
  axis.Run();
  EXPECT_EQ(axis.state().error, HomeError::kStage);
}

// --- The start ---------------------------------------------------------------------------------

TEST(Homing, LeavesASwitchItStandsOnIfItShallCheck) {
  for (const bool check : {false, true}) {
    HomedAxis axis;
    // The encoder does not count this: its 0 is at 4500.
    axis.core().PlaceMotor(0, 4500);
    axis.AddSwitch(DiType::kHome, 4000, 6000);
    HomeParameters parameters = Parameters(HomeMode::kHome);
    parameters.check_start = check;
    parameters.home_distance = 3000;
    axis.Begin(parameters);
    EXPECT_EQ(axis.stages().front(), check ? HomeStage::kEscape : HomeStage::kSearchHome);
    axis.Run();
    EXPECT_EQ(axis.state().error, check ? HomeError::kNone : HomeError::kNoHome);
    EXPECT_EQ(axis.position(), check ? -500 : 3000);
  }
}

TEST(Homing, LeavesALimitItStandsOnWhateverItsDirection) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kLimitNegative, -1e9, 500);
  axis.AddSwitch(DiType::kHome, 4000, 6000);
  HomeParameters parameters = Parameters(HomeMode::kHome);
  parameters.check_start = true;
  axis.Begin(parameters);
  EXPECT_EQ(axis.stages().front(), HomeStage::kEscape);
  axis.Run();
  EXPECT_EQ(axis.position(), 4000);
}

TEST(Homing, SaysWhyItCannotBegin) {
  const struct {
    HomeError error;
    void (*change)(MotionCore& core);
    HomeMode mode;
  } cases[] = {
      {HomeError::kNone, [](MotionCore&) {}, HomeMode::kIndex},
      {HomeError::kMode, [](MotionCore&) {}, HomeMode::kNone},
      {HomeError::kNotTrap,
       [](MotionCore& core) { core.ProfileAt(0).SelectMode(ProfileMode::kJog); }, HomeMode::kIndex},
      {HomeError::kDisabled, [](MotionCore& core) { core.AxisAt(0).ServoOff(); }, HomeMode::kIndex},
      {HomeError::kAlarm, [](MotionCore& core) { ChangeState(core).axes[0].latched = kAlarmBit; },
       HomeMode::kIndex},
  };
  for (const auto& c : cases) {
    HomedAxis axis;
    c.change(axis.core());
    EXPECT_EQ(axis.core().CheckHoming(0, c.mode), c.error);
    axis.core().HomingAt(0).Refuse(c.error);
    EXPECT_EQ(axis.state().error, c.error);
  }
}

TEST(Homing, WhatItNeedsMayBeMissing) {
  HomedAxis axis;
  axis.core().EncoderAt(0).Configure(false, false, true);
  axis.Begin(Parameters(HomeMode::kIndex));
  EXPECT_FALSE(axis.state().running);
  EXPECT_EQ(axis.state().error, HomeError::kSetCaptureIndex);
  HomeParameters parameters = Parameters(HomeMode::kHome);
  parameters.trigger_index = kAxisIoWidth + 1;
  axis.Begin(parameters);
  EXPECT_FALSE(axis.state().running);
  EXPECT_EQ(axis.state().error, HomeError::kSetCaptureHome);
}

// --- Stops meanwhile ---------------------------------------------------------------------------

// From 5 pulse/ms with 0.1 pulse/ms^2: 50 ms. Homing sees in the cycle after the stop that the axis
// is being stopped, and runs until it rests.
TEST(Homing, AStopMeanwhileIsItsError) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kHome, 4000, 6000);
  axis.Begin(Parameters(HomeMode::kHome));
  Ticks(axis.core(), 400);
  axis.core().AxisAt(0).Stop(false);
  axis.core().HomingAt(0).Refuse(HomeError::kAlarm);
  EXPECT_EQ(axis.Run(), 200);
  EXPECT_EQ(axis.state().error, HomeError::kStop) << "not that of a command it has refused";
  // 125 pulses in 50 ms, 250 in 50 ms, 125 in 50 ms.
  EXPECT_NEAR(axis.position(), 500, 1e-9);
  EXPECT_FALSE(axis.core().state().capture.capture(0).armed);
}

TEST(Homing, ADriveThatIsSwitchedOffMeanwhileIsItsError) {
  HomedAxis axis;
  axis.Begin(Parameters(HomeMode::kHome));
  Ticks(axis.core(), 400);
  axis.core().AxisAt(0).ServoOff();
  axis.Run();
  EXPECT_EQ(axis.state().error, HomeError::kStop);
}

// --- Simple homing -----------------------------------------------------------------------------

// At 10 pulse/ms with 1 pulse/ms^2: 10 ms and 50 pulses. 6000 is reached at the end of a cycle, and
// the falling edge is in the next one, at whose end the axis is at 6002.5.
TEST(SimpleHoming, GoesToTheSwitchOrStopsBehindIt) {
  const struct {
    HomeKind kind;
    double end;
  } cases[] = {{HomeKind::kHome, 6100}, {HomeKind::kStop, 6052.5}};
  for (const auto& c : cases) {
    HomedAxis axis;
    axis.AddSwitch(DiType::kHome, 4000, 6000);
    axis.core().HomingAt(0).BeginSimple(c.kind, 100000, 10, 1, 100);
    axis.Run();
    EXPECT_TRUE(axis.state().found);
    EXPECT_EQ(axis.state().captured, 6000);
    EXPECT_NEAR(axis.position(), c.end, 1e-9);
  }
}

TEST(SimpleHoming, EndsAtItsPositionWithoutASwitch) {
  HomedAxis axis;
  axis.core().HomingAt(0).BeginSimple(HomeKind::kHome, 5000, 10, 1, 100);
  // 10 + 490 + 10 ms.
  EXPECT_EQ(axis.Run(), 2040);
  EXPECT_FALSE(axis.state().found);
  EXPECT_EQ(axis.state().error, HomeError::kNoHome);
  EXPECT_EQ(axis.position(), 5000);
  axis.core().HomingAt(0).Prepare();
  EXPECT_EQ(axis.state().error, HomeError::kNone);
}

// The switch is left at 6000; from 6100 on the next mark is at 6300.
TEST(SimpleHoming, TheIndexPulseIsSearchedAtHalfTheVelocity) {
  for (const bool before : {false, true}) {
    HomedAxis axis;
    axis.AddSwitch(DiType::kHome, 4000, 6000);
    if (before) axis.core().HomingAt(0).SetIndexSearch(2000, 50);
    EXPECT_FALSE(axis.state().running);
    axis.core().HomingAt(0).BeginSimple(HomeKind::kHome, 100000, 10, 1, 100);
    axis.Run();
    if (!before) {
      EXPECT_EQ(axis.position(), 6100);
      axis.core().HomingAt(0).SetIndexSearch(2000, 50);
      axis.Run();
    }
    EXPECT_TRUE(axis.state().found);
    EXPECT_EQ(axis.state().captured, 6300);
    EXPECT_EQ(axis.position(), 6350);
    EXPECT_NEAR(axis.Fastest(HomeStage::kSearchIndex), 5, 1e-9);
  }
}

// --- Within a bound ----------------------------------------------------------------------------

// At 10 pulse/ms with 1 pulse/ms^2, from 0, or from 5000 in the middle of the switch: it is left at
// the side where the search begins. A switch that is passed downwards captures at 6000.
TEST(HomingWithinABound, ReturnsToWhereItHasFoundTheSwitch) {
  const struct {
    int32_t start;
    int32_t bound;
    double found;
  } cases[] = {{0, 20000, 4000}, {20000, -20000, 6000}, {5000, 20000, 4000}, {5000, -20000, 6000}};
  for (const auto& c : cases) {
    HomedAxis axis;
    axis.PlaceAt(c.start);
    axis.core().capture().SetSense(0, CaptureSource::kHome, true);
    axis.AddSwitch(DiType::kHome, 4000, 6000);
    axis.core().HomingAt(0).BeginWithin(c.bound, 10, 1, false);
    axis.Run();
    EXPECT_TRUE(axis.state().found) << c.start;
    EXPECT_EQ(axis.position(), c.found) << c.start;
    EXPECT_EQ(axis.Fastest(HomeStage::kSearchHome), 10);
    const bool on_switch = c.start == 5000;
    EXPECT_EQ(axis.Fastest(HomeStage::kEscape) > 0, on_switch);
  }
}

// The marks are at 300, 1300 ...; the one after 4000 is at 4300, the one before 6000 at 5300.
TEST(HomingWithinABound, SearchesTheIndexPulseOnTheSameWay) {
  for (const bool upwards : {true, false}) {
    HomedAxis axis;
    axis.PlaceAt(upwards ? 0 : 20000);
    axis.core().capture().SetSense(0, CaptureSource::kHome, true);
    axis.AddSwitch(DiType::kHome, 4000, 6000);
    axis.core().HomingAt(0).BeginWithin(upwards ? 20000 : -20000, 10, 1, true);
    axis.Run();
    EXPECT_TRUE(axis.state().found);
    EXPECT_EQ(axis.position(), upwards ? 4300 : 5300);
  }
}

TEST(HomingWithinABound, EndsThereWithoutAResult) {
  HomedAxis axis;
  axis.core().HomingAt(0).BeginWithin(3000, 10, 1, true);
  axis.Run();
  EXPECT_FALSE(axis.state().found);
  EXPECT_EQ(axis.position(), 3000);
}

TEST(HomingWithinABound, AnotherMotionEndsIt) {
  HomedAxis axis;
  axis.AddSwitch(DiType::kHome, 4000, 6000);
  axis.core().HomingAt(0).BeginWithin(20000, 10, 1, false);
  Ticks(axis.core(), 10);
  axis.core().HomingAt(0).Abandon();
  axis.core().ProfileAt(0).SetTarget(9000);
  axis.core().ProfileAt(0).Start();
  EXPECT_FALSE(axis.state().running);
  EXPECT_FALSE(axis.core().state().capture.capture(0).armed);
  while (axis.core().profile(0).now.moving) axis.core().Tick();
  EXPECT_EQ(axis.position(), 9000);
}

}  // namespace
}  // namespace oncard::motion
