// Random sequences of all GT400 commands: nothing fails, codes are those of the manual, and what is
// planned for single axes keeps within the ranges of their registers. ONCARD_RANDOM_CALLS makes the
// sequences longer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "tests/gtcalls/gt400/gt400_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gt400 {
namespace {

int CallCount() {
  const char* count = std::getenv("ONCARD_RANDOM_CALLS");
  return count != nullptr ? std::atoi(count) : 4000;
}

/// True if a command must leave 0 in the command register when it succeeds.
bool ChangesTheCard(const Command& command) {
  for (const Access& access : command.accesses) {
    if (access.write) return true;
  }
  return false;
}

class Gt400RandomCalls : public testing::TestWithParam<const char*> {
 protected:
  int Below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

  /// Mostly a value that a command takes; sometimes one at an end of its range, or any.
  double ValueOf(const Parameter& parameter) {
    const double low = std::isfinite(parameter.minimum) ? parameter.minimum : -20000;
    const double high = std::isfinite(parameter.maximum) ? parameter.maximum : 70000;
    double value = 0;
    switch (Below(16)) {
      case 0:
        value = low;
        break;
      case 1:
        value = high;
        break;
      case 2:
        value = low - 1;
        break;
      case 3:
        value = kRateMax;
        break;
      case 4:
        value = low + (high - low) * Below(1000) / 1000;
        break;
      case 5:
        value = Below(2) == 0 ? kPositionMin : kPositionMax;
        break;
      default:
        value = parameter.type == Scalar::kDouble ? Below(50) / 100.0 : Below(200);
        if (parameter.unit == Unit::kIndex) value = Below(7);
    }
    return parameter.type == Scalar::kDouble ? value : std::floor(value);
  }

  /// As many values as any pointer of a command needs.
  std::vector<double> Cells() {
    std::vector<double> cells(16);
    for (double& cell : cells) cell = Below(5) - 2;
    return cells;
  }

  int16_t CallAny(Gt400TestCard& card, const Command& command) {
    std::vector<double> values;
    for (const Parameter& parameter : command.parameters) {
      if (parameter.passing == Passing::kValue) values.push_back(ValueOf(parameter));
    }
    std::vector<double> cells = Cells();
    return card.Call(command.name, values, &cells);
  }

  /// What is needed for a motion, as most random commands prevent one.
  void BeginMotion(Gt400TestCard& card) {
    const char* const modes[] = {"GT_PrflT", "GT_PrflS", "GT_PrflV"};
    const double rate = (1 + Below(49)) / 100.0;
    for (const char* command : {"GT_ClrSts", "GT_AxisOn", modes[Below(3)]}) card.Call(command);
    card.Call("GT_SetPos", {Below(2000) - 1000.0});
    card.Call("GT_SetVel", {Below(1000) / 10.0});
    for (const char* command : {"GT_SetAcc", "GT_SetMAcc", "GT_SetJerk"}) {
      card.Call(command, {rate});
    }
    card.Call("GT_Update");
  }

  std::mt19937 random_{20260101};
};

TEST_P(Gt400RandomCalls, NeverFail) {
  Gt400TestCard card(GetParam());
  const auto commands = card.family.catalogue.commands();
  const int calls = CallCount();
  for (int i = 0; i < calls; ++i) {
    const Command& command =
        commands[static_cast<size_t>(Below(static_cast<int>(commands.size())))];
    if (!card.family.Executes(command)) continue;
    const int16_t code = CallAny(card, command);
    ASSERT_TRUE(code >= -1 && code <= kNotSimulated) << command.name << ' ' << code;
    if (code == 1) {
      ASSERT_NE(card.Cause(), 0) << command.name;
    } else if (code == 0 && ChangesTheCard(command)) {
      ASSERT_EQ(card.Cause(), 0) << command.name;
    }
    if (Below(8) == 0) {
      ChangeState(card.motion)
          .io.SetPin(static_cast<motion::DiType>(Below(5)), Below(8), Below(8) == 0);
    }
    if (Below(4) == 0) BeginMotion(card);
    card.Run(Below(20));
    for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
      const motion::Profile& profile = card.motion.profile(axis);
      ASSERT_TRUE(std::isfinite(profile.now.position)) << command.name;
      if (profile.mode == motion::ProfileMode::kGear || profile.mode == motion::ProfileMode::kCrd) {
        continue;  // no register limits what a slave or a path does
      }
      const bool s_curve = profile.mode == motion::ProfileMode::kSCurve;
      ASSERT_LE(std::fabs(profile.now.velocity), kRateMax * (1 + 1e-9)) << command.name;
      ASSERT_LE(std::fabs(profile.now.acceleration), s_curve ? kSCurveEnd : kRateMax)
          << command.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cards, Gt400RandomCalls, testing::Values("GT-400-SV", "GT-400-SE"),
                         [](const auto& card) {
                           std::string name = card.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace oncard::gtcalls::gt400
