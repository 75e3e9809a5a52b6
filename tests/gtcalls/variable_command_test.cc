// GT_SetVarValue and GT_GetVarValue.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

constexpr double kInt = 1;
constexpr double kDouble = 2;

/// Thread 0 runs loop() on page 3.
void Prepare(CommandTestCard& card) {
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kLoopFunction, 3}), 0);
}

int16_t Set(CommandTestCard& card, double page, std::vector<double> info,
            std::vector<double> values) {
  return card.Call("GT_SetVarValue", {page, &info, &values, static_cast<double>(values.size())});
}

std::vector<double> Get(CommandTestCard& card, double page, std::vector<double> info,
                        size_t count) {
  std::vector<double> values(count);
  EXPECT_EQ(card.Call("GT_GetVarValue", {page, &info, &values, static_cast<double>(count)}), 0);
  return values;
}

TEST(VarValue, GlobalsAndLocalsReadBack) {
  CommandTestCard card;
  Prepare(card);
  EXPECT_EQ(Set(card, -1, {0, kInt}, {-7}), 0);
  EXPECT_EQ(Set(card, 3, {0, kInt}, {2147483647}), 0);
  EXPECT_EQ(Set(card, 3, {1, kDouble}, {-1.5}), 0);
  EXPECT_EQ(Get(card, -1, {0, kInt}, 1), std::vector<double>{-7});
  EXPECT_EQ(Get(card, 3, {0, kInt}, 2), (std::vector<double>{2147483647, -1.5}));
}

TEST(VarValue, SeveralSlotsMayHaveDifferentTypes) {
  CommandTestCard card;
  Prepare(card);
  EXPECT_EQ(Set(card, -1, {0, kInt}, {1, 2.25, 3, 4, 5}), 0);
  EXPECT_EQ(Get(card, -1, {0, kInt}, 5), (std::vector<double>{1, 2.25, 3, 4, 5}));
}

TEST(VarValue, CountIsOneToSix) {
  CommandTestCard card;
  Prepare(card);
  std::vector<double> info = {0, kInt};
  std::vector<double> values(8);
  for (const auto& [count, code] : {std::pair{0, 7}, {1, 0}, {6, 0}, {7, 7}, {-1, 7}}) {
    EXPECT_EQ(card.Call("GT_SetVarValue", {3, &info, &values, double(count)}), code) << count;
    EXPECT_EQ(card.Call("GT_GetVarValue", {3, &info, &values, double(count)}), code) << count;
  }
}

TEST(VarValue, PageIsMinusOneToThirtyOne) {
  CommandTestCard card;
  Prepare(card);
  for (const auto& [page, code] : {std::pair{-2, 7}, {-1, 0}, {0, 0}, {31, 0}, {32, 7}}) {
    EXPECT_EQ(Set(card, page, {0, kInt}, {1}), code) << page;
  }
}

TEST(VarValue, SlotsBeyondTheDeclaredOnesAreRefused) {
  struct {
    double page;
    double id;
    size_t count;
    int code;
  } const cases[] = {
      {-1, 4, 1, 0}, {-1, 5, 1, 7},    {-1, 0, 5, 0},   {-1, 0, 6, 7},    {-1, -1, 1, 7},
      {3, 5, 1, 0},  {3, 6, 1, 7},     {3, 1, 5, 0},    {3, 1, 6, 7},     {3, -1, 1, 7},
      {3, 0, 6, 0},  {-1, 1023, 1, 7}, {3, 1024, 1, 7}, {3, 32767, 1, 7}, {3, -32768, 1, 7},
  };
  for (const auto& c : cases) {
    CommandTestCard card;
    Prepare(card);
    const uint64_t before = card.Hash();
    EXPECT_EQ(Set(card, c.page, {c.id, kInt}, std::vector<double>(c.count, 1)), c.code)
        << c.page << " " << c.id << " " << c.count;
    if (c.code != 0) {
      EXPECT_EQ(card.Hash(), before);
    }
  }
}

TEST(VarValue, AValueThatDoesNotFitLeavesAllAsItWas) {
  struct {
    double id;
    std::vector<double> values;
  } const cases[] = {
      {0, {2147483648.0}},
      {0, {-2147483649.0}},
      {0, {std::numeric_limits<double>::quiet_NaN()}},
      {1, {2147483648.0}},
      {1, {std::numeric_limits<double>::infinity()}},
      {0, {5, 6, 2147483648.0}},
      {2, {5, 6, 7, 1e300}},
  };
  for (const auto& c : cases) {
    CommandTestCard card;
    Prepare(card);
    const uint64_t before = card.Hash();
    EXPECT_EQ(Set(card, 3, {c.id, kInt}, c.values), 7) << c.id;
    EXPECT_EQ(card.Hash(), before) << c.id;
  }
}

TEST(VarValue, FractionsAreTruncatedTowardZero) {
  CommandTestCard card;
  Prepare(card);
  EXPECT_EQ(Set(card, 3, {0, kInt}, {-2.75, 0.1}), 0);
  EXPECT_EQ(Get(card, 3, {0, kInt}, 2), (std::vector<double>{-2, 6553.0 / 65536.0}));
}

TEST(VarValue, TheFunctionOfTheBoundThreadDecidesTheType) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kIntFunction, 3}), 0);  // slot 0 is a double there
  EXPECT_EQ(Set(card, 3, {0, kInt}, {0.5}), 0);
  EXPECT_EQ(Get(card, 3, {0, kInt}, 1), std::vector<double>{0.5});
}

TEST(VarValue, APageNobodyHoldsTakesTheTypeOfTVarInfo) {
  CommandTestCard card;
  Prepare(card);
  EXPECT_EQ(Set(card, 9, {0, kDouble}, {0.5}), 0);  // answer() declares slot 0 as a double
  EXPECT_EQ(Get(card, 9, {0, kDouble}, 1), std::vector<double>{0.5});
  EXPECT_EQ(Set(card, 9, {0, kInt}, {4}), 0);  // loop() declares it as an int
  EXPECT_EQ(Set(card, 9, {2, kDouble}, {1}), 7);
  EXPECT_EQ(Set(card, 9, {0, 0}, {1}), 7);
}

TEST(VarValue, WithoutAProgramThereAreNoVariables) {
  CommandTestCard card;
  std::vector<double> info = {0, kInt};
  std::vector<double> value = {1};
  EXPECT_EQ(card.Call("GT_SetVarValue", {-1, &info, &value, 1}), 7);
  EXPECT_EQ(card.Call("GT_GetVarValue", {0, &info, &value, 1}), 7);
  EXPECT_EQ(card.reason.en, "no program is downloaded; call GT_Download first");
}

}  // namespace
}  // namespace oncard::gtcalls::gts
