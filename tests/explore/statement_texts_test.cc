// The statements that instructions belong to (explore/reports/statement_texts.h).
#include "explore/reports/statement_texts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

runtime::LoggedStep StepAt(const vm::Object& object, int function, int position) {
  runtime::LoggedStep step;
  step.function = function;
  step.position = position;
  step.line = object.functions[static_cast<size_t>(function)].lines[static_cast<size_t>(position)];
  return step;
}

/// A program, and the statements of its first function: what is shown for each instruction.
class Statements {
 public:
  explicit Statements(const std::string& source,
                      const compiler::FileReader& reader = compiler::NoFiles())
      : compilation_(compiler::CompileText("p.c", source, {}, reader)) {}

  bool ok() const { return compilation_.ok(); }
  const vm::Object& object() const { return *compilation_.object; }
  size_t count(size_t function = 0) const {
    return object().functions[function].instructions.size();
  }

  /// Without places, as for a program whose object was read from its files.
  std::vector<std::string> Shown(bool placed, int function = 0) const {
    const ProgramText text = TextOf(placed);
    const StatementTexts texts(text, object());
    std::vector<std::string> shown;
    for (size_t i = 0; i < count(static_cast<size_t>(function)); ++i) {
      shown.push_back(texts.Of(StepAt(object(), function, static_cast<int>(i))));
    }
    return shown;
  }

  bool InOne(bool placed, int first, int second) const {
    const ProgramText text = TextOf(placed);
    return StatementTexts(text, object())
        .InOneStatement(StepAt(object(), 0, first), StepAt(object(), 0, second));
  }

 private:
  ProgramText TextOf(bool placed) const {
    ProgramText text = explore::TextOf(compilation_);
    if (!placed) text.places.clear();
    return text;
  }

  compiler::Compilation compilation_;
};

using Texts = std::vector<std::string>;

TEST(StatementTextsTest, OfALineWithSeveralAreShownAlone) {
  const Statements program(
      "int x, y;\nint t0() { int v; x = 1; /* two; */ L: y = 2; // three;\n  x = 3; return "
      "0;\n}\n");
  ASSERT_TRUE(program.ok());
  for (const bool placed : {true, false}) {
    EXPECT_EQ(program.Shown(placed), (Texts{"x = 1;", "y = 2;", "x = 3;", "return 0;"})) << placed;
    EXPECT_FALSE(program.InOne(placed, 0, 1));
  }
}

TEST(StatementTextsTest, OfALineOfItsOwnKeepItsComment) {
  const Statements program("int x;\nint t0() {\n  L: x = 1;  // 一\n  return 0;\n}\n");
  ASSERT_TRUE(program.ok());
  EXPECT_EQ(program.Shown(true), (Texts{"L: x = 1;  // 一", "return 0;"}));
}

TEST(StatementTextsTest, OfTwoFunctionsInALineNeedTheirPlaces) {
  const std::string line = "int t0() { x = 7; return 0; } int t1() { x = 8; return 0; }";
  const Statements program("int x;\n" + line + "\n");
  ASSERT_TRUE(program.ok());
  EXPECT_EQ(program.Shown(true, 1), (Texts{"x = 8;", "return 0;"}));
  // If it is not clear which part is meant, the whole line is shown.
  EXPECT_EQ(program.Shown(false, 1), (Texts{line, line}));
}

// In structured C a statement becomes several instructions.
TEST(StatementTextsTest, OfStructuredCAreThoseOfTheSource) {
  const Statements program(
      "//@ structured\nint n, m;\n"
      "void t0() { n = m * 2 + n * 3; if (m > 1) m = n; for (m = 0; m < 3; m++) n = n + m; }\n");
  ASSERT_TRUE(program.ok());
  const Texts shown = program.Shown(true);
  EXPECT_EQ(shown.front(), "n = m * 2 + n * 3;");
  EXPECT_EQ(std::count(shown.begin(), shown.end(), "n = m * 2 + n * 3;"), 3);
  EXPECT_EQ(std::count(shown.begin(), shown.end(), "if (m > 1) m = n;"), 3);
  EXPECT_NE(std::find(shown.begin(), shown.end(), "for (m = 0; m < 3; m++) n = n + m;"),
            shown.end());
  EXPECT_TRUE(program.InOne(true, 0, 2));
  EXPECT_FALSE(program.InOne(true, 2, 3));
  EXPECT_FALSE(program.InOne(false, 0, 2));
}

TEST(StatementTextsTest, MayHaveSeveralLines) {
  const Statements program(
      "//@ structured\nint n;\nvoid t0() {\n  n = n * 2  // first;\n      + n * 3;\n  n = 1;\n}\n");
  ASSERT_TRUE(program.ok());
  EXPECT_EQ(program.Shown(true).front(), "n = n * 2  // first;");
  EXPECT_TRUE(program.InOne(true, 0, 2));
  EXPECT_FALSE(program.InOne(true, 2, 3));
}

TEST(StatementTextsTest, OfAnIncludedFileAreNotThoseOfTheProgram) {
  const Statements program(
      "//@ structured\n#include \"t0.h\"\nvoid t1() { n = 3; }\n",
      [](const std::string&) -> Result<std::string> {
        return std::string("int n;\nint v;\nvoid t0() { v = n; n = v * 2 + 1; }\n");
      });
  ASSERT_TRUE(program.ok());
  EXPECT_EQ(program.Shown(true).front(), "t0.h:3");
  EXPECT_FALSE(program.InOne(true, 0, 1));
  EXPECT_EQ(program.Shown(true, 1).front(), "n = 3;");
}

TEST(StatementTextsTest, AreUnknownWithoutASource) {
  const Statements program("int x;\nint t0() { x = 1; return 0; }\n");
  const ProgramText none;
  const StatementTexts texts(none, program.object());
  EXPECT_EQ(texts.Of(StepAt(program.object(), 0, 0)), "");
  EXPECT_FALSE(
      texts.InOneStatement(StepAt(program.object(), 0, 0), StepAt(program.object(), 0, 0)));
}

}  // namespace
}  // namespace oncard::explore
