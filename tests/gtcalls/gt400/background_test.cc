// Background sets: commands that the card executes in the tick of an interrupt. Source: GT manual
// 8.2.2, whose example takes data from both of its members; numbers of commands: public header.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

struct BackgroundCommand {
  uint16_t number = 0;
  uint32_t in = 0;
  uint32_t out = 0;
};
struct BackgroundKind {
  uint16_t mask = 0;
  std::vector<BackgroundCommand> commands;
};

void Append(uint32_t value, int bytes, std::vector<double>* memory) {
  for (int i = 0; i < bytes; ++i) memory->push_back(value >> (8 * i) & 0xFF);
}

/// The memory of a set, one cell for each byte.
std::vector<double> Memory(const std::vector<BackgroundKind>& kinds) {
  std::vector<double> memory;
  Append(static_cast<uint32_t>(kinds.size()), 4, &memory);
  for (const BackgroundKind& kind : kinds) {
    Append(kind.mask, 2, &memory);
    Append(static_cast<uint32_t>(kind.commands.size()), 2, &memory);
    for (const BackgroundCommand& command : kind.commands) {
      Append(command.number, 2, &memory);
      Append(0, 4, &memory);  // the numbers of words, which the card does not need
      Append(0x1234, 2, &memory);
      Append(command.in, 4, &memory);
      Append(command.out, 4, &memory);
    }
  }
  return memory;
}

class BackgroundCard : public Gt400TestCard {
 public:
  int16_t Set(std::vector<double> memory) {
    const auto size = static_cast<double>(memory.size());
    return Call("GT_SetBgCommandSet", {size}, &memory);
  }
  /// The kinds act at the event that ends a motion without length of axis 2; axis 1 is current.
  void Act(const std::vector<BackgroundKind>& kinds) {
    ASSERT_EQ(Set(Memory(kinds)), 0) << reason.en;
    for (const int axis : {1, 2}) Enable(axis);
    Do("GT_SetIntrMsk", {1});
    Do("GT_SetPos", {0});
    Do("GT_Axis", {1});
    Do("GT_MltiUpdt", {2});
  }
  std::vector<double> Result() {
    std::vector<double> memory(200);
    EXPECT_EQ(Call("GT_GetBgCommandResult", {200}, &memory), 0) << reason.en;
    return memory;
  }
  /// A member of a command of the first kind.
  uint32_t Member(size_t command, size_t at, int bytes) {
    const std::vector<double> memory = Result();
    uint32_t value = 0;
    for (int i = bytes - 1; i >= 0; --i) {
      value = value << 8 |
              static_cast<uint32_t>(memory[8 + 16 * command + at + static_cast<size_t>(i)]);
    }
    return value;
  }
  uint32_t ResultCode(size_t command) { return Member(command, 6, 2); }
  uint32_t Out(size_t command) { return Member(command, 12, 4); }
};

// In the tick of the interrupt the axis has a new target and moves towards it, without a gap.
TEST(Gt400Background, ActsInTheTickOfTheInterrupt) {
  BackgroundCard card;
  card.Enable(2);
  card.Do("GT_SetVel", {4});
  card.Do("GT_SetAcc", {1});
  card.Act({{0x01, {{0x41, 20000, 0}, {0x16, 0, 0}}}, {0x02, {{0x41, 30000, 0}}}});
  EXPECT_EQ(card.Status() >> 12 & 3, 0u) << "the current axis is the first one again";
  card.Do("GT_Axis", {2});
  EXPECT_TRUE(card.StatusBit(10));
  EXPECT_FALSE(card.StatusBit(0));
  EXPECT_EQ(card.Read("GT_GetPos"), 20000) << "only the kind of the event acts";
  card.RunToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 20000);
  EXPECT_EQ(card.ResultCode(0), 0u);
  EXPECT_EQ(card.ResultCode(1), 0u);
}

// The end of the motion interrupts, too, and the set moves the axis by the same target: it is
// there.
TEST(Gt400Background, ReadsRealsWithABinaryPoint) {
  BackgroundCard card;
  card.Act({{0x01,
             {{0x42, 0x00038000, 0},      // velocity 3.5
              {0x43, 0, 0x00004000},      // acceleration 0.25, in the other member
              {0x48, 0x00000001, 0},      // 2^-16
              {0x44, 0x00000001, 0},      // jerk 2^-32
              {0x41, 0xFFFFFFFB, 0}}}});  // -5
  card.Do("GT_Axis", {2});
  EXPECT_EQ(card.Read("GT_GetVel"), 3.5);
  EXPECT_EQ(card.Read("GT_GetAcc"), 0.25);
  EXPECT_EQ(card.Read("GT_GetMAcc"), 1.0 / 65536);
  EXPECT_EQ(card.Read("GT_GetJerk"), 1.0 / 4294967296);
  EXPECT_EQ(card.Read("GT_GetPos"), -5);
}

TEST(Gt400Background, WritesWhatCommandsRead) {
  BackgroundCard card;
  card.Act({{0x01,
             {{0x42, 0x00018000, 0},
              {0xa2, 0, 0},
              {0x44, 0x40000000, 0},
              {0xa4, 0, 0},
              {0x41, 0xFFFFFFFB, 0},
              {0xa1, 0, 0},
              {0x36, 0, 0},
              {0x3b, 0, 0}}}});
  EXPECT_EQ(card.Out(1), 0x00018000u);
  EXPECT_EQ(card.Out(3), 0x40000000u);
  EXPECT_EQ(card.Out(5), 0xFFFFFFFBu);
  EXPECT_EQ(card.Out(6), 0x1B00u) << "the driver has cleared the event";
  EXPECT_EQ(card.Out(7), 200u << 16);
}

// As long as the set acts another axis can be the current one.
TEST(Gt400Background, ChoosesOtherAxes) {
  BackgroundCard card;
  card.Act({{0x01, {{0x41, 1, 0}, {0x33, 0, 0}, {0x41, 4, 0}, {0x30, 0, 0}, {0x41, 9, 0}}}});
  const double targets[] = {9, 1, 0, 4};
  for (const int axis : {1, 2, 3, 4}) {
    card.Do("GT_Axis", {static_cast<double>(axis)});
    EXPECT_EQ(card.Read("GT_GetPos"), targets[axis - 1]) << axis;
  }
}

// A velocity that mode T does not have, an acceleration without range, and an Update in motion.
TEST(Gt400Background, SaysWhatWasRefused) {
  BackgroundCard card;
  card.Act({{0x01,
             {{0x42, 0xFFFF0000, 0},
              {0x42, 0x00010000, 0},
              {0x43, 0x00008000, 0},
              {0x41, 1000, 0},
              {0x16, 0, 0},
              {0x43, 0x00010000, 0},
              {0x20, 2, 0},
              {0x20, 0xF0, 0}}}});
  const uint32_t refused[] = {0xFFFF, 0, 0, 0, 0, 0, 0xFFFF, 0xFFFF};
  for (size_t i = 0; i < 8; ++i) EXPECT_EQ(card.ResultCode(i), refused[i]) << i;
}

TEST(Gt400Background, DoesNotActAtTimeInterrupts) {
  BackgroundCard card;
  ASSERT_EQ(card.Set(Memory({{0x7F, {{0x41, 7, 0}}}})), 0);
  card.Do("GT_SetIntrTm", {3});
  card.Do("GT_TmrIntr");
  card.Run(10);
  EXPECT_EQ(card.Read("GT_GetPos"), 0);
}

// --- The memory ------------------------------------------------------------------------------

// The manual: 4 + 4 * kinds + 16 * commands. What follows the set does not matter.
TEST(Gt400Background, HasTheSizeThatTheManualSays) {
  BackgroundCard card;
  const std::vector<BackgroundKind> kinds = {{1, {{0x41, 0, 0}, {0x16, 0, 0}}},
                                             {2, {{0x41, 0, 0}}}};
  std::vector<double> memory = Memory(kinds);
  ASSERT_EQ(memory.size(), 60u);
  EXPECT_EQ(card.Set(memory), 0);
  for (const size_t size : {size_t{59}, size_t{44}, size_t{30}, size_t{3}, size_t{0}}) {
    EXPECT_EQ(card.Set(std::vector(memory.begin(), memory.begin() + static_cast<long>(size))), -1)
        << size;
  }
  memory.resize(500);
  EXPECT_EQ(card.Set(memory), 0);
  std::vector<double> result(60);
  EXPECT_EQ(card.Call("GT_GetBgCommandResult", {60}, &result), 0);
  EXPECT_EQ(result, Memory(kinds));
  result.resize(59);
  EXPECT_EQ(card.Call("GT_GetBgCommandResult", {59}, &result), -1);
}

TEST(Gt400Background, HasKnownCommandsOnly) {
  BackgroundCard card;
  EXPECT_EQ(card.Set(Memory({{1, {{0x03, 0, 0}}}})), -1);
  EXPECT_NE(card.reason.en.find("0x03"), std::string::npos);
  EXPECT_EQ(card.Set(Memory({{1, {{0x34, 0, 0}}}})), -1) << "there is no axis 5";
}

TEST(Gt400Background, CanBeRemoved) {
  BackgroundCard card;
  std::vector<double> memory(100);
  EXPECT_EQ(card.Call("GT_GetBgCommandResult", {100}, &memory), -1);
  EXPECT_EQ(card.Set(Memory({{1, {{0x41, 0, 0}}}})), 0);
  EXPECT_EQ(card.Call("GT_SetBgCommandSet", {0}), 0);
  EXPECT_EQ(card.Call("GT_GetBgCommandResult", {100}, &memory), -1);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
