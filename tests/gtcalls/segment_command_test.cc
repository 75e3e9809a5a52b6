// Segments: all forms of lines, arcs and helices, and why a segment may be impossible.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gtcalls/gts/catalogue.h"
#include "tests/gtcalls/crd_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

/// Valid arguments for every segment command: from (0, 0, 0) to (100, 100, 100).
std::vector<Argument> ArgumentsFor(const Command& command) {
  std::vector<Argument> arguments = {1};
  for (const Parameter& parameter : command.parameters.subspan(1)) {
    const std::string_view name = parameter.name;
    double value = 0;
    if (name.size() == 1) value = 100;
    if (name == "synVel") value = 10;
    if (name == "synAcc") value = 1;
    if (name == "radius") value = 100;
    if (name == "segNum") value = 9;
    // A quarter circle around (0, 100) in the plane, counter-clockwise.
    if (name == "circleDir") value = 1;
    const std::string text(command.name);
    const char second = text.find("XY") != std::string::npos   ? 'y'
                        : text.find("YZ") != std::string::npos ? 'z'
                                                               : 'x';
    if (name.ends_with("Center") && name[0] == second) value = 100;
    if (name == "interX") value = 50;
    arguments.emplace_back(value);
  }
  return arguments;
}

TEST(Segments, EveryCommandMovesItsAxesToTheEnd) {
  int count = 0;
  for (const Command& command : GtsCatalogue().commands()) {
    if (command.number < 230 || command.number > 303) continue;
    ++count;
    CrdCommandCard card;
    card.SetUp(4);
    const std::vector<Argument> arguments = ArgumentsFor(command);
    ASSERT_EQ(card.Call(command, arguments), 0) << command.name << ' ' << card.reason.en;
    EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
    card.CyclesToEnd();
    for (const Parameter& parameter : command.parameters) {
      if (parameter.name.size() != 1) continue;
      const auto axis = std::string_view("xyza").find(parameter.name[0]);
      EXPECT_EQ(card.Read("GT_GetPrfPos", static_cast<int>(axis) + 1), 100) << command.name;
    }
  }
  EXPECT_EQ(count, 74);
}

// For every form: the second override only applies to Override2, WN commands have a number, and a
// G0 segment ends at rest whatever follows.
TEST(Segments, EveryCommandHasTheEffectsThatItsNamePromises) {
  for (const Command& command : GtsCatalogue().commands()) {
    if (command.number < 230 || command.number > 303) continue;
    const std::string name(command.name);
    const auto has = [&](std::string_view part) { return name.find(part) != std::string::npos; };
    CrdCommandCard card;
    card.SetUp(4);
    EXPECT_EQ(card.Call("GT_SetOverride", {1, 0.5}), 0);
    EXPECT_EQ(card.Call("GT_SetOverride2", {1, 0.2}), 0);
    std::vector<Argument> arguments = ArgumentsFor(command);
    for (size_t i = 0; i < arguments.size(); ++i) {
      if (command.parameters[i].name == "velEnd") arguments[i] = 1;
    }
    ASSERT_EQ(card.Call(command, arguments), 0) << name;
    EXPECT_EQ(card.Call("GT_LnXYZA", {1, 900, 900, 900, 900, 10, 1, 0, 0}), 0);
    EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
    card.Cycles(8);
    EXPECT_DOUBLE_EQ(card.ReadCrd("GT_GetCrdVel"), has("Override2") ? 2 : 5) << name;
    EXPECT_EQ(card.ReadFifo("GT_GetUserSegNumWN"), has("WN") ? 9 : 0) << name;
    // The minimum speed around the end of the segment.
    double slowest = 10;
    const auto& fifo = card.motion.state().crds[0].fifos[0];
    for (int i = 0; i < 300 && fifo.done == 0; ++i) {
      slowest = card.ReadCrd("GT_GetCrdVel");
      card.Cycle();
    }
    slowest = std::min(slowest, card.ReadCrd("GT_GetCrdVel"));
    if (has("G0")) {
      EXPECT_LT(slowest, 1) << name;
    } else {
      EXPECT_GE(slowest, 1) << name;
    }
  }
}

TEST(Segments, ImpossibleOnesAreRefused) {
  CrdCommandCard card;
  card.ExpectRefused(1, "GT_LnXY", {1, 100, 0, 10, 1, 0, 0});
  card.SetUp(3);
  card.ExpectRefused(7, "GT_LnXY", {1, 0, 0, 10, 1, 0, 0});
  card.ExpectRefused(7, "GT_LnXY", {1, 1073741824, 0, 10, 1, 0, 0});
  card.ExpectRefused(7, "GT_LnXY", {1, 100, 0, 0, 1, 0, 0});
  card.ExpectRefused(7, "GT_LnXY", {1, 100, 0, 10, 0, 0, 0});
  card.ExpectRefused(7, "GT_LnXY", {1, 100, 0, 10, 1, -1, 0});
  card.ExpectRefused(7, "GT_LnXY", {1, 100, 0, 10, 1, 0, 2});
  card.ExpectRefused(1, "GT_LnXYZA", {1, 1, 2, 3, 4, 10, 1, 0, 0});
  EXPECT_EQ(card.reason.en, "coordinate system 1 has 3 axes; this segment needs 4");
  card.ExpectRefused(7, "GT_ArcXYR", {1, 200, 0, 98, 0, 10, 1, 0, 0});
  card.ExpectRefused(7, "GT_ArcXYC", {1, 200, 0, 98, 0, 0, 10, 1, 0, 0});
  card.ExpectRefused(7, "GT_ArcXYZ", {1, 200, 0, 0, 100, 0, 0, 10, 1, 0, 0});
}

TEST(Segments, AFullFifoRefuses) {
  CrdCommandCard card;
  card.SetUp();
  for (int i = 1; i <= 4096; ++i) ASSERT_EQ(card.Line(i, 0), 0);
  card.ExpectRefused(1, "GT_LnXY", {1, 5000, 0, 10, 1, 0, 0});
}

TEST(Segments, G0EndsAtRest) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Call("GT_LnXYG0", {1, 100, 0, 10, 1, 0}), 0);
  EXPECT_TRUE(card.motion.state().crds[0].fifos[0].slots.front().ends_at_rest);
}

TEST(CrdData, LinesAndArcs) {
  CrdCommandCard card;
  card.SetUp();
  std::vector<double> cells(36);
  cells[2] = 100;
  cells[3] = 100;
  cells[15] = 10;
  cells[16] = 1;
  EXPECT_EQ(card.Call("GT_CrdData", {1, &cells, 0}), 0);
  cells[0] = 1;
  cells[2] = 0;
  cells[3] = 0;
  cells[10] = 100;
  EXPECT_EQ(card.Call("GT_CrdData", {1, &cells, 0}), 0);
  EXPECT_NEAR(card.motion.state().crds[0].fifos[0].slots.At(1).segment.length, 157.0796, 1e-4);
  cells[10] = 0;
  cells[12] = 50;
  EXPECT_EQ(card.Call("GT_CrdDataCircle", {1, &cells, 0}), 0);
  cells[0] = 6;
  card.ExpectRefused(7, "GT_CrdData", {1, &cells, 0});
  cells[0] = 0;
  cells[15] = 0;
  card.ExpectRefused(7, "GT_CrdData", {1, &cells, 0});
}

}  // namespace
}  // namespace oncard::gtcalls::gts
