// Programs whose variables take more slots than the card has: locals share them. What such
// programs compute is compared with gcc (tests/differential/lowered_test.cc).
#include <fmt/core.h>
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "compiler/lowering/lowering.h"
#include "compiler_support.h"
#include "memory_files.h"

namespace oncard::compiler {
namespace {

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

}  // namespace
}  // namespace oncard::compiler
