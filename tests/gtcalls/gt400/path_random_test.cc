// Random lists, which end exactly where they lead, and random sequences of all path commands, which
// never fail. ONCARD_RANDOM_CALLS makes the sequences longer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "tests/gtcalls/gt400/path_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gt400 {
namespace {

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  int Below(int end) { return static_cast<int>(engine_() % static_cast<unsigned>(end)); }
  double Between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }

 private:
  std::mt19937 engine_;
};

/// Adds a line or an arc to an open list, and says where it leads.
void AddSegment(PathTestCard& card, Random& random, std::vector<double>* end) {
  if (random.Below(3) > 0) {
    const int dimension = 2 + random.Below(3);
    std::vector<double> to;
    for (int i = 0; i < dimension; ++i) to.push_back(random.Between(-300, 300));
    const std::string name = "GT_LnXYZA";
    ASSERT_EQ(card.Call(name.substr(0, name.size() - 4 + static_cast<size_t>(dimension)), to), 0);
    std::copy(to.begin(), to.end(), end->begin());
  } else {
    // Half a circle ends opposite to its start.
    const std::vector<double> centre = {random.Between(-300, 300), random.Between(-300, 300)};
    const double angle = random.Below(2) == 0 ? 180 : -180;
    ASSERT_EQ(card.Call("GT_ArcXY", {centre[0], centre[1], angle}), 0);
    for (size_t i = 0; i < 2; ++i) (*end)[i] = 2 * centre[i] - (*end)[i];
  }
}

TEST(GtRandomPath, EndsExactlyAndKeepsItsVelocityAndTheJumpsOfItsAxes) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    PathTestCard card(10);
    const double velocity = random.Between(0.1, 5);
    const double acceleration = random.Between(0.005, 0.5);
    const double limit = random.Between(1, 20);
    for (int axis = 1; axis <= kAxisMax; ++axis) {
      card.Do("GT_Axis", {static_cast<double>(axis)});
      card.Do("GT_SetAccLmt", {limit});
    }
    card.Do("GT_StrtList");
    std::vector<double> end = {0, 0, 0, 0};
    card.Do("GT_MvXYZA", {0, 0, 0, 0, velocity, acceleration});
    int segments = 1 + random.Below(5);
    for (int i = 0; i < segments; ++i) AddSegment(card, random, &end);
    card.Do("GT_StrtMtn");
    constexpr int kLast = 3000;
    double before = 0;
    std::vector<double> axes(4);
    for (int cycle = 0; cycle < 50'000 && !card.PathBit(0); ++cycle) {
      card.Cycle();
      const double now = card.Velocity();
      ASSERT_LE(now, velocity * (1 + 1e-12));
      ASSERT_LE(std::fabs(now - before), acceleration + 1e-9);
      before = now;
      for (size_t i = 0; i < axes.size(); ++i) {
        const double last = axes[i];
        axes[i] = card.motion.profile(i).now.velocity;
        // On an arc the direction changes as well: by at most the velocity per radius, here 10.
        if (card.PathBit(5)) continue;
        ASSERT_LE(std::fabs(axes[i] - last), limit + 10 * acceleration + 1e-9);
      }
      // More segments come in the run; stops are followed by starts.
      if (cycle < kLast && random.Below(400) == 0) {
        AddSegment(card, random, &end);
        ++segments;
      }
      if (cycle < kLast && random.Below(1000) == 0) {
        card.Do(random.Below(2) == 0 ? "GT_StpMtn" : "GT_EStpMtn");
        before = 0;
        card.RunPath();
        for (size_t i = 0; i < axes.size(); ++i) axes[i] = 0;
        if (card.Call("GT_StrtMtn") != 0) break;
        card.Do("GT_AddList");
      }
      if (cycle == kLast) card.Do("GT_EndList");
    }
    card.Do("GT_EndList");
    card.RunPath();
    const std::vector<double> point = card.Point();
    for (size_t i = 0; i < point.size(); ++i) {
      EXPECT_NEAR(point[i], end[i], 1e-9) << i;
      EXPECT_EQ(card.Planned(i + 1), 10 * point[i]) << i;
    }
    EXPECT_EQ(card.Number(), segments);
    if (HasFailure()) return;
  }
}

TEST(GtRandomPath, CommandsNeverFail) {
  const char* count = std::getenv("ONCARD_RANDOM_CALLS");
  const int calls = count != nullptr ? std::atoi(count) : 10'000;
  Random random(7);
  PathTestCard card;
  const auto is_for_paths = [](const Command& command) {
    for (const Access& access : command.accesses) {
      if (access.resource == Resource::kCrd) return true;
    }
    return false;
  };
  std::vector<const Command*> commands;
  for (const Command& command : card.family.catalogue.commands()) {
    const bool moves = command.name == "GT_Axis" || command.name == "GT_AxisOn" ||
                       command.name == "GT_AxisOff" || command.name == "GT_PrflT" ||
                       command.name == "GT_ZeroPos" || command.name == "GT_ClrSts";
    if (is_for_paths(command) || moves) commands.push_back(&command);
  }
  ASSERT_GT(commands.size(), 30u);
  for (int i = 0; i < calls; ++i) {
    const Command& command =
        *commands[static_cast<size_t>(random.Below(static_cast<int>(commands.size())))];
    std::vector<double> values;
    for (const Parameter& parameter : command.parameters) {
      if (parameter.passing != Passing::kValue) continue;
      constexpr double kFar[] = {0, 1, -1, 1e9, -2e9, 1e300, 1e-300};
      const bool whole = parameter.type != Scalar::kDouble;
      values.push_back(whole                   ? random.Below(6) - 1
                       : random.Below(10) == 0 ? kFar[random.Below(7)]
                                               : random.Between(-50, 100));
    }
    std::vector<double> cells(5);
    for (double& cell : cells) {
      cell = random.Below(3) == 0 ? random.Between(-5, 5) : random.Below(2);
    }
    const int16_t code = card.Call(command.name, values, &cells);
    ASSERT_TRUE(code >= 0 && code <= 7) << command.name << ' ' << code;
    if (code != 7 && command.name != "GT_GetCmdSts") {
      // Otherwise a host would not see that a command was refused.
      ASSERT_TRUE(code == 0 || card.Cause() != 0) << command.name;
    }
    if (random.Below(30) == 0) {
      ChangeState(card.motion)
          .io.SetPin(random.Below(2) == 0 ? motion::DiType::kLimitPositive : motion::DiType::kAlarm,
                     random.Below(4), random.Below(4) == 0);
    }
    card.Run(random.Below(40));
    for (size_t axis = 0; axis < 4; ++axis) {
      ASSERT_TRUE(std::isfinite(card.motion.profile(axis).now.position)) << command.name;
    }
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
