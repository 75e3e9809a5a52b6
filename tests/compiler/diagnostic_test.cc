// The table of diagnostics, columns, recovery, and a check that every code has a test.
#include "compiler/diagnostic.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "tests/compiler/compiler_support.h"

namespace oncard::compiler {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

using Codes = std::vector<int>;

TEST(DiagnosticTable, IsSortedAndComplete) {
  int previous = -1;
  for (const DiagnosticInfo& info : DiagnosticTable()) {
    EXPECT_GT(info.code, previous);
    EXPECT_FALSE(info.slug.empty());
    EXPECT_FALSE(info.en.empty());
    EXPECT_FALSE(info.zh.empty());
    EXPECT_THAT(info.en, Not(EndsWith(".")));
    EXPECT_EQ(FindDiagnostic(info.code), &info);
    previous = info.code;
  }
  for (int code = 0; code <= 50; ++code) EXPECT_NE(FindDiagnostic(code), nullptr) << code;
  EXPECT_EQ(FindDiagnostic(99), nullptr);
  EXPECT_EQ(DiagnosticName(7), "MP007");
}

// MP000 only exists in the vendor's numbering.
TEST(DiagnosticTable, HasATestForEveryCode) {
  std::string tests;
  for (const char* folder : {"/tests/lang", "/tests/compiler"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(ONCARD_SOURCE_DIR) + folder)) {
      const std::string name = entry.path().filename().string();
      if (!entry.is_regular_file() || name.starts_with("printer_") ||
          name.starts_with("explain_")) {
        continue;
      }
      tests += ReadFile(entry.path().string()).value();
    }
  }
  for (const DiagnosticInfo& info : DiagnosticTable()) {
    if (info.code == 0) continue;
    const std::string by_name =
        "expect " + std::string(info.severity == Severity::kError ? "error " : "warning ") +
        DiagnosticName(info.code);
    const std::string by_code = "Codes{" + std::to_string(info.code) + "}";
    EXPECT_TRUE(tests.find(by_name) != std::string::npos ||
                tests.find(by_code) != std::string::npos)
        << DiagnosticName(info.code);
  }
}

TEST(SourceFile, FindsLinesWithEitherLineEnd) {
  const SourceFile file("f.c", "one\r\ntwo\n\nfour");
  EXPECT_EQ(file.line_count(), 4);
  EXPECT_EQ(file.Line(1), "one");
  EXPECT_EQ(file.Line(2), "two");
  EXPECT_EQ(file.Line(3), "");
  EXPECT_EQ(file.Line(4), "four");
  EXPECT_EQ(file.Line(5), "");
  EXPECT_EQ(file.LineOf(0), 1);
  EXPECT_EQ(file.LineOf(5), 2);
  EXPECT_EQ(file.LineOf(9), 3);
  EXPECT_EQ(SourceFile("f.c", "one\n").line_count(), 1);
  EXPECT_EQ(SourceFile("f.c", "").line_count(), 1);
}

TEST(SourceFile, CountsCharactersNotBytes) {
  const std::string utf8 = "/* \xE5\x8F\x98\xE9\x87\x8F */ x";
  EXPECT_EQ(SourceFile("f.c", utf8).ColumnOf(static_cast<uint32_t>(utf8.find('x'))), 10);
  const std::string gbk = "/* \xB1\xE4\xC1\xBF */ x";
  EXPECT_EQ(SourceFile("f.c", gbk).ColumnOf(static_cast<uint32_t>(gbk.find('x'))), 10);
  const SourceFile lines("f.c", utf8 + "\r\n" + utf8 + "\n" + gbk);
  const auto second = static_cast<uint32_t>(utf8.size() + 2);
  EXPECT_EQ(lines.ColumnOf(second + 3), 4);   // the first character
  EXPECT_EQ(lines.ColumnOf(second + 4), 4);   // within it
  EXPECT_EQ(lines.ColumnOf(second + 6), 5);   // the second one
  EXPECT_EQ(lines.ColumnOf(second - 1), 12);  // the line end
  EXPECT_EQ(lines.ColumnOf(second + 14 + 1 + 8), 7);
}

TEST(SourceFile, SkipsAByteOrderMark) {
  const SourceFile file("f.c", "\xEF\xBB\xBFint v;");
  EXPECT_EQ(file.text(), "int v;");
  EXPECT_EQ(file.ColumnOf(4), 5);
}

// The range of a diagnostic is a token, not a line.
TEST(Diagnostics, PointAtTheToken) {
  const Compilation compilation = CompileString("int t0() {\n  return misspelt + 1;\n}\n");
  ASSERT_EQ(CodesOf(compilation).front(), 27);
  const Diagnostic& diagnostic = compilation.diagnostics.front();
  const SourceFile& file = compilation.files[0];
  EXPECT_EQ(file.LineOf(diagnostic.range.begin), 2);
  EXPECT_EQ(file.ColumnOf(diagnostic.range.begin), 10);
  EXPECT_EQ(diagnostic.range.end - diagnostic.range.begin, 8u);
}

TEST(Diagnostics, ComeInSourceOrder) {
  const Compilation compilation =
      CompileString("#include \"first.h\"\nint a = @;\nint t0() {\n  u = 1;\n  a = 1 2;\n}\n", {},
                    {{"first.h", "int b = 1;\nint c[0];\n"}});
  const Codes wanted = {110, 16, 1, 27, 41};
  EXPECT_EQ(CodesOf(compilation), wanted);
  EXPECT_EQ(compilation.diagnostics[0].range.file, 1);
  EXPECT_EQ(compilation.diagnostics[2].range.file, 0);
}

TEST(Diagnostics, DoNotCascade) {
  struct Case {
    const char* text;
    Codes codes;
  };
  const Case cases[] = {
      // Reported once per name and function.
      {"int t0() { x = 1; x = x + 1; goto l; goto l; return x; }", {27, 20}},
      // A declaration with an error still declares its name.
      {"unsigned x; int t0() { x = 1; return x; }", {114}},
      {"int x[0]; int t0() { x[1] = 2; return 0; }", {16}},
      {"wrong x; int t0() { x = 1; return x; }", {5}},
      {"int x y, z; int t0() { z = 1; y = 1; return x; }", {41}},
      // After an error in a function's header its body is not checked, but what follows it is.
      {"int f(int 5) { a = 1; while (1) { b = 2; } } int t0() { u = 1; }", {128, 27}},
      {"int t0() { for (i = 0 i < 3; i++) { a = 1; } u = 1; }", {41, 27}},
      {"int t0() { while x { a = 1; } u = 1; }", {38, 27}},
      {"int t0() { int a[2] = {1, ) 2}; u = 1; }", {127, 27}},
      {"struct S { int a; int b; }; int t0() { u = 1; }", {115, 27}},
      {"int v; int t0() { v = 1 @ 2; v = 3; }", {1}},
      {"int v; int t0() { v = 08; v = v + 09; }", {118, 118}},
      {"int v; int t0() { v = 1;\nint t1() { v = 2; }\n", {12}},
      {"#define N 99999999999\nint a[N]; int t0() { a[1] = N; return N; }", {26}},
      {"int v; int t0() { v = GT_Nope(u); }", {33, 27}},
      // An invalid number is one error, wherever it is.
      {"int 5z;", {3}},
      {"int 5z = 3, y; int t0() { y = 1; return 5z; }", {3, 3}},
      {"double d[3], 5z[2]; int t0() { d[0] = 1; }", {3}},
      {"int a[5z]; int t0() { a[1] = 2; }", {3}},
      {"int t0(int 5z) { return 0; }", {3}},
      {"int 5z() { return 0; }", {3}},
      {"#define 5z 3\nint t0() { return 0; }", {3}},
      {"int t0() { 5z = 3; }", {3}},
      {"int t0() { 5z(); }", {3}},
      {"int t0() { 5z: return 0; }", {3}},
      {"int t0() { goto 5z; }", {3}},
      {"int v; int t0() { v = 5z 3; v = 08 v; }", {3, 118}},
  };
  for (const Case& test : cases) {
    EXPECT_EQ(CodesOf(CompileString(test.text)), test.codes) << test.text;
  }
}

TEST(Diagnostics, OfUnreadableFiles) {
  const Compilation compilation = Compile("nowhere/at/all.c");
  EXPECT_EQ(CodesOf(compilation), Codes{22});
  EXPECT_FALSE(compilation.ok());
  EXPECT_EQ(compilation.files[0].path(), "nowhere/at/all.c");
}

// Warnings that are errors are no sign of another language.
TEST(Diagnostics, DoNotTakeAProgramWithWarningsForStructuredC) {
  Options options;
  options.warnings_are_errors = true;
  const Compilation compilation = CompileString(
      "int t0() {\n  int a, b, c, d, e, f;\n  a = 1;\n  b = 1;\n  c = 1;\n  d = 1;\n  e = 1;\n"
      "  f = 1;\n  return 0;\n}\n",
      options);
  EXPECT_EQ(CodesOf(compilation), Codes(6, 137));
}

TEST(Diagnostics, RecognizeStructuredCWhateverTheLimitOfErrors) {
  const std::string text =
      "int v;\nint t0() {\n  v++;\n  v++;\n  v++;\n  v++;\n  v++;\n  v++;\n  return v;\n}\n";
  for (const int limit : {0, 1, 5, 6}) {
    Options options;
    options.max_errors = limit;
    EXPECT_EQ(CodesOf(CompileString(text, options)), Codes{140}) << limit;
  }
}

// A message names what it is about also if that has the length of a file.
TEST(Diagnostics, QuoteTheBeginAndTheEndOfWhatIsLong) {
  const std::string name = "begin" + std::string(12'000, 'x') + "end";
  const Compilation compilation = CompileString("int t0() {\n  return " + name + ";\n}\n");
  ASSERT_EQ(CodesOf(compilation), (Codes{2, 27}));
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    EXPECT_THAT(diagnostic.message.en, HasSubstr("'beginxxx"));
    EXPECT_THAT(diagnostic.message.en, HasSubstr("xxx...xxx"));
    EXPECT_THAT(diagnostic.message.zh, HasSubstr("xxxend'"));
    EXPECT_LT(diagnostic.message.en.size(), 600u);
  }
}

TEST(Diagnostics, SuggestTheNearestName) {
  const Compilation compilation = CompileString("int position;\nint t0() {\n  positon = 1;\n}\n");
  ASSERT_EQ(CodesOf(compilation), Codes{27});
  ASSERT_EQ(compilation.diagnostics[0].notes.size(), 1u);
  EXPECT_EQ(compilation.diagnostics[0].notes[0].message.en, "did you mean 'position'?");
  ASSERT_EQ(compilation.diagnostics[0].fixits.size(), 1u);
  EXPECT_EQ(compilation.diagnostics[0].fixits[0].text, "position");
}

TEST(Diagnostics, ShowThePreviousDefinition) {
  const Compilation compilation = CompileString("int a;\nint a;\n");
  ASSERT_EQ(CodesOf(compilation), Codes{13});
  ASSERT_EQ(compilation.diagnostics[0].notes.size(), 1u);
  EXPECT_EQ(compilation.files[0].LineOf(compilation.diagnostics[0].notes[0].range.begin), 1);
}

TEST(Diagnostics, GiveTheDefineLineOfAConstant) {
  const Compilation compilation = CompileString("int t0() {\n  GT_SetDo(MC_GPO, 1);\n}\n");
  ASSERT_EQ(CodesOf(compilation), Codes{27});
  ASSERT_EQ(compilation.diagnostics[0].fixits.size(), 1u);
  EXPECT_EQ(compilation.diagnostics[0].fixits[0].text, "#define MC_GPO 12\n");
}

TEST(Diagnostics, TellApartWhatCannotBeCalled) {
  const Compilation compilation = CompileString(
      "int f() { return 0; }\nint t0() {\n  f();\n  GT_Open(0, 1);\n  GT_Nothing();\n}\n");
  const Codes wanted = {113, 33, 33};
  ASSERT_EQ(CodesOf(compilation), wanted);
  EXPECT_THAT(compilation.diagnostics[1].notes[0].message.en, HasSubstr("only the host"));
  EXPECT_THAT(compilation.diagnostics[2].notes[0].message.en, HasSubstr("no GT command"));
}

// The values that a command writes through an address cannot be converted.
TEST(Diagnostics, SayWhatToDoAboutAnAddressOfAnotherType) {
  struct Case {
    const char* call;
    const char* advice;
  };
  const Case cases[] = {
      {"GT_GetPrfPos(1, &i, 1, &i)",
       "declare 'i' as a double, or pass another variable that is a double"},
      {"GT_GetSts(1, &d, 1, &i)", "declare 'd' as an int, or pass another variable that is an int"},
      {"GT_GetPos(1, &a[1])", "declare 'a' as an int, or pass another variable that is an int"},
      {"GT_GetDo(12, &t.acc)", "pass another variable that is an int and copy it"},
      {"GT_GetPos(1, &t)", "pass a variable of that type"},
      {"GT_SetTrapPrm(1, &i)", "declare one with 'TTrapPrm name;'"},
      {"GT_SetTrapPrm(1, &t.acc)", "declare one with 'TTrapPrm name;'"},
  };
  for (const Case& test : cases) {
    const Compilation compilation = CompileString(
        fmt::format("int i;\ndouble d, a[2];\nTTrapPrm t;\nint t0() {{ {}; }}\n", test.call));
    ASSERT_EQ(CodesOf(compilation), Codes{19}) << test.call;
    const Message& message = compilation.diagnostics[0].message;
    EXPECT_THAT(message.en, HasSubstr(test.advice));
    EXPECT_THAT(message.en, Not(HasSubstr("cast")));
    EXPECT_THAT(message.zh, Not(HasSubstr("强制")));
  }
}

TEST(Diagnostics, NameTheMissingArguments) {
  const Compilation compilation = CompileString("long a;\nint t0() {\n  GT_GetClock(&a);\n}\n");
  ASSERT_EQ(CodesOf(compilation), Codes{43});
  EXPECT_THAT(compilation.diagnostics[0].message.en, HasSubstr("'pLoop'"));
}

TEST(OutputPaths, StandBesideTheSourceOrInAFolder) {
  EXPECT_EQ(OutputPathsFor("dir/sum.c").bin, "dir/sum.bin");
  EXPECT_EQ(OutputPathsFor("dir/sum.c").ini, "dir/sum.ini");
  EXPECT_EQ(OutputPathsFor("sum").bin, "sum.bin");
  EXPECT_EQ(OutputPathsFor("a.b/sum.v2.c").bin, "a.b/sum.v2.bin");
  EXPECT_EQ(OutputPathsFor("dir/sum.c", "out").bin, "out/sum.bin");
  EXPECT_EQ(OutputPathsFor("dir\\sum.c", "out/").ini, "out/sum.ini");
}

}  // namespace
}  // namespace oncard::compiler
