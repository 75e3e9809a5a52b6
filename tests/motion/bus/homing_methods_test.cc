// Homing by the drive: every method from both sides of its switch, and on it, against the home
// position that CiA 402-2 draws.
#include "motion/bus/homing_methods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/motion/bus/bus_card.h"
#include "tests/motion/change_state.h"

namespace oncard::motion::bus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Index marks are at 250 + 1000 n.
constexpr double kNegativeLimitEnd = -50'000;
constexpr double kPositiveLimitBegin = 50'000;
constexpr double kLeftEdge = 1000;
constexpr double kRightEdge = 3000;
constexpr int32_t kOffset = -77;

enum class HomeSwitch : uint8_t { kZone, kToTheRight, kToTheLeft };

struct HomingCase {
  int method;
  HomeSwitch home;
  double expected;  ///< where the motor ends
};

constexpr HomingCase kCases[] = {
    {1, HomeSwitch::kZone, -49'750},     {2, HomeSwitch::kZone, 49'250},
    {3, HomeSwitch::kToTheRight, 250},   {4, HomeSwitch::kToTheRight, 1250},
    {5, HomeSwitch::kToTheLeft, 3250},   {6, HomeSwitch::kToTheLeft, 2250},
    {7, HomeSwitch::kZone, 250},         {8, HomeSwitch::kZone, 1250},
    {9, HomeSwitch::kZone, 2250},        {10, HomeSwitch::kZone, 3250},
    {11, HomeSwitch::kZone, 3250},       {12, HomeSwitch::kZone, 2250},
    {13, HomeSwitch::kZone, 1250},       {14, HomeSwitch::kZone, 250},
    {17, HomeSwitch::kZone, -50'000},    {18, HomeSwitch::kZone, 50'000},
    {19, HomeSwitch::kToTheRight, 1000}, {20, HomeSwitch::kToTheRight, 1000},
    {21, HomeSwitch::kToTheLeft, 3000},  {22, HomeSwitch::kToTheLeft, 3000},
    {23, HomeSwitch::kZone, 1000},       {24, HomeSwitch::kZone, 1000},
    {25, HomeSwitch::kZone, 3000},       {26, HomeSwitch::kZone, 3000},
    {27, HomeSwitch::kZone, 3000},       {28, HomeSwitch::kZone, 3000},
    {29, HomeSwitch::kZone, 1000},       {30, HomeSwitch::kZone, 1000},
};

constexpr double kStarts[] = {-20'000, 20'000, 2000, 900, 3100, -50'500, 50'500, 50'000};

PositionSwitch Contact(DiType type, double first, double last) {
  PositionSwitch contact;
  contact.type = type;
  contact.first = first;
  contact.last = last;
  return contact;
}

class HomingCard : public BusCard {
 public:
  explicit HomingCard(double start, HomeSwitch home = HomeSwitch::kZone) : BusCard({FullDrive(0)}) {
    std::vector<PositionSwitch>& switches = ChangeState(core).switches;
    switches.push_back(Contact(DiType::kLimitNegative, -kInfinity, kNegativeLimitEnd));
    switches.push_back(Contact(DiType::kLimitPositive, kPositiveLimitBegin, kInfinity));
    const double first = home == HomeSwitch::kToTheLeft ? -kInfinity : kLeftEdge;
    const double last = home == HomeSwitch::kToTheRight ? kInfinity : kRightEdge;
    switches.push_back(Contact(DiType::kHome, first, last));
    core.SetIndexMarks(0, {250, 1000});
    core.PlaceMotor(0, start);
    Power();
    Enable();
  }

  /// Begins a method in mode 6.
  void Begin(int method, double search = 40) {
    core.bus_axes().SetMode(0, DriveMode::kHoming);
    const BusHomingParameters parameters{method, search, 3, 0.5, kOffset};
    ASSERT_EQ(core.bus_axes().PrepareHoming(0, parameters), SdoAbort::kNone);
    Ticks(1);
    core.bus_axes().StartHoming(0);
  }
  uint16_t Finish() {
    for (int i = 0; i < 400'000 && link().homing_status == 0; ++i) core.Tick();
    return link().homing_status;
  }
};

void Expect(HomingCard& card, int method, double start, double expected) {
  card.Begin(method);
  const std::string which = std::to_string(method) + " from " + std::to_string(start);
  ASSERT_EQ(card.Finish(), kHomingFinished | kHomingSucceeded) << which;
  EXPECT_EQ(card.motor().position, expected) << which;
  EXPECT_EQ(card.object(ObjectId::kPositionActual), kOffset) << which;
  EXPECT_EQ(card.motor().velocity, 0) << which;
}

TEST(HomingMethods, EndAtTheHomePositionOfTheStandardFromEverySide) {
  for (const HomingCase& each : kCases) {
    for (const double start : kStarts) {
      HomingCard card(start, each.home);
      Expect(card, each.method, start, each.expected);
    }
  }
}

/// On both sides of the home switch, on it, and at both edges of it.
TEST(HomingMethods, ToTheNextIndexMarkOrHereNeedNoSwitch) {
  struct Row {
    double start;
    double left, right;  ///< the next marks
  };
  for (const Row& row :
       {Row{-20'000, -20'750, -19'750}, Row{20'000, 19'250, 20'250}, Row{2000, 1250, 2250},
        Row{kLeftEdge, 250, 1250}, Row{kRightEdge, 2250, 3250}}) {
    const std::pair<int, double> kCasesHere[] = {
        {33, row.left}, {34, row.right}, {35, row.start}, {37, row.start}};
    for (const auto& [method, expected] : kCasesHere) {
      HomingCard card(row.start);
      Expect(card, method, row.start, expected);
    }
  }
}

TEST(HomingMethods, FindTheSameEdgeAtAnySpeed) {
  for (const double speed : {1.0, 7.3, 200.0, 5000.0}) {
    HomingCard card(-20'000);
    card.Begin(8, speed);
    EXPECT_EQ(card.Finish(), 3) << speed;
    EXPECT_EQ(card.motor().position, 1250) << speed;
  }
}

TEST(HomingMethods, FailAfterBothLimitsWithoutASwitch) {
  for (const int method : {7, 14, 24, 27}) {
    HomingCard card(-20'000);
    ChangeState(card.core).switches.pop_back();
    card.Begin(method);
    EXPECT_EQ(card.Finish(), kHomingFinished | kHomingFailed) << method;
    EXPECT_NE(card.object(ObjectId::kStatusWord) & kStatusHomingError, 0) << method;
  }
}

TEST(HomingMethods, FailAtALimitWithoutIndexMarks) {
  HomingCard card(-20'000);
  ChangeState(card.core).index_marks[0].period = 0;
  card.Begin(34);
  EXPECT_EQ(card.Finish(), kHomingFinished | kHomingFailed);
}

TEST(HomingMethods, AreThoseOfTheStandard) {
  for (int number = -128; number < 128; ++number) {
    const bool reserved = number == 15 || number == 16 || number == 31 || number == 32;
    const bool expected = (number >= 1 && number <= 35 && !reserved) || number == 37;
    EXPECT_EQ(FindHomingMethod(number).has_value(), expected) << number;
  }
}

TEST(HomingMethods, AStopBrakesWithTheAccelerationAndClears) {
  HomingCard card(-20'000);
  card.Begin(7);
  card.Ticks(2000);
  EXPECT_EQ(card.motor().velocity, 40);
  card.core.bus_axes().StopHoming(0);
  card.Ticks(1);
  EXPECT_EQ(card.motor().velocity, 40 - 0.5 * 0.25);
  card.Ticks(400);
  EXPECT_EQ(card.motor().velocity, 0);
  EXPECT_EQ(card.link().homing_status, 0);
}

TEST(HomingMethods, CanBeRepeatedAtOnce) {
  HomingCard card(-20'000);
  card.Begin(7);
  EXPECT_EQ(card.Finish(), 3);
  card.core.bus_axes().StartHoming(0);
  EXPECT_EQ(card.link().homing_status, 0);
  EXPECT_EQ(card.Finish(), 3);
  EXPECT_EQ(card.motor().position, 250);
}

TEST(HomingMethods, TheEncoderOfTheCardGoesAlongWithoutAVelocity) {
  HomingCard card(-20'000);
  card.Begin(19);
  for (int i = 0; i < 400'000 && card.link().homing_status == 0; ++i) {
    card.core.Tick();
    EXPECT_LE(std::fabs(card.core.state().encoders[0].velocity), 45);
  }
  EXPECT_EQ(card.encoder(), kOffset);
}

TEST(HomingMethods, TheProfileFollowsTheEncoderWhenTheModeReturns) {
  HomingCard card(-20'000);
  card.Begin(8);
  card.Finish();
  card.core.bus_axes().SetMode(0, DriveMode::kCyclicPosition);
  card.Ticks(4);
  EXPECT_EQ(card.core.state().profiles[0].now.position, kOffset);
  EXPECT_EQ(card.motor().position, 1250);
  EXPECT_TRUE(card.axis().servo_on);
  EXPECT_EQ(card.axis().latched & kFollowingErrorBit, 0u);
}

TEST(HomingMethods, WorkWithAMotorThatLags) {
  HomingCard card(-20'000);
  card.core.ConnectDrive(0, VelocityDrive(200, 2, 0, card.core.config().ServoMs()));
  card.Begin(7);
  ASSERT_EQ(card.Finish(), 3);
  EXPECT_NEAR(card.motor().position, 250, kHomingWindow);
  card.Ticks(400);
  EXPECT_NEAR(card.motor().position, 250, 0.5);
  EXPECT_EQ(card.object(ObjectId::kPositionActual), kOffset);
}

}  // namespace
}  // namespace oncard::motion::bus
