#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "compiler/diagnostic_printer.h"
#include "tests/compiler/printer_support.h"

namespace oncard::compiler {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string Print(const Compilation& compilation, Language language = Language::kEnglish) {
  return PrintText(compilation, {.language = language, .color = false});
}

TEST(PrintText, SaysNothingWithoutDiagnostics) { EXPECT_EQ(Print(CompilationOf("int a;\n")), ""); }

TEST(PrintText, PutsCaretAndTildesUnderTheRange) {
  Compilation compilation = CompilationOf("int f()\n{\n  return foo;\n}\n");
  Report(compilation, kUndeclared, "foo", {"'foo' is not declared", "未声明“foo”"});
  EXPECT_EQ(Print(compilation),
            "p.c:3:10: error MP027: 'foo' is not declared [undeclared]\n"
            "    3 |   return foo;\n"
            "      |          ^~~\n"
            "1 error\n");
}

TEST(PrintText, SpeaksChinese) {
  Compilation compilation = CompilationOf("x\n");
  Report(compilation, kUndeclared, "x", {"'x' is not declared", "未声明“x”"});
  Report(compilation, kTruncated, "x", {"cut", "被截断"});
  EXPECT_EQ(Print(compilation, Language::kChinese),
            "p.c:1:1: 错误 MP027: 未声明“x” [undeclared]\n"
            "    1 | x\n"
            "      | ^\n"
            "p.c:1:1: 警告 MP101: 被截断 [truncated]\n"
            "    1 | x\n"
            "      | ^\n"
            "1 个错误，1 个警告\n");
}

TEST(PrintText, AlignsCaretsBehindTabsAndWideCharacters) {
  Compilation compilation = CompilationOf("\t/* 轴 */ foo = 1;\n");
  Report(compilation, kUndeclared, "foo", {"m", "m"});
  EXPECT_EQ(Print(compilation),
            "p.c:1:10: error MP027: m [undeclared]\n"
            "    1 |         /* 轴 */ foo = 1;\n"
            "      |                  ^~~\n"
            "1 error\n");
}

struct LongLine {
  const char* name;
  std::string before;  // what stands before the place, and behind it
  std::string after;
};

void PrintTo(const LongLine& row, std::ostream* out) { *out << row.name; }

std::string Times(int count, const std::string& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

class LongLineTest : public testing::TestWithParam<LongLine> {};

// The caret is under the place, whose column on the terminal is the number of columns before it:
// two for each character of the Chinese text, one for each other one.
TEST_P(LongLineTest, IsShownAroundThePlace) {
  const LongLine& row = GetParam();
  Compilation compilation = CompilationOf(row.before + "foo" + row.after + "\n");
  Report(compilation, kUndeclared, "foo", {"m", "m"});
  std::istringstream printed(Print(compilation));
  std::string headline;
  std::string line;
  std::string carets;
  std::getline(printed, headline);
  std::getline(printed, line);
  std::getline(printed, carets);
  const std::string gutter = "    1 | ";
  ASSERT_THAT(line, StartsWith(gutter));
  ASSERT_THAT(carets, StartsWith("      | "));
  ASSERT_THAT(carets, EndsWith("^~~"));
  const size_t place = line.find("foo");
  ASSERT_NE(place, std::string::npos);
  const auto columns = [](std::string_view text) {
    size_t count = 0;
    for (size_t i = 0; i < text.size(); ++count) {
      const bool wide = (text[i] & 0xF0) == 0xE0;  // a character of three bytes
      if (wide) ++count;
      i += wide ? 3 : 1;
    }
    return count;
  };
  EXPECT_EQ(carets.find('^'), columns(line.substr(0, place)));
  EXPECT_LE(columns(line), gutter.size() + 120);
  EXPECT_GE(columns(line), gutter.size() + 110);  // the room is used
  EXPECT_EQ(line.substr(gutter.size(), 3) == "...", row.before.size() > 120);
  EXPECT_EQ(line.ends_with("..."), row.after.size() > 120);
}

INSTANTIATE_TEST_SUITE_P(PrintText, LongLineTest,
                         testing::Values(LongLine{"begin", "", Times(12'000, "x")},
                                         LongLine{"near_begin", "ab ", Times(12'000, " x")},
                                         LongLine{"middle", Times(6'000, "x "), Times(6'000, " x")},
                                         LongLine{"end", Times(12'000, "x "), ""},
                                         LongLine{"wide", Times(500, "轴") + ' ', Times(500, "轴")},
                                         LongLine{"wide_odd", 'x' + Times(500, "轴") + ' ',
                                                  ' ' + Times(500, "轴")},
                                         LongLine{"wide_end", Times(500, "轴") + " x ", ""},
                                         LongLine{"tabs", Times(100, "x\t"), Times(100, "\tx")}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(PrintText, CutsWhatIsMarkedToTheExcerpt) {
  Compilation compilation = CompilationOf(Times(200, "a") + '"' + Times(12'000, "x") + "\"\n");
  Report(compilation, kUndeclared, '"' + Times(12'000, "x") + '"', {"m", "m"});
  EXPECT_EQ(Print(compilation),
            "p.c:1:201: error MP027: m [undeclared]\n"
            "    1 | ...\"" +
                Times(113, "x") +
                "...\n"
                "      |    ^" +
                Times(113, "~") +
                "\n"
                "1 error\n");
}

TEST(PrintText, ShowsLongLinesOfFixItsAroundTheEdit) {
  Compilation compilation = CompilationOf(Times(6'000, "a ") + "foo" + Times(6'000, " b") + "\n");
  Diagnostic& diagnostic = Report(compilation, kUndeclared, "foo", {"m", "m"});
  diagnostic.fixits.push_back({diagnostic.range, "FOO"});
  std::istringstream printed(Print(compilation));
  std::string line;
  for (int i = 0; i < 4; ++i) std::getline(printed, line);
  EXPECT_THAT(line, StartsWith("    1 + ..."));
  EXPECT_THAT(line, HasSubstr(" a FOO b "));
  EXPECT_THAT(line, EndsWith("..."));
  EXPECT_EQ(line.size(), std::string("    1 + ").size() + 120);
}

TEST(PrintText, ConvertsGbkComments) {
  Compilation compilation = CompilationOf("/* \xD6\xE1 */ foo = 1;\n");
  Report(compilation, kUndeclared, "foo", {"m", "m"});
  EXPECT_EQ(Print(compilation),
            "p.c:1:9: error MP027: m [undeclared]\n"
            "    1 | /* 轴 */ foo = 1;\n"
            "      |          ^~~\n"
            "1 error\n");
}

TEST(PrintText, UnderlinesTheFirstLineOfALongRange) {
  Compilation compilation = CompilationOf("a = b\n  + c;\n");
  Report(compilation, kUndeclared, "b\n  + c", {"m", "m"});
  EXPECT_EQ(Print(compilation),
            "p.c:1:5: error MP027: m [undeclared]\n"
            "    1 | a = b\n"
            "      |     ^\n"
            "1 error\n");
}

TEST(PrintText, PointsPastTheEndOfTheFile) {
  Compilation compilation = CompilationOf("int f()\n{");
  Diagnostic& diagnostic = Report(compilation, kUndeclared, "{", {"m", "m"});
  diagnostic.range = {0, 9, 9};
  EXPECT_EQ(Print(compilation),
            "p.c:2:2: error MP027: m [undeclared]\n"
            "    2 | {\n"
            "      |  ^\n"
            "1 error\n");
}

TEST(PrintText, LeavesOutThePlaceOfAFileThatWasNeverRead) {
  Compilation compilation;
  Diagnostic diagnostic;
  diagnostic.info = &kUndeclared;
  diagnostic.message = {"cannot open 'x.c'", "无法打开“x.c”"};
  compilation.diagnostics.push_back(diagnostic);
  EXPECT_EQ(Print(compilation), "error MP027: cannot open 'x.c' [undeclared]\n1 error\n");
}

TEST(PrintText, PrintsNotesAtTheirPlacesOrWithout) {
  Compilation compilation = CompilationOf("int sum;\nint sun;\n");
  Diagnostic& diagnostic = Report(compilation, kUndeclared, "sun", {"m", "m"});
  diagnostic.notes.push_back({RangeOf(compilation, "sum"), true, {"declared here", "声明于此"}});
  diagnostic.notes.push_back({{}, false, {"one hint", "提示"}});
  EXPECT_EQ(Print(compilation),
            "p.c:2:5: error MP027: m [undeclared]\n"
            "    2 | int sun;\n"
            "      |     ^~~\n"
            "p.c:1:5: note: declared here\n"
            "    1 | int sum;\n"
            "      |     ^~~\n"
            "note: one hint\n"
            "1 error\n");
}

TEST(PrintText, ShowsTheLinesThatAFixitLeaves) {
  Compilation compilation = CompilationOf("x\n  a = b + c * d;\ny\n");
  Diagnostic& diagnostic = Report(compilation, kUndeclared, "b + c * d", {"m", "m"});
  diagnostic.fixits.push_back({RangeOf(compilation, "a = b + c * d;"), "t = c * d;\n  a = b + t;"});
  EXPECT_EQ(Print(compilation),
            "p.c:2:7: error MP027: m [undeclared]\n"
            "    2 |   a = b + c * d;\n"
            "      |       ^~~~~~~~~\n"
            "    2 +   t = c * d;\n"
            "      +   a = b + t;\n"
            "1 error\n");
}

TEST(PrintText, GroupsFixitsOfTouchingLinesAndSeparatesDistantOnes) {
  Compilation compilation = CompilationOf("int a;\n\n\nx = 1;\ny = 2;\n");
  Diagnostic& diagnostic = Report(compilation, kUndeclared, "x", {"m", "m"});
  diagnostic.fixits.push_back({RangeOf(compilation, "y"), "y2"});
  diagnostic.fixits.push_back({RangeOf(compilation, "x"), "x2"});
  const SourceRange a = RangeOf(compilation, "a;");
  diagnostic.fixits.push_back({{0, a.end, a.end}, "\nint x2;"});
  EXPECT_EQ(Print(compilation),
            "p.c:4:1: error MP027: m [undeclared]\n"
            "    4 | x = 1;\n"
            "      | ^\n"
            "    1 + int a;\n"
            "      + int x2;\n"
            "    4 + x2 = 1;\n"
            "      + y2 = 2;\n"
            "1 error\n");
}

TEST(PrintText, CountsErrorsAndWarningsAtTheEnd) {
  Compilation compilation = CompilationOf("x\n");
  for (int i = 0; i < 2; ++i) Report(compilation, kUndeclared, "x", {"m", "m"});
  for (int i = 0; i < 3; ++i) Report(compilation, kTruncated, "x", {"m", "m"});
  EXPECT_THAT(Print(compilation), EndsWith("2 errors and 3 warnings\n"));
}

TEST(PrintText, ColoursOnRequestOnly) {
  Compilation compilation = CompilationOf("x\n");
  Report(compilation, kUndeclared, "x", {"m", "m"});
  EXPECT_EQ(PrintText(compilation, {.language = Language::kEnglish, .color = true}),
            "\x1b[1mp.c:1:1:\x1b[0m \x1b[1;31merror MP027:\x1b[0m \x1b[1mm [undeclared]\x1b[0m\n"
            "    1 | x\n"
            "      | \x1b[1;32m^\x1b[0m\n"
            "1 error\n");
}

}  // namespace
}  // namespace oncard::compiler
