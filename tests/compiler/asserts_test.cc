// Which statement an assert stands before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/lowering/lowering.h"
#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

using testing::ElementsAre;

vm::Assert At(uint16_t position, std::string condition) { return {position, std::move(condition)}; }

vm::Object Compiled(const std::string& source) {
  const Compilation compilation = CompileText("p.c", source, {}, NoFiles());
  EXPECT_TRUE(compilation.ok()) << compilation.diagnostics.front().message.en;
  return compilation.object.value_or(vm::Object());
}

TEST(AssertsTest, BelongToTheNextStatement) {
  const vm::Object object = Compiled(
      "int x;\n"
      "int t0() {\n"
      "  int c;\n"
      "  //@ assert: x < 1\n"
      "  x = 1; x = 2;\n"
      "  // A remark.\n"
      "  //@ assert:x<2\n"
      "\n"
      "  //@assert : c == 0 || x < 3\n"
      "again:\n"
      "  /* another */\n"
      "  c = x > 3;\n"
      "  //@ assert: x < 4\n"
      "  if (c) goto again;\n"
      "  return 0;\n"
      "}\n"
      "int t1() {\n"
      "again:\n"
      "  //@ assert: x < 5\n"
      "  return x;\n"
      "}\n");
  ASSERT_EQ(object.functions.size(), 2u);
  EXPECT_THAT(object.functions[0].asserts,
              ElementsAre(At(0, "x < 1"), At(2, "x<2"), At(2, "c == 0 || x < 3"), At(3, "x < 4")));
  EXPECT_THAT(object.functions[1].asserts, ElementsAre(At(0, "x < 5")));
}

TEST(AssertsTest, DoNotChangeTheProgram) {
  vm::Object with = Compiled("int x;\nint t0() {\n//@ assert: x < 1\nx = 1;\nreturn x;\n}\n");
  const vm::Object without = Compiled("int x;\nint t0() {\n\nx = 1;\nreturn x;\n}\n");
  EXPECT_NE(with, without);
  with.functions[0].asserts.clear();
  EXPECT_EQ(with, without);
}

// --- Structured C ---

/// `m[5] < 3 (m[1][2] < 3; m[5]: m[1][2])`: the conditions of a function, each as it was written,
/// and its names.
std::vector<std::string> AssertsIn(const std::string& body) {
  const vm::Object object =
      Compiled("//@ structured\nint g, h, m[2][3];\nenum { kLow = -1 };\nint t0(int p) {\n" + body +
               "  return p;\n}\n");
  std::vector<std::string> texts;
  if (object.functions.empty()) return texts;
  for (const vm::Assert& assert : object.functions.front().asserts) {
    std::string text = assert.condition + " (" + assert.written;
    for (const auto& [name, written] : assert.names) text += "; " + name + ": " + written;
    texts.push_back(text + ")");
  }
  return texts;
}

struct Named {
  std::string_view name;
  std::string body;
  std::string expected;
};

class StructuredAssertTest : public testing::TestWithParam<Named> {};

TEST_P(StructuredAssertTest, HasTheNamesOfTheLoweredProgram) {
  EXPECT_THAT(AssertsIn(GetParam().body), ElementsAre(GetParam().expected));
}

INSTANTIATE_TEST_SUITE_P(
    Names, StructuredAssertTest,
    testing::ValuesIn(std::vector<Named>{
        {"global", "  //@ assert: g<0x1F\n  g = 1;\n", "g<0x1F (g<0x1F; g: g)"},
        {"hidden", "  int g = p; { int g = 2;\n  //@ assert: g == 2\n  h = 1; }\n",
         "g_3 == 2 (g == 2; g_3: g)"},
        {"constant", "  //@ assert: p > kLow\n  g = 1;\n", "p > (-1) (p > kLow; p: p)"},
        {"element", "  //@ assert: m[1][ 2 ] == 0\n  m[1][2] = 1;\n",
         "m[5] == 0 (m[1][ 2 ] == 0; m[5]: m[1][ 2 ])"},
        {"card", "  //@ assert: axis1.moving == 0\n  g = 1;\n",
         "axis1.moving == 0 (axis1.moving == 0)"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(StructuredAssertsTest, AreNoneInTextThatIsNotRead) {
  EXPECT_THAT(AssertsIn("#if 0\n  //@ assert: g == 1\n  g = 2;\n#else\n"
                        "  //@ assert: g == 3\n  g = 4;\n#endif\n"),
              ElementsAre("g == 3 (g == 3; g: g)"));
}

// A function as text of the card, without its remarks. An assert is the reason of no warning.
std::string LoweredText(const std::string& body) {
  const Lowering lowering =
      LowerText("p.c", "int g;\nvoid t0(int p) {\n" + body + "}\n", {}, {}, NoFiles());
  EXPECT_TRUE(lowering.diagnostics.empty()) << lowering.diagnostics.front().message.en;
  const std::string text = lowering.text.value_or("none");
  std::string kept;
  for (size_t begin = text.find("{\n") + 2; begin < text.size();) {
    const size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.find("  // ") == std::string::npos && line != "}" && !line.empty())
      kept += line + "\n";
  }
  return kept;
}

TEST(StructuredAssertsTest, KeepWhatTheyName) {
  EXPECT_EQ(LoweredText("  int kept = 7;\n  //@ assert: kept == 7\n  g = kept;\n"),
            "  int kept;\n  kept = 7;\n  //@ assert: kept == 7\n  g = 7;\n");
}

TEST(StructuredAssertsTest, AreCheckedAtEachTestOfALoop) {
  EXPECT_EQ(LoweredText("  //@ assert: p < 5\n  for (p = 0; p < 3; ++p) g = p;\n"),
            "  int tmp1;\n  p = 0;\nlbl_for_4:\n  //@ assert: p < 5\n  tmp1 = p >= 3;\n"
            "  if (tmp1) goto lbl_for_4_end;\n  g = p;\n  p = p + 1;\n  goto lbl_for_4;\n"
            "lbl_for_4_end:\n  return;\n");
}

// Who does not enter the branch does not pass the assert.
TEST(StructuredAssertsTest, HaveAStatementOfTheirOwnBeforeALabel) {
  EXPECT_EQ(LoweredText("  if (p) {\n    //@ assert: g == 1\n    ;\n  }\n  g = 2;\n"),
            "  int tmp1;\n  tmp1 = !p;\n  if (tmp1) goto lbl_if_3_end;\n  //@ assert: g == 1\n"
            "  goto lbl_if_3_end;\nlbl_if_3_end:\n  g = 2;\n");
  EXPECT_EQ(LoweredText("  while (p) {\n    //@ assert: g == 1\n    break;\n  }\n  g = 2;\n"),
            "  int tmp1;\n  tmp1 = !p;\n  if (tmp1) goto lbl_while_3_end;\n"
            "  //@ assert: g == 1\n  goto lbl_while_3_end;\nlbl_while_3_end:\n  g = 2;\n");
}

}  // namespace
}  // namespace oncard::compiler
