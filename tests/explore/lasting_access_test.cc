// What threads share beyond single statements: what cycles connect.
#include "runtime/observe/lasting_access.h"

#include <gtest/gtest.h>

#include <string>

#include "explore_programs.h"
#include "runtime/conditions/card_condition.h"

namespace oncard::explore {
namespace {

using runtime::FindDependence;

/// True if the first statements of two threads are apart for good.
bool AreApart(const std::string& first, const std::string& second, const std::string& keys = {}) {
  const std::string variables = "int g;\nint h;\nint s[2];\n";
  CardModel model = CardOf(variables + "int t0() { int n; int p[2]; " + first + " return 0; }\n" +
                               "int t1() { int n; int p[2]; " + second + " return 0; }\n",
                           keys);
  model.Begin();
  return FindDependence(runtime::NextLastingAccess(model.controller(), 0),
                        runtime::NextLastingAccess(model.controller(), 1)) == nullptr;
}

TEST(LastingAccess, AxesAndOutputsAreApart) {
  EXPECT_TRUE(AreApart("GT_AxisOn(1);", "GT_AxisOn(2);"));
  EXPECT_TRUE(AreApart("GT_Update(1);", "GT_Stop(2, 0);"));
  EXPECT_FALSE(AreApart("GT_Update(1);", "GT_Stop(3, 0);"));
  EXPECT_TRUE(AreApart("GT_SetDoBit(12, 1, 0);", "GT_SetDoBit(12, 2, 0);"));
  EXPECT_FALSE(AreApart("GT_SetDoBit(12, 1, 0);", "GT_SetDo(12, 0);"));
}

TEST(LastingAccess, VariablesThatAreOnlyReadAreApart) {
  EXPECT_TRUE(AreApart("n = g;", "h = g;"));
  EXPECT_FALSE(AreApart("g = 1;", "h = g;"));
}

// The servo controller of an axis moves it, and its encoder measures it.
TEST(LastingAccess, AnAxisIsAllOfItsParts) {
  EXPECT_FALSE(AreApart("GT_SetEncPos(1, 0);", "GT_Update(1);"));
  EXPECT_FALSE(AreApart("GT_SetPosErr(1, 100);", "GT_Update(1);"));
  EXPECT_TRUE(AreApart("GT_SetPosErr(1, 100);", "GT_Update(2);"));
}

// A slave follows its master in every cycle after the start.
TEST(LastingAccess, ASlaveReadsAllAxes) {
  EXPECT_FALSE(AreApart("GT_GearStart(1);", "GT_Update(2);"));
}

TEST(LastingAccess, WhatCyclesMayConnectIsEverything) {
  EXPECT_FALSE(AreApart("GT_SetDac(1, &s[0], 1);", "GT_Update(2);"));
  EXPECT_FALSE(AreApart("GT_LmtSns(0);", "GT_AxisOn(2);"));
  EXPECT_FALSE(AreApart("GT_SetCaptureMode(1, 1);", "GT_SetDoBit(12, 2, 0);"));
  // The clear output of an axis.
  EXPECT_FALSE(AreApart("GT_SetDoBit(11, 1, 0);", "GT_AxisOn(2);"));
}

TEST(LastingAccess, InputsBelongToTheAxesThatOperateThem) {
  EXPECT_TRUE(AreApart("GT_GetDi(4, &n);", "GT_Update(1);"));
  EXPECT_FALSE(AreApart("GT_GetDi(3, &n);", "GT_Update(1);"));
  const std::string contact = "[[world.switch]]\naxis = 1\ntype = \"gpi\"\nindex = 5\nfrom = 10\n";
  EXPECT_FALSE(AreApart("GT_GetDi(4, &n);", "GT_Update(1);", contact));
  EXPECT_TRUE(AreApart("GT_GetDi(4, &n);", "GT_Update(2);", contact));
}

TEST(LastingAccess, AConditionReadsWhatItNames) {
  CardModel model = CardOf("int g;\nint t0() { GT_Update(1); g = 1; return 0; }\n", {});
  model.Begin();
  const auto reads = [&](const char* text) {
    const auto bound =
        runtime::CardCondition::Bind(runtime::ParseCondition(text).value(), model.controller());
    return FindDependence(runtime::NextLastingAccess(model.controller(), 0),
                          runtime::LastingAccessOf(bound.value().quantities()[0],
                                                   model.controller())) != nullptr;
  };
  EXPECT_TRUE(reads("axis1.prfPos > 0"));
  EXPECT_TRUE(reads("encoder1.pos > 0"));
  EXPECT_FALSE(reads("axis2.prfPos > 0"));
  EXPECT_FALSE(reads("g == 1"));
  EXPECT_FALSE(reads("clock > 1"));
  EXPECT_FALSE(reads("gpi[1] == 1"));
  EXPECT_TRUE(reads("home == 1"));
  EXPECT_TRUE(reads("ret0 == 1"));
  EXPECT_TRUE(reads("dac1 == 1"));
}

}  // namespace
}  // namespace oncard::explore
