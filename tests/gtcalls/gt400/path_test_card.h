// A GT400 card whose axes are mapped to its path, with what tests of paths ask again and again.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "gtcalls/gt400/paths.h"
#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {

class PathTestCard : public Gt400TestCard {
 public:
  /// Axes 1 to 4 are x, y, z, a times `scale`.
  explicit PathTestCard(double scale = 1, std::string_view name = "GT-400-SV")
      : Gt400TestCard(name) {
    for (int axis = 1; axis <= kAxisMax; ++axis) {
      Enable(axis);
      std::vector<double> row(5);
      row[static_cast<size_t>(axis) - 1] = scale;
      EXPECT_EQ(Map(axis, row), 0);
    }
    Do("GT_Axis", {1});
  }

  int16_t Map(int axis, std::vector<double> row) {
    return Call("GT_MapAxis", {static_cast<double>(axis)}, &row);
  }
  uint16_t PathStatus() { return static_cast<uint16_t>(Read("GT_GetCrdSts")); }
  bool PathBit(int bit) { return (PathStatus() >> bit & 1) != 0; }
  /// The coordinates that a command reads.
  std::vector<double> Point(std::string_view command = "GT_GetPrfPnt") {
    std::vector<double> point(kCoordinateMax, -12345);
    EXPECT_EQ(Call(command, {}, &point), 0);
    return point;
  }
  double Planned(size_t axis) const { return motion.profile(axis - 1).now.position; }
  double Velocity() { return Read("GT_GetCrdVel"); }
  int Number() { return static_cast<int>(Read("GT_GetMtnNm")); }
  void SetRates(double velocity, double acceleration) {
    Do("GT_SetSynVel", {velocity});
    Do("GT_SetSynAcc", {acceleration});
  }
  /// Until the path has ended; the sample times that takes.
  int RunPath() {
    int cycles = 0;
    for (; !PathBit(0) && cycles < 1'000'000; ++cycles) Cycle();
    return cycles;
  }
  /// A list from (0, 0), closed, with lines to these x.
  void MakeList(std::initializer_list<double> ends, double velocity, double acceleration) {
    Do("GT_StrtList");
    Do("GT_MvXY", {0, 0, velocity, acceleration});
    for (const double x : ends) Do("GT_LnXY", {x, 0});
    Do("GT_EndList");
  }
  /// Executes a command that is refused with one of the codes 2 to 6.
  void RefusesFigure(int16_t code, std::string_view name, const std::vector<double>& values,
                     std::vector<double>* cells = nullptr) {
    const uint64_t before = motion.Hash();
    EXPECT_EQ(Call(name, values, cells), code) << name << ": " << reason.en;
    EXPECT_EQ(motion.Hash(), before) << name << " was refused and changed something";
    EXPECT_EQ(Cause(), kIllegal) << name;
    EXPECT_TRUE(PathBit(3)) << name;
  }
};

}  // namespace oncard::gtcalls::gt400
