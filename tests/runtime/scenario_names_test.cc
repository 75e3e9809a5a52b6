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
