// Commands that a host calls all the time leave a moving card in its lanes (motion/cycle_block.h).
#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/cycle_counter.h"

namespace oncard::gtcalls::gts {
namespace {

/// What follows the first argument of a command.
enum class LaneRest {
  kValuesOfAll,  ///< values of all axes, their number, and the clock
  kWord,         ///< a word that it reads
  kNumber,       ///< a number that it sets
  kNothing
};

struct LaneCommand {
  std::string_view name;
  int first = 1;
  LaneRest rest = LaneRest::kValuesOfAll;
};

constexpr LaneCommand kLaneCommands[] = {
    {"GT_GetPrfPos"},
    {"GT_GetPrfVel"},
    {"GT_GetPrfAcc"},
    {"GT_GetPrfMode"},
    {"GT_GetAxisPrfPos"},
    {"GT_GetAxisPrfVel"},
    {"GT_GetAxisPrfAcc"},
    {"GT_GetAxisEncPos"},
    {"GT_GetAxisEncVel"},
    {"GT_GetAxisEncAcc"},
    {"GT_GetAxisError"},
    {"GT_GetEncPos"},
    {"GT_GetEncVel"},
    {"GT_GetSts"},
    {"GT_GetDi", 4, LaneRest::kWord},
    {"GT_GetDo", 12, LaneRest::kWord},
    {"GT_GetDac", 1, LaneRest::kValuesOfAll},
    {"GT_GetAdc", 1, LaneRest::kValuesOfAll},
    {"GT_GetPosErr", 1, LaneRest::kWord},
    {"GT_GetHomeStatus", 1, LaneRest::kWord},
    {"GT_GetVel", 1, LaneRest::kWord},
    {"GT_GetPos", 8, LaneRest::kWord},
    {"GT_Update", 1, LaneRest::kNothing},
    {"GT_SetVel", 1, LaneRest::kNumber},
    {"GT_SetPos", 8, LaneRest::kNumber},
};

TEST(LaneCommands, LeaveACardInItsLanes) {
  constexpr int kAxes = 8;
  constexpr int kCycles = 400;
  for (const LaneCommand& command : kLaneCommands) {
    SCOPED_TRACE(command.name);
    CommandTestCard card;
    // The last axis rests in mode Trap.
    for (int axis = 1; axis < kAxes; ++axis) {
      std::vector<double> jog = {0.5, 0.5, 0};
      card.Expect(0, "GT_AxisOn", {axis});
      card.Expect(0, "GT_PrfJog", {axis});
      card.Expect(0, "GT_SetJogPrm", {axis, &jog});
      card.Expect(0, "GT_SetVel", {axis, 10 + axis});
    }
    card.Expect(0, "GT_Update", {(1 << (kAxes - 1)) - 1});
    motion::CycleCounter counter;
    counter.Count(card.motion);
    std::vector<double> values(kAxes);
    for (int i = 0; i < kCycles; ++i) {
      card.motion.Advance(1);
      switch (command.rest) {
        case LaneRest::kValuesOfAll:
          card.Expect(0, command.name, {command.first, &values, kAxes, nullptr});
          break;
        case LaneRest::kWord:
          card.Expect(0, command.name, {command.first, &values});
          break;
        case LaneRest::kNumber:
          card.Expect(0, command.name, {command.first, i});
          break;
        case LaneRest::kNothing:
          card.Expect(0, command.name, {command.first});
      }
    }
    // The cycles before lanes are loaded first, and after a motion begins.
    EXPECT_GE(counter.cycles(), kCycles - 20);
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gts
