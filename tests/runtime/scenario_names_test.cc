#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

// --- Quantities ----------------------------------------------------------------------------------

constexpr const char* kNamesProgram =
    "int sum;\nint a[3];\ndouble x;\nTTrapPrm trap;\nint gpo;\n"
    "int f(int n)\n{\n  int b[2];\n  b[1] = n;\n  return n;\n}\n"
    "int g(int m)\n{\n  return m;\n}\n";

class QuantityTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(controller_.Load(CompileForTest(kNamesProgram)).ok());
    ASSERT_EQ(controller_.machine().Bind(0, 1, 4), 0);
  }
  std::vector<std::string> Names(const std::string& name) {
    std::vector<std::string> names;
    const auto found = ResolveQuantity(name, controller_);
    if (!found.ok()) return {"error: " + found.error().message.en};
    for (const Quantity& quantity : found.value()) names.push_back(quantity.name);
    return names;
  }
  Controller controller_;
  using Texts = std::vector<std::string>;
};

TEST_F(QuantityTest, NamesVariables) {
  EXPECT_EQ(Names("sum"), Texts{"sum"});
  EXPECT_EQ(Names("a[2]"), Texts{"a[2]"});
  EXPECT_EQ(Names("trap.acc"), Texts{"trap.acc"});
  EXPECT_EQ(Names("page4.n"), Texts{"page4.n"});
  EXPECT_EQ(Names("page4.b[1]"), Texts{"page4.b[1]"});
}

TEST_F(QuantityTest, NamesAllElementsOfAnArray) {
  EXPECT_EQ(Names("a"), (Texts{"a[0]", "a[1]", "a[2]"}));
  EXPECT_EQ(Names("page4.b"), (Texts{"page4.b[0]", "page4.b[1]"}));
}

TEST_F(QuantityTest, ReadsAPageWithoutAThreadAsTheOnlyFunctionThatHasTheName) {
  EXPECT_EQ(Names("page9.n"), Texts{"page9.n"});
  EXPECT_EQ(Names("page9.m")[0],
            "error: no thread is bound to page 9, so 'm' has no meaning there");
}

TEST_F(QuantityTest, LetsAGlobalHideAWord) {
  const auto found = ResolveQuantity("gpo", controller_);
  EXPECT_EQ(found.value().front().kind, QuantityKind::kVariable);
}

TEST_F(QuantityTest, NamesThreadsWordsAndTime) {
  for (const char* name :
       {"thread0.result", "thread31.run", "thread0.error", "thread0.line", "thread0.page",
        "thread0.statements", "gpi", "gpi[16]", "enable[1]", "clock", "statements"}) {
    EXPECT_EQ(Names(name), Texts{name});
  }
}

struct UnknownCase {
  const char* name;
  const char* says;
};

TEST_F(QuantityTest, SaysWhatIsWrongWithAName) {
  for (const UnknownCase& c : {
           UnknownCase{"summ", "nothing is named 'summ'; did you mean 'sum'?"},
           UnknownCase{"a[3]", "'a' has elements 0 to 2, not 3"},
           UnknownCase{"sum[0]", "'sum' is not an array"},
           UnknownCase{"a[i]", "'a[i]' is not a name; an index is a number, as in 'a[3]'"},
           UnknownCase{"thread0.resutl", "nothing is named 'resutl'; did you mean 'result'?"},
           UnknownCase{"thread32.run", "'thread32.run': threads are numbered 0 to 31"},
           UnknownCase{"page32.n", "'page32': pages are numbered 0 to 31"},
           UnknownCase{"gpi[0]", "bits of 'gpi' are numbered 1 to 16"},
           UnknownCase{"gpi[17]", "bits of 'gpi' are numbered 1 to 16"},
           UnknownCase{"nonsense", "nothing is named 'nonsense'"},
           UnknownCase{"nonsense1", "nothing is named 'nonsense1'"},
           UnknownCase{"axis1.prfPso",
                       "nothing is named 'axis1.prfPso'; did you mean "
                       "'axis1.prfPos'?"},
           UnknownCase{"axs1.prfPos",
                       "nothing is named 'axs1.prfPos'; did you mean "
                       "'axis1.prfPos'?"},
           UnknownCase{"axis0.prfPos", "'axis0.prfPos': this card has axis1 to axis8"},
           UnknownCase{"encoder12.pos", "'encoder12.pos': this card has encoder1 to encoder11"},
           UnknownCase{"profile1", "'profile1' has the values pos, vel, acc, mode"},
       }) {
    EXPECT_EQ(Names(c.name)[0], std::string("error: ") + c.says);
  }
}

TEST_F(QuantityTest, ReadsValues) {
  controller_.machine().Write({true, 0, 0, vm::DataType::kInt}, -7);
  EXPECT_EQ(ReadQuantity(ResolveQuantity("sum", controller_).value()[0], controller_), -7);
  controller_.motion().digital_io().Write(motion::DoType::kEnable, 0x3, 0x2);
  EXPECT_EQ(ReadQuantity(ResolveQuantity("enable", controller_).value()[0], controller_), 2);
  EXPECT_EQ(ReadQuantity(ResolveQuantity("enable[2]", controller_).value()[0], controller_), 1);
  EXPECT_EQ(ReadQuantity(ResolveQuantity("enable[1]", controller_).value()[0], controller_), 0);
  for (int i = 0; i < 8; ++i) controller_.RunCycle();
  EXPECT_EQ(ReadQuantity(ResolveQuantity("clock", controller_).value()[0], controller_), 2);
}

// --- Names of structured C -----------------------------------------------------------------------

class StructuredQuantityTest : public QuantityTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(controller_
                    .Load(CompileForTest(
                        "//@ structured\n"
                        "struct point { int x; int y; };\n"
                        "struct axis { int target; struct point at[2]; } axis1[2];\n"
                        "int m[2][3], v;\n"
                        "void t0(int n) {\n  struct point axis1 = {n + 1, n * 2};\n"
                        "  while (axis1.x < 9) axis1.x += axis1.y++;\n  v = axis1.x;\n}\n"))
                    .ok());
    ASSERT_EQ(controller_.machine().Bind(0, 1, 4), 0);
  }
};

TEST_F(StructuredQuantityTest, NamesMembersAndElements) {
  EXPECT_EQ(Names("axis1[1].at[0].y"), Texts{"axis1[1].at[0].y"});
  EXPECT_EQ(Names("m[1][2]"), Texts{"m[1][2]"});
  EXPECT_EQ(Names("page4.axis1.y"), Texts{"page4.axis1.y"});
  EXPECT_EQ(Names("axis1[1]"), (Texts{"axis1[1].target", "axis1[1].at[0].x", "axis1[1].at[0].y",
                                      "axis1[1].at[1].x", "axis1[1].at[1].y"}));
}

// The names of the lowered program are known, too, and are meant first.
TEST_F(StructuredQuantityTest, NamesVariablesOfTheCardAsCDoes) {
  EXPECT_EQ(Names("axis1_target[1]"), Texts{"axis1[1].target"});
  EXPECT_EQ(Names("axis1_at_y[3]"), Texts{"axis1[1].at[1].y"});
  EXPECT_EQ(Names("m[1]"), Texts{"m[0][1]"});
  EXPECT_EQ(Names("m[5]"), Texts{"m[1][2]"});
}

TEST_F(StructuredQuantityTest, AStructureHidesWhatBeginsWithItsName) {
  EXPECT_EQ(Names("axis1[0].prfPos"), Texts{"error: 'axis1[0]' has no member 'prfPos': it has "
                                            "target, at"});
  EXPECT_EQ(Names("axis2.prfPos"), Texts{"axis2.prfPos"});
}

TEST_F(StructuredQuantityTest, SaysWhatIsWrongWithAName) {
  EXPECT_EQ(Names("axis1[1].targt")[0],
            "error: 'axis1[1]' has no member 'targt'; did you mean 'target'?");
  EXPECT_EQ(Names("axis1[2].target")[0], "error: 'axis1' has elements 0 to 1, not 2");
  EXPECT_EQ(Names("m[0][3]")[0], "error: 'm' has elements 0 to 2, not 3");
  EXPECT_EQ(Names("axs1[1].target")[0],
            "error: nothing is named 'axs1[1].target'; did you mean 'axis1[1].target'?");
}

TEST_F(StructuredQuantityTest, ALocalHidesAGlobalInItsThread) {
  EXPECT_EQ(NameInThread("axis1.x", 0, controller_), "page4.axis1.x");
  EXPECT_EQ(NameInThread("axis1[1].target", 0, controller_), "page4.axis1[1].target");
  EXPECT_EQ(NameInThread("m[1][2]", 0, controller_), "m[1][2]");
}

TEST_F(StructuredQuantityTest, AllGlobalsInTheOrderOfC) {
  Texts names;
  for (const Quantity& quantity : GlobalQuantities(controller_)) names.push_back(quantity.name);
  ASSERT_EQ(names.size(), 17u);
  EXPECT_EQ(names[4], "axis1[0].at[1].y");
  EXPECT_EQ(names[5], "axis1[1].target");
  EXPECT_EQ(names[15], "m[1][2]");
}

// Each array, and each number of a structure, has a line.
TEST(ShownValues, AreCalledAsInC) {
  RunOptions options;
  options.show = {"p", "p[1].y", "p_x", "m"};
  const ScenarioResult result = RunForTest(
      "//@ structured\nstruct { int x; int y[2]; } p[2];\nint m[2][2];\n"
      "void t0() { m[1][0] = 3; p[1].y[1] = 4; p[1].x = 5; }\n",
      "globals = { \"p[0].x\" = 7, p_y = [1, 2] }\n"
      "final = [\"p[1].y[1] == 4\", \"m[1][0] == 3\"]\nnever = [\"p[1].x == 6\"]\n",
      options);
  EXPECT_TRUE(result.failures.empty());
  std::vector<std::string> lines;
  for (const ShownValue& value : result.values) {
    std::string line = value.name + (value.array ? " []" : "");
    for (const std::string& element : value.elements) line += " " + element;
    lines.push_back(line);
  }
  EXPECT_EQ(lines,
            (std::vector<std::string>{"p[0].x 7", "p[0].y [] 1 2", "p[1].x 5", "p[1].y [] 0 4",
                                      "p[1].y [] 0 4", "p[0].x 7", "p[1].x 5", "m [] 0 0 3 0"}));
}

TEST(FormatNumber, GivesTheExactValue) {
  EXPECT_EQ(FormatNumber(5050, NumberForm::kWhole), "5050");
  EXPECT_EQ(FormatNumber(-1, NumberForm::kWhole), "-1");
  EXPECT_EQ(FormatNumber(3, NumberForm::kFixedPoint), "3.0");
  EXPECT_EQ(FormatNumber(12.5, NumberForm::kFixedPoint), "12.5");
  EXPECT_EQ(FormatNumber(1.0 / 65536, NumberForm::kFixedPoint), "0.0000152587890625");
  EXPECT_EQ(FormatNumber(1, NumberForm::kFlag), "1");
  EXPECT_EQ(FormatNumber(50000, NumberForm::kReal), "50000.0");
  EXPECT_EQ(FormatNumber(-0.1, NumberForm::kReal), "-0.1");
  EXPECT_EQ(FormatNumber(1e-9, NumberForm::kReal), "1e-09");
}

TEST(AppendNumber, LooksOnlyAtTheNumber) {
  std::string text = "1.e";
  AppendNumber(3, NumberForm::kReal, &text);
  text += ".0";
  AppendNumber(0, NumberForm::kFixedPoint, &text);
  text += "00";
  AppendNumber(0, NumberForm::kWhole, &text);
  EXPECT_EQ(text, "1.e3.0.00.0000");
}

}  // namespace
}  // namespace oncard::runtime
