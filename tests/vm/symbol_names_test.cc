#include "vm/symbol_names.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace oncard::vm {
namespace {

// The globals of
//   int x, data[4], m[2][3];
//   struct axis { int target; double gains[2]; struct { int y[5]; } in[2]; } axis[3];
//   struct { int x; TTrapPrm trap; } p;
std::vector<Symbol> Globals() {
  return {{"x", 0, DataType::kInt, 0, {}},
          {"data", 1, DataType::kInt, 4, {}},
          {"m", 5, DataType::kInt, 6, "m[2][3]"},
          {"axis_target", 11, DataType::kInt, 3, "axis[3].target"},
          {"axis_gains", 14, DataType::kDouble, 6, "axis[3].gains[2]"},
          {"axis_in_y", 20, DataType::kInt, 30, "axis[3].in[2].y[5]"},
          {"p_x", 50, DataType::kInt, 0, "p.x"},
          {"p_trap.acc", 51, DataType::kDouble, 0, "p.trap.acc"}};
}

// What a name names, as `m 3-4` for the elements 3 and 4 of m and `m 3` for a number, or why not.
std::string Find(const std::string& name) {
  const std::vector<Symbol> globals = Globals();
  const auto found = FindNamed(globals, name);
  if (!found.ok()) return found.error().message.en;
  std::string text;
  for (const NamedSlots& slots : found.value()) {
    text += (text.empty() ? "" : ", ") + slots.symbol->name + " " + std::to_string(slots.first);
    if (!slots.is_number) text += "-" + std::to_string(slots.first + slots.count - 1);
  }
  return text;
}

TEST(SymbolNames, NamesOfTheProgram) {
  EXPECT_EQ(Find("x"), "x 0");
  EXPECT_EQ(Find("data"), "data 0-3");
  EXPECT_EQ(Find("data[3]"), "data 3");
  EXPECT_EQ(Find("axis_gains[5]"), "axis_gains 5");
  EXPECT_EQ(Find("p_trap.acc"), "p_trap.acc 0");
}

TEST(SymbolNames, NamesOfC) {
  EXPECT_EQ(Find("m[1][2]"), "m 5");
  EXPECT_EQ(Find("axis[2].target"), "axis_target 2");
  EXPECT_EQ(Find("axis[2].gains[1]"), "axis_gains 5");
  EXPECT_EQ(Find("axis[2].in[1].y[3]"), "axis_in_y 28");  // (2 * 2 + 1) * 5 + 3
  EXPECT_EQ(Find("p.x"), "p_x 0");
  EXPECT_EQ(Find("p.trap.acc"), "p_trap.acc 0");
}

TEST(SymbolNames, NamesOfCForMoreThanANumber) {
  EXPECT_EQ(Find("axis[1].gains"), "axis_gains 2-3");
  EXPECT_EQ(Find("axis[1].in[0]"), "axis_in_y 10-14");
  EXPECT_EQ(
      Find("axis[1]").find("axis_target 1-1, axis_gains 2-2, axis_gains 3-3, axis_in_y 10-10"), 0u);
  // One element after the other, as C counts them.
  EXPECT_EQ(Find("axis").find("axis_target 0-0, axis_gains 0-0, axis_gains 1-1, axis_in_y 0-0"),
            0u);
  EXPECT_EQ(Find("axis").substr(Find("axis").rfind("axis_gains")),
            "axis_gains 5-5, axis_in_y 20-20, axis_in_y 21-21, axis_in_y 22-22, axis_in_y 23-23, "
            "axis_in_y 24-24, axis_in_y 25-25, axis_in_y 26-26, axis_in_y 27-27, axis_in_y 28-28, "
            "axis_in_y 29-29");
  EXPECT_EQ(Find("p"), "p_x 0-0, p_trap.acc 0-0");
}

// `m[1]` is a row in C and an element on the card.
TEST(SymbolNames, ANameOfTheProgramIsMeantFirst) {
  EXPECT_EQ(Find("m[1]"), "m 1");
  EXPECT_EQ(Find("m[5]"), "m 5");
  EXPECT_EQ(Find("m"), "m 0-5");
}

TEST(SymbolNames, NothingIsNamedSo) {
  EXPECT_EQ(Find("y"), "");
  EXPECT_EQ(Find("gpo[1]"), "");
  EXPECT_EQ(Find("x.y"), "");  // a card has such names, too: `axis1.prfPos`
  for (const char* no_name : {"", "m[", "m[x]", "m[1]2", "m[-1]", "m[1][2]."}) {
    SCOPED_TRACE(no_name);
    EXPECT_EQ(Find(no_name).find("m 1"), std::string::npos);
  }
}

TEST(SymbolNames, MistakesBehindAKnownName) {
  EXPECT_EQ(Find("axis[2].targt"), "'axis[2]' has no member 'targt'; did you mean 'target'?");
  EXPECT_EQ(Find("axis[2].in[0].z"), "'axis[2].in[0]' has no member 'z': it has y");
  EXPECT_EQ(Find("axis[3].target"), "'axis' has elements 0 to 2, not 3");
  EXPECT_EQ(Find("axis[1].gains[2]"), "'axis[1].gains' has elements 0 to 1, not 2");
  EXPECT_EQ(Find("m[0][3]"), "'m' has elements 0 to 2, not 3");
  EXPECT_EQ(Find("m[6]"), "'m' has elements 0 to 5, not 6");
  EXPECT_EQ(Find("data[1][1]"), "'data' is not an array");
  EXPECT_EQ(Find("x[0]"), "'x' is not an array");
  EXPECT_EQ(Find("axis.target"),
            "'axis' is an array of 3 elements: write one of them, such as 'axis[0]'");
}

TEST(SymbolNames, OfElements) {
  const std::vector<Symbol> globals = Globals();
  EXPECT_EQ(NameOfElement(globals[0], 0), "x");
  EXPECT_EQ(NameOfElement(globals[1], 3), "data[3]");
  EXPECT_EQ(NameOfElement(globals[2], 5), "m[1][2]");
  EXPECT_EQ(NameOfElement(globals[5], 28), "axis[2].in[1].y[3]");
  EXPECT_EQ(NameOfElement(globals[7], 0), "p.trap.acc");
}

// Every name that an element has leads to it.
TEST(SymbolNames, LeadBack) {
  const std::vector<Symbol> globals = Globals();
  for (const Symbol& symbol : globals) {
    for (int i = 0; i < symbol.slots(); ++i) {
      const auto found = FindNamed(globals, NameOfElement(symbol, i));
      ASSERT_TRUE(found.ok());
      ASSERT_EQ(found.value().size(), 1u);
      EXPECT_EQ(found.value()[0].symbol, &symbol);
      EXPECT_EQ(found.value()[0].first, i);
      EXPECT_TRUE(found.value()[0].is_number);
    }
  }
}

TEST(SymbolNames, AllInTheOrderOfC) {
  const std::vector<Symbol> globals = Globals();
  std::vector<std::string> names;
  for (const NamedSlots& slots : AllInOrder(globals)) {
    for (int i = 0; i < slots.count; ++i) {
      names.push_back(NameOfElement(*slots.symbol, slots.first + i));
    }
  }
  ASSERT_EQ(names.size(), 52u);
  EXPECT_EQ(names[0], "x");
  EXPECT_EQ(names[10], "m[1][2]");
  EXPECT_EQ(names[11], "axis[0].target");
  EXPECT_EQ(names[13], "axis[0].gains[1]");
  EXPECT_EQ(names[14], "axis[0].in[0].y[0]");
  EXPECT_EQ(names[24], "axis[1].target");
  EXPECT_EQ(names[51], "p.trap.acc");
}

TEST(SymbolNames, OfVariables) {
  const std::vector<Symbol> globals = Globals();
  EXPECT_EQ(NameOfVariable(globals[5]), "axis");
  EXPECT_EQ(NameOfVariable(globals[1]), "data");
}

}  // namespace
}  // namespace oncard::vm
