// A GE card for paths with what tests of its path ask again and again.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "gtcalls/ge/commands/path_support.h"
#include "tests/gtcalls/ge/ge_test_card.h"

namespace oncard::gtcalls::ges {

class PathTestCard : public ge::GeTestCard {
 public:
  explicit PathTestCard(std::string_view name = "GE-300-SG") : GeTestCard(name) {}

  uint16_t PathStatus() { return static_cast<uint16_t>(Read("GT_GetCrdSts")); }
  /// The coordinates that a command reads.
  std::vector<double> Point(std::string_view command = "GT_GetPrfPnt") {
    std::vector<double> point(motion.axis_count(), -12345);
    EXPECT_EQ(Call(command, {}, &point), 0);
    return point;
  }
  /// Until the path has ended; the milliseconds that takes, within a cycle.
  double RunPath() {
    double ms = 0;
    for (; (PathStatus() & 1) == 0 && ms < 100'000; ms += 0.25) Cycle();
    return ms;
  }
  /// Feed and acceleration of immediate paths.
  void SetRates(double velocity, double acceleration) {
    Do("GT_SetSynVel", {velocity});
    Do("GT_SetSynAcc", {acceleration});
  }
  /// A list from (0, 0).
  void BeginList(double velocity, double acceleration) {
    Do("GT_StrtList");
    Do("GT_MvXY", {0, 0, velocity, acceleration});
  }
};

}  // namespace oncard::gtcalls::ges
