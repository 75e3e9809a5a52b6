// Commands that the tests of coordinate systems often call.
#pragma once

#include <string_view>
#include <vector>

#include "tests/gtcalls/axis_command_support.h"

namespace oncard::gtcalls::gts {

class CrdCommandCard : public AxisCommandCard {
 public:
  explicit CrdCommandCard(const motion::MotionConfig& config = {.cycle_us = 1000})
      : AxisCommandCard(config) {}

  /// TCrdPrm: the first profiles, synVelMax 500, synAccMax 10, the origin at their positions.
  static std::vector<double> Parameters(int dimension) {
    std::vector<double> cells(21);
    cells[0] = dimension;
    for (int i = 1; i <= dimension; ++i) cells[static_cast<size_t>(i)] = i;
    cells[9] = 500;
    cells[10] = 10;
    return cells;
  }
  void SetUp(int dimension = 2) {
    std::vector<double> cells = Parameters(dimension);
    EXPECT_EQ(Call("GT_SetCrdPrm", {1, &cells}), 0);
  }
  double ReadCrd(std::string_view command) {
    std::vector<double> value(1, -12345);
    EXPECT_EQ(Call(command, {1, &value}), 0) << command;
    return value[0];
  }
  double ReadFifo(std::string_view command, int fifo = 0) {
    std::vector<double> value(1, -12345);
    EXPECT_EQ(Call(command, {1, &value, fifo}), 0) << command;
    return value[0];
  }
  /// GT_LnXY at 10 pulse/ms and 1 pulse/ms^2 to rest.
  int16_t Line(int x, int y, int fifo = 0) { return Call("GT_LnXY", {1, x, y, 10, 1, 0, fifo}); }
  bool Running() {
    std::vector<double> run(1);
    std::vector<double> segments(1);
    EXPECT_EQ(Call("GT_CrdStatus", {1, &run, &segments, 0}), 0);
    return run[0] != 0;
  }
  void CyclesToEnd() {
    for (int i = 0; i < 10000 && motion.state().crds[0].run.running; ++i) Cycle();
  }
};

}  // namespace oncard::gtcalls::gts
