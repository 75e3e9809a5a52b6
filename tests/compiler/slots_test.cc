// Programs whose variables take more slots than the card has: locals share them, and constant
// tables move to the page of their function. What such programs compute is compared with gcc
// (tests/differential/lowered_test.cc).
#include <fmt/core.h>
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "compiler/lowering/lowering.h"
#include "compiler_support.h"
#include "memory_files.h"

namespace oncard::compiler {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kNeedsTooMany = 237;

Lowering LowerSlots(const std::string& text, const LoweringOptions& lowering_options = {}) {
  return LowerText("slots.c", text, {}, lowering_options, NoFiles());
}

// The variables of the first function that have the slots of another one.
std::vector<std::string> SharedIn(const Lowering& lowering) {
  std::vector<std::string> names;
  for (const SharedSlotsCost& shared : lowering.costs.at(0).shared_slots) {
    names.insert(names.end(), shared.others.begin(), shared.others.end());
  }
  return names;
}

void ExpectFits(const std::string& text, const std::vector<std::string>& shared) {
  const Lowering lowering = LowerSlots(text);
  EXPECT_TRUE(lowering.object.has_value()) << text;
  EXPECT_EQ(SharedIn(lowering), shared) << text;
  EXPECT_LE(lowering.costs.at(0).page_slots, vm::kSlotCount) << text;
}

void ExpectTooMany(const std::string& text, const LoweringOptions& lowering_options = {}) {
  const Lowering lowering = LowerSlots(text, lowering_options);
  ASSERT_EQ(lowering.diagnostics.size(), 1u) << text;
  EXPECT_EQ(lowering.diagnostics[0].info->code, kNeedsTooMany);
}

// A statement that fills an array of 600 numbers and one that reads it.
std::string Uses(const std::string& name) {
  return fmt::format("for (i = 0; i < 600; i++) {0}[i] = i; g += {0}[g & 511];", name);
}

std::string ThreadFunction(const std::string& body) {
  return "int g;\nvoid t0() {\n  int i;\n  " + body + "\n}\n";
}

TEST(Slots, ArraysOfBlocksOneAfterTheOther) {
  ExpectFits(ThreadFunction("{ int a[600]; " + Uses("a") + " } { int b[600]; " + Uses("b") + " }"),
             {"b"});
}

TEST(Slots, ArraysThatAreUsedOneAfterTheOther) {
  ExpectFits(ThreadFunction("int a[600], b[600]; " + Uses("a") + Uses("b")), {"b"});
}

// Nothing of an array is left when its block begins again.
TEST(Slots, ArraysOfBlocksInALoop) {
  ExpectFits(ThreadFunction("while (g < 9) { { int a[600]; " + Uses("a") + " } { int b[600]; " +
                            Uses("b") + " } }"),
             {"b"});
  ExpectFits(ThreadFunction("while (1) { int a[600]; " + Uses("a") + " if (g) { int b[600]; " +
                            Uses("b") + " } }"),
             {"b"});
}

TEST(Slots, ArraysOfInlinedFunctions) {
  const auto function = [](const std::string& name) {
    return "static void " + name + "() { int i, list[600]; " + Uses("list") + " }\n";
  };
  ExpectFits("int g;\n" + function("up") + function("down") +
                 "void t0() { while (g < 99) { up(); down(); } }\n",
             {"down_list"});
}

TEST(Slots, ArraysThatBothHaveValuesDoNotShare) {
  ExpectTooMany(ThreadFunction("int a[600], b[600]; " + Uses("a") + Uses("b") + Uses("a") +
                               " g += b[g & 511];"));
  // Both keep their values when the loop goes on.
  ExpectTooMany(
      ThreadFunction("int a[600], b[600]; while (g < 9) { g += a[g & 511] + b[g & 511]; " +
                     Uses("a") + Uses("b") + " }"));
}

TEST(Slots, WhatTheHostWritesIsKept) {
  const Lowering lowering = LowerSlots(
      "int g;\nvoid t0() {\n  int go, other, list[4], more[4];\n  g = 1;\n  other = g * g;\n"
      "  more[g] = other;\n  g = more[0];\n  while (go < 9 + list[2]) g += go;\n}\n",
      {.slots = 0});
  ASSERT_TRUE(lowering.object.has_value());
  EXPECT_THAT(SharedIn(lowering), IsEmpty());
}

// A function whose calls are jumps stands where its first call is; the arrays of the others live
// on.
TEST(Slots, ArraysOfCallersLiveThroughCallsThatAreJumps) {
  const auto uses = [](const std::string& name) {
    return fmt::format("for (i = 0; i < 300; i++) {0}[i] = i + g; g += {0}[g & 255];", name);
  };
  const std::string program =
      "int g;\nstatic void f(int n) {\n  int i, own[300];\n  " + uses("own") +
      " if (g > n) g -= n; g ^= n;\n}\n"
      "void t0() {\n  int i, all[300];\n  " +
      uses("all") + "\n  f(1);\n  { int block[300], other[300]; " + uses("block") + uses("other") +
      " f(2); f(3); g += block[g & 255] + other[g & 255]; }\n  g += all[g & 255];\n}\n";
  const Lowering lowering = LowerSlots(program);
  ASSERT_EQ(lowering.costs.at(0).jumps.size(), 1u);
  EXPECT_THAT(SharedIn(lowering), Not(Contains(AnyOf("block", "other", "f_own"))));
  EXPECT_FALSE(lowering.object.has_value());
}

// An index is checked against the size of its own array.
TEST(Slots, ArraysOfDifferentSizesDoNotShare) {
  ExpectTooMany(
      ThreadFunction("{ int a[600]; " + Uses("a") + " } { int b[601]; " + Uses("b") + " }"));
}

TEST(Slots, IntsAndDoublesDoNotShare) {
  ExpectTooMany(
      ThreadFunction("{ int a[600]; " + Uses("a") + " } { double b[600]; " + Uses("b") + " }"));
}

TEST(Slots, NoMoreShareThanMust) {
  ExpectFits(
      ThreadFunction("{ int a[400]; a[g] = g; g = a[0]; } { int b[400]; b[g] = g; g = b[1]; }"),
      {});
  ExpectFits(
      ThreadFunction("{ int a[400]; a[g] = g; g = a[0]; } { int b[400]; b[g] = g; g = b[1]; }"
                     "{ int c[400]; c[g] = g; g = c[1]; }"),
      {"b"});
}

TEST(Slots, NothingSharesWithoutThePasses) {
  ExpectTooMany(
      ThreadFunction("{ int a[600]; " + Uses("a") + " } { int b[600]; " + Uses("b") + " }"),
      {.optimize = false});
}

std::string Table(const std::string& name, int size) {
  std::string text = "static const int " + name + "[] = {";
  for (int i = 0; i < size; ++i) text += fmt::format("{}, ", i * i);
  return text + "};\n";
}

TEST(Slots, ATableOfOneFunctionMovesToItsPage) {
  const Lowering lowering =
      LowerSlots("int g;\n" + Table("squares", 900) + Table("more", 200) +
                 "void t0() { g += squares[g & 511]; }\nvoid t1() { g += more[g & 127]; }\n");
  ASSERT_TRUE(lowering.object.has_value());
  EXPECT_THAT(lowering.costs[0].tables, ElementsAre("squares"));
  EXPECT_THAT(lowering.costs[1].tables, IsEmpty());
  EXPECT_EQ(lowering.costs[0].page_slots, 901);  // and an index
  EXPECT_EQ(lowering.global_slots, 205);         // and those of the start
  // It is written when the function starts, after the globals of all have been.
  EXPECT_THAT(*lowering.text, HasSubstr("lbl_start:\n  // 2: static const int squares"));
  EXPECT_THAT(*lowering.text, HasSubstr("squares[0] = 0;\n  squares[1] = 1;\n  squares[2] = 4;\n"));
}

TEST(Slots, ATableOfTwoFunctionsStaysGlobal) {
  ExpectTooMany("int g;\n" + Table("squares", 900) + Table("more", 200) +
                "void t0() { g += squares[g & 511] + more[3]; }\n"
                "void t1() { g += squares[g & 511] + more[g & 127]; }\n");
}

TEST(Slots, WhatCanBeWrittenStaysGlobal) {
  ExpectTooMany(
      "int g, list[900], other[200];\n"
      "void t0() { list[g] = g; g += list[0]; }\nvoid t1() { other[g] = g; }\n");
}

TEST(Slots, TablesStayGlobalWhereTheyFit) {
  const Lowering lowering =
      LowerSlots("int g;\n" + Table("squares", 900) + "void t0() { g += squares[g & 511]; }\n");
  EXPECT_THAT(lowering.costs.at(0).tables, IsEmpty());
  EXPECT_EQ(lowering.global_slots, 905);
}

}  // namespace
}  // namespace oncard::compiler
