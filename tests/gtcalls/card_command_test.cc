// Rules for all commands: which are implemented, NULL pointers, ranges, refusals that change
// nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/commands/commands.h"
#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

using ::testing::StartsWith;

/// The commands that act on the card; those that the host library answers are tested with the
/// runtime.
const char* const kImplemented[] = {
    "GT_Bind",
    "GT_RunThread",
    "GT_StopThread",
    "GT_PauseThread",
    "GT_StepThread",
    "GT_RunThreadToBreakpoint",
    "GT_RunThreadPeriod",
    "GT_GetThreadSts",
    "GT_GetThreadTime",
    "GT_GetThread",
    "GT_SetVarValue",
    "GT_GetVarValue",
    "GT_GetClock",
    "GT_GetClockHighPrecision",
    "GT_Delay",
    "GT_DelayHighPrecision",
    "GT_SetDataPage",
    "GT_WaitForVarEq",
    "GT_SetDo",
    "GT_SetDoMask",
    "GT_SetDoBit",
    "GT_SetDoBitReverse",
    "GT_GetDo",
    "GT_EnableDoBitPulse",
    "GT_DisableDoBitPulse",
    "GT_GetDi",
    "GT_GetDiRaw",
    "GT_GetDiReverseCount",
    "GT_SetDiReverseCount",
    "GT_LmtSns",
    "GT_GpiSns",
    "GT_SetLongVar",
    "GT_GetLongVar",
    "GT_SetDoubleVar",
    "GT_GetDoubleVar",
    "GT_BindDi",
    "GT_BindDo",
    "GT_BindTimer",
    "GT_BindCounter",
    "GT_BindFlank",
    "GT_BindSrff",
    "GT_UnbindVar",
    "GT_ClearPlc",
    "GT_LoadPlc",
    "GT_LoadPlcCommand",
};

/// Arguments inside every range; each pointer has space for the largest structure.
class Arguments {
 public:
  explicit Arguments(const Command& command) : cells_(command.parameters.size()) {
    for (size_t i = 0; i < command.parameters.size(); ++i) {
      const Parameter& parameter = command.parameters[i];
      cells_[i].assign(32, 0.0);
      if (parameter.passing == Passing::kValue) {
        list.emplace_back(std::clamp(0.0, parameter.minimum, parameter.maximum));
      } else {
        list.emplace_back(&cells_[i]);
      }
    }
  }

  std::vector<Argument> list;

 private:
  std::vector<std::vector<double>> cells_;
};

template <typename Visit>
void ForEachImplemented(Visit visit) {
  for (const Command& command : GtsCatalogue().commands()) {
    if (GtsFamily().Executes(command)) visit(command);
  }
}

TEST(CardCommands, WhatPointersPointToMustFitItsTypes) {
  // The cells of TPid are kp, ki, kd, kvff, kaff, two longs and a short; those of TTrigger are
  // encoder, probeType, probeIndex, sense, offset, unsigned long loop, windowOnly and two longs.
  const std::vector<double> pid = {1, 0, 0, 0, 0, 100, 200, 300};
  const std::vector<double> trigger = {1, 1, 1, 0, 5, 0, 0, -7, 7};
  const struct {
    const char* name;
    std::vector<Argument> before;
    const std::vector<double>& cells;
    size_t cell;
    double value;
    int code;
  } cases[] = {
      {"GT_SetPid", {1, 1}, pid, 5, 7e18, 7},
      {"GT_SetPid", {1, 1}, pid, 5, -2147483649.0, 7},
      {"GT_SetPid", {1, 1}, pid, 6, 2147483647, 0},
      {"GT_SetPid", {1, 1}, pid, 7, 32768, 7},
      {"GT_SetTrigger", {1}, trigger, 4, -32769, 7},
      {"GT_SetTrigger", {1}, trigger, 5, -1, 7},
      {"GT_SetTrigger", {1}, trigger, 5, 4294967295, 0},
      {"GT_SetTrigger", {1}, trigger, 8, 5e9, 7},
  };
  for (const auto& c : cases) {
    CommandTestCard card;
    std::vector<double> cells = c.cells;
    cells[c.cell] = c.value;
    std::vector<Argument> arguments = c.before;
    arguments.emplace_back(&cells);
    card.Expect(static_cast<int16_t>(c.code), c.name, arguments);
  }
}

TEST(CardCommands, TheListedCommandsAreImplemented) {
  for (const char* name : kImplemented) {
    ASSERT_NE(GtsCatalogue().Find(name), nullptr) << name;
    EXPECT_TRUE(GtsFamily().Executes(*GtsCatalogue().Find(name))) << name;
  }
}

TEST(CardCommands, WhatIsNotImplementedIsNotSupportedByTheFirmware) {
  CommandTestCard card;
  const Command& command = *GtsCatalogue().Find("GT_SetAxisMode");
  EXPECT_FALSE(GtsFamily().Executes(command));
  EXPECT_EQ(card.Call(command, {1, 0}), 8);
  EXPECT_THAT(card.reason.en, StartsWith("GT_SetAxisMode is not supported by this card: "));
}

TEST(CardCommands, NullForARequiredPointerIsABadParameter) {
  ForEachImplemented([](const Command& command) {
    for (size_t i = 0; i < command.parameters.size(); ++i) {
      const Parameter& parameter = command.parameters[i];
      if (parameter.passing == Passing::kValue || parameter.nullable) continue;
      CommandTestCard card;
      card.LoadTestProgram();
      const uint64_t before = card.Hash();
      Arguments arguments(command);
      arguments.list[i] = nullptr;
      EXPECT_EQ(card.Call(command, arguments.list), 7) << command.name << " " << parameter.name;
      EXPECT_EQ(card.Hash(), before) << command.name;
    }
  });
}

TEST(CardCommands, AValueJustOutsideItsRangeIsABadParameter) {
  size_t checked = 0;
  ForEachImplemented([&](const Command& command) {
    for (size_t i = 0; i < command.parameters.size(); ++i) {
      const Parameter& parameter = command.parameters[i];
      if (parameter.passing != Passing::kValue) continue;
      for (const double value : {parameter.minimum - 1, parameter.maximum + 1}) {
        if (std::isinf(value)) continue;
        CommandTestCard card;
        card.LoadTestProgram();
        const uint64_t before = card.Hash();
        Arguments arguments(command);
        arguments.list[i] = value;
        EXPECT_EQ(card.Call(command, arguments.list, 0), 7)
            << command.name << " " << parameter.name << " = " << value;
        EXPECT_EQ(card.Hash(), before) << command.name;
        ++checked;
      }
    }
  });
  EXPECT_GT(checked, 60u);
}

TEST(CardCommands, AValueThatItsTypeCannotHoldIsABadParameter) {
  CommandTestCard card;
  struct {
    const char* name;
    std::vector<Argument> arguments;
  } const cases[] = {
      {"GT_SetLongVar", {0, 2147483648.0}},
      {"GT_SetLongVar", {0, -2147483649.0}},
      {"GT_LmtSns", {65536}},
      {"GT_LmtSns", {-1}},
      {"GT_SetDo", {12, 4294967296.0}},
      {"GT_SetDo", {12, -2147483649.0}},
      {"GT_SetDoBit", {12, 1, 32768}},
      {"GT_SetDoMask", {12, 65536, 0}},
      {"GT_RunThread", {std::numeric_limits<double>::quiet_NaN()}},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(card.Call(c.name, c.arguments), 7) << c.name << " " << c.arguments.back().value;
  }
}

TEST(CardCommands, ABitWordMayBeWrittenSignedOrUnsigned) {
  CommandTestCard card;
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_SetDo", {12, 4294967295.0}), 0);
  EXPECT_EQ(card.Call("GT_GetDo", {12, &value}), 0);
  EXPECT_EQ(value[0], 65535);
  EXPECT_EQ(card.Call("GT_SetDo", {12, -2}), 0);
  EXPECT_EQ(card.Call("GT_GetDo", {12, &value}), 0);
  EXPECT_EQ(value[0], 65534);
}

TEST(CardCommands, TheReasonNamesParameterValueAndRange) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_RunThread", {32}), 7);
  EXPECT_EQ(card.reason.en, "parameter thread is 32; the range is [0, 31]");
  EXPECT_EQ(card.reason.zh, "参数 thread 为 32；取值范围为 [0, 31]");
}

// Also where there is no range that it could name.
TEST(CardCommands, TheReasonSaysThatAParameterIsNoNumber) {
  CommandTestCard card;
  const double nan = std::nan("");
  card.Expect(7, "GT_SetVel", {1, nan});
  EXPECT_EQ(card.reason.en, "parameter vel is not a number");
  EXPECT_EQ(card.reason.zh, "参数 vel 不是数值");
  card.Expect(7, "GT_SetDoubleVar", {1, nan});
  EXPECT_EQ(card.reason.en, "parameter pValue is not a number");
  EXPECT_EQ(card.reason.zh, "参数 pValue 不是数值");
}

TEST(CardCommands, TheMachineFindsCommandsByNumber) {
  CommandTestCard card;
  const Command& command = *GtsCatalogue().Find("GT_SetDo");
  const vm::CommandShape* shape = card.commands.Find(command.number);
  ASSERT_NE(shape, nullptr);
  EXPECT_EQ(shape->name, "GT_SetDo");
  EXPECT_EQ(card.commands.Find(65535), nullptr);
}

TEST(CardCommands, AProgramCallsTheSameFunction) {
  CommandTestCard card;
  std::vector<vm::CommandArgument> arguments(2);
  arguments[0].value = 12;
  arguments[1].value = 5;
  EXPECT_EQ(
      card.commands.Execute(GtsCatalogue().Find("GT_SetDo")->number, card.machine, 0, arguments),
      0);
  EXPECT_EQ(card.motion.state().io.Register(motion::DoType::kGpo), 5u);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
