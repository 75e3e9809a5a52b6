// A card with the multi-axis look-ahead, for tests of its commands.
#pragma once

#include <string_view>
#include <vector>

#include "tests/gtcalls/crd_command_support.h"

namespace oncard::gtcalls::gts {

class LookAheadCard : public CrdCommandCard {
 public:
  using CrdCommandCard::CrdCommandCard;

  /// TLookAheadParameter: 200 segments, 0.01 s, ratio 1, limits of 100 mm/s, 500 mm/s^2 and
  /// 500 mm/s^2, 1000 pulses per mm, axes one to one.
  static std::vector<double> Parameters(int window = 200) {
    std::vector<double> cells(43);
    cells[0] = window;
    cells[1] = 0.01;
    cells[2] = 1;
    for (size_t i = 0; i < 8; ++i) {
      cells[3 + i] = 100;
      cells[11 + i] = 500;
      cells[19 + i] = 500;
      cells[27 + i] = 1000;
      cells[35 + i] = static_cast<double>(i + 1);
    }
    return cells;
  }
  int16_t Init(std::vector<double> cells = Parameters(), int motion_mode = 0, int fifo = 0) {
    return Call("GT_InitLookAheadEx", {1, &cells, fifo, motion_mode, nullptr});
  }
  /// A coordinate system with look-ahead; mode 0: three axes, 1: several.
  void Prepare(int dimension = 2, int mode = 0) {
    SetUp(dimension);
    Expect(0, "GT_SetupLookAheadCrd", {1, mode});
    EXPECT_EQ(Init(), 0) << reason.en;
  }
  /// GT_LnXYEx in mm at 50 mm/s and 500 mm/s^2.
  int16_t LineEx(double x, double y, int number = 0) {
    return Call("GT_LnXYEx", {1, x, y, 50.0, 500.0, number, 0, 0});
  }
  int16_t Flush() { return Call("GT_CrdDataEx", {1, nullptr, 0}); }
  const motion::CrdFifo& fifo(size_t index = 0) { return motion.state().crds[0].fifos[index]; }
  /// Starts the coordinate system and runs it to its end; the number of cycles.
  int Run() {
    EXPECT_EQ(Call("GT_CrdStart", {1, 0}), 0) << reason.en;
    int cycles = 0;
    for (; motion.state().crds[0].run.running && cycles < 100000; ++cycles) Cycle();
    return cycles;
  }
  double Position(size_t profile) { return motion.state().profiles[profile].now.position; }
};

}  // namespace oncard::gtcalls::gts
