// The directives and macros of structured C: the words that remain, and what is reported.
#include "compiler/preprocessor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/limits.h"
#include "compiler/condition.h"
#include "compiler/structured_source.h"
#include "tests/compiler/compiler_support.h"

namespace oncard::compiler {
namespace {

// The words that a program consists of after the preprocessor, or the codes and lines of what was
// reported: `MP209:2`.
std::string Words(const std::string& text, const MemoryFiles& files = {}) {
  Reporter reporter;
  const Options options;
  const FileReader reader = ReaderOf(files);
  Preprocessor preprocessor(options, reader, reporter);
  preprocessor.Run(SourceFile("test.c", text));
  std::string words;
  for (const Diagnostic& diagnostic : reporter.diagnostics()) {
    const SourceFile& file = preprocessor.files()[static_cast<size_t>(diagnostic.range.file)];
    if (!words.empty()) words += ' ';
    words += DiagnosticName(diagnostic.info->code) + ':' +
             std::to_string(file.LineOf(diagnostic.range.begin));
  }
  if (!words.empty()) return words;
  for (const Token& token : preprocessor.tokens()) {
    if (token.text.empty()) break;  // the end
    if (!words.empty()) words += ' ';
    words += token.text;
  }
  return words;
}

struct Case {
  std::string text;
  std::string words;
};

void PrintTo(const Case& row, std::ostream* out) { *out << row.text; }

class PreprocessorTest : public testing::TestWithParam<Case> {};
TEST_P(PreprocessorTest, ProgramBecomesTheseTokensOrErrors) {
  EXPECT_EQ(Words(GetParam().text), GetParam().words);
}

INSTANTIATE_TEST_SUITE_P(
    MacroOperators, PreprocessorTest,
    testing::Values(
        // ## joins words, not expanded, to one that is read again.
        Case{"#define J(a, b) a##b\nJ(x, 1) J(1, 2) J(<, <=)", "x1 12 <<="},
        Case{"#define A 1\n#define J(a, b) a ## b\n#define K(a, b) J(a, b)\n#define AA 7\n"
             "J(A, A) K(A, A)",
             "7 11"},
        Case{"#define J(a, b, c) a##b##c\nJ(x, , y) J(, , y) J(x, , ) J(, , ) z", "xy y x z"},
        Case{"#define X a##1 b\nX", "a1 b"},
        Case{"%:define J(a, b) a%:%:b\n%: define S(a) %:a\nJ(x, 1)<:1:> <%S(x)%>",
             "x1 [ 1 ] { \"x\" }"},
        // # makes text of an argument as it is written.
        Case{"#define A 1\n#define S(a) #a\nS(A + b) S( x ) S(\"q\\n\") S()",
             "\"A + b\" \"x\" \"\\\"q\\\\n\\\"\" \"\""},
        Case{"#define H # 1\n#define T(a)\nT(#) 1", "1"},
        // `...` takes the rest, with its commas; `, ##` drops the comma if there is none.
        Case{"#define L(...) f(__VA_ARGS__)\nL(1, (2, 3)) L()", "f ( 1 , ( 2 , 3 ) ) f ( )"},
        Case{"#define L(a, ...) f(a, ##__VA_ARGS__)\nL(1) L(1, 2, 3)", "f ( 1 ) f ( 1 , 2 , 3 )"},
        Case{"#define L(a, rest...) f(a, ##rest)\n#define B L(1, 2\nB, 3) L(1)",
             "f ( 1 , 2 , 3 ) f ( 1 )"},
        Case{"#define E\n#define L(a, ...) f(a, __VA_ARGS__)\nL(1) L(1, E)",
             "f ( 1 , ) f ( 1 , )"}));

INSTANTIATE_TEST_SUITE_P(
    Macros, PreprocessorTest,
    testing::Values(
        // A name stands for its body, whatever that is, also for nothing and for a keyword.
        Case{"#define N 3\nN+N", "3 + 3"}, Case{"#define SUM 1 + 2\n2 * SUM", "2 * 1 + 2"},
        Case{"#define NOTHING\na NOTHING b", "a b"},
        Case{"#define FOREVER for (;;)\nFOREVER ;", "for ( ; ; ) ;"},
        Case{"#define while if\nwhile", "if"}, Case{"#define A B\n#define B 1\nA", "1"},
        // Its definition begins after it, and may change.
        Case{"N\n#define N 1\nN\n#undef N\nN\n#define N 2\nN", "N 1 N 2"},
        Case{"#undef NEVER\na", "a"}, Case{"#define N 1\n#define N  1 // same\nN", "1"},
        Case{"#define N 1\n#define N 2\nN", "MP013:2"},
        Case{"#define F(a) a\n#define F(b) b\nF(1)", "MP013:2"},
        Case{"#define F(a) a\n#define F (a) a\n", "MP013:2"},
        // Parameters stand for what is written in the parentheses.
        Case{"#define MAX(a, b) ((a) > (b) ? (a) : (b))\nMAX(x, y + 1)",
             "( ( x ) > ( y + 1 ) ? ( x ) : ( y + 1 ) )"},
        Case{"#define F(a, b) b a\nF((1, 2), g(3, 4))", "g ( 3 , 4 ) ( 1 , 2 )"},
        Case{"#define F(a) [a]\nF() F( ) F(\n1\n)", "[ ] [ ] [ 1 ]"},
        Case{"#define F() 7\nF() F ( )", "7 7"},
        Case{"#define F(a, b) a-b\nF(,1) F(1,)", "- 1 1 -"},
        Case{"#define TWICE(x) x x\nTWICE(i++)", "i ++ i ++"},
        Case{"#define SWAP(a, b) do { int t = a; a = b; b = t; } while (0)\nSWAP(x, y);",
             "do { int t = x ; x = y ; y = t ; } while ( 0 ) ;"},
        // A macro with parameters is only called with a parenthesis.
        Case{"#define F(a) [a]\nF; F (1) F", "F ; [ 1 ] F"}, Case{"#define F (1)\nF", "( 1 )"},
        // The result is read again, together with what follows.
        Case{"#define F(a) a + 1\n#define G F\nG(2)", "2 + 1"},
        Case{"#define F(a) a\n#define OPEN F(\nF(F(3)) F(F)(4)", "3 F ( 4 )"},
        Case{"#define ADD(a, b) a + b\n#define PAIR 1, 2\nADD(PAIR, 3)", "1 , 2 + 3"},
        // No macro is expanded inside itself; an argument is not inside.
        Case{"#define N N + 1\nN", "N + 1"}, Case{"#define A B\n#define B A\nA B", "A B"},
        Case{"#define F(x) F(x + 1)\nF(F(2))", "F ( F ( 2 + 1 ) + 1 )"},
        Case{"#define f(a) a*g\n#define g(a) f(a)\nf(2)(9)", "2 * 9 * g"},
        // The examples of the C standard (C11 6.10.3.5).
        Case{
            "#define x 3\n#define f(a) f(x * (a))\n#undef x\n#define x 2\n#define g f\n"
            "#define z z[0]\n#define h g(~\n#define m(a) a(w)\n#define w 0,1\n#define t(a) a\n"
            "f(y+1) + f(f(z)) % t(t(g)(0) + t)(1);",
            "f ( 2 * ( y + 1 ) ) + f ( 2 * ( f ( 2 * ( z [ 0 ] ) ) ) ) % f ( 2 * ( 0 ) ) + t ( 1 ) "
            ";"},
        Case{
            "#define f(a) f(2 * (a))\n#define g f\n#define h g(~\n#define m(a) a(w)\n#define w "
            "0,1\n"
            "g(1+(3,4)-w) | h 5) & m(f)^m(m);",
            "f ( 2 * ( 1 + ( 3 , 4 ) - 0 , 1 ) ) | f ( 2 * ( ~ 5 ) ) & f ( 2 * ( 0 , 1 ) ) ^ m ( 0 "
            ", 1 ) ;"},
        // Lines are continued by a backslash, in a body, a comment and the program.
        Case{"#define SUM(a, b) \\\n  ((a) + \\\r\n   (b))\nSUM(1, 2)", "( ( 1 ) + ( 2 ) )"},
        Case{"a \\\n b", "a b"}, Case{"a // b \\\n c\nd", "a d"},
        Case{"#define N 1 /* two\nlines */ + 2\nN", "1 + 2"}, Case{"ab\\\ncd", "MP211:1"},
        // true and false are numbers, unless they are macros.
        Case{"#define true 7\ntrue false", "7 false"},
        // Whether a long name is too long is known when it is known whether it reaches the output.
        Case{"#ifndef A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS\n"
             "#define A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS 1\n#endif\n"
             "A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS",
             "1"},
        Case{"A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS", "A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS"},
        // What is refused.
        Case{"#define F(a, b) a\nF(1)", "MP209:2"}, Case{"#define F(a) a\nF(1, 2)", "MP209:2"},
        Case{"#define F() 1\nF(2)", "MP209:2"}, Case{"#define F(a, b) a\nF()", "MP209:2"},
        Case{"#define S(a) #b\n", "MP210:1"}, Case{"#define J(a) a##\n", "MP210:1"},
        Case{"#define J ## 1\n", "MP210:1"}, Case{"#define J(a, b) a##b\n\nJ(x, -)", "MP210:3"},
        Case{"#define F(a) a\nF(1\n#define G\n)", "MP213:2"},
        Case{"#define F(a) a\nx F(", "MP213:2"}, Case{"#define P(..., a) 1\n", "MP131:1"},
        Case{"#define P(a, ...) 1\nP()", "1"}, Case{"#define F(a, a) 1\n", "MP013:1"},
        Case{"#define F(a b) 1\n", "MP131:1"}, Case{"#define F(1) 1\n", "MP131:1"},
        Case{"#define F(a,) 1\n", "MP131:1"}, Case{"#define F(a\n", "MP131:1"},
        Case{"#define\n", "MP128:1"}, Case{"#define 5 6\n", "MP128:1"},
        Case{"#define defined 1\n", "MP128:1"}, Case{"#undef\n", "MP128:1"},
        Case{"#redefine N 1\n", "MP217:1"}, Case{"#line 5\n", "MP217:1"}, Case{"#5\n", "MP217:1"}));

INSTANTIATE_TEST_SUITE_P(
    Conditions, PreprocessorTest,
    testing::Values(
        Case{"#if 1\na\n#else\nb\n#endif\nc", "a c"}, Case{"#if 0\na\n#else\nb\n#endif\nc", "b c"},
        Case{"#ifdef N\na\n#endif\n#define N\n#ifdef N\nb\n#endif", "b"},
        Case{"#ifndef N\na\n#endif\n#define N\n#ifndef N\nb\n#endif", "a"},
        Case{"#if 0\na\n#elif 1\nb\n#elif 1\nc\n#else\nd\n#endif", "b"},
        Case{"#if 1\na\n#elif 1 / 0\nb\n#endif", "a"},
        Case{"#if 0\n#if 1\na\n#else\nb\n#endif\n#else\nc\n#endif", "c"},
        Case{"#if 1\n#if 0\na\n#elif 1\nb\n#endif\nc\n#endif", "b c"},
        Case{"#define N 3\n#if defined N && defined(N) && !defined(M) && N > 2\na\n#endif", "a"},
        Case{"#define F(a) ((a) * 2)\n#if F(3) == 6\na\n#endif", "a"},
        Case{"#if UNKNOWN\na\n#else\nb\n#endif", "b"}, Case{"#\na", "a"},
        Case{"int f() {\n#if 1\na\n#endif\n}", "int f ( ) { a }"},
        // Anything may stand in text that is not read.
        Case{"#if 0\n'don't \" @ 09 #define N\n#nonsense\n#endif\na", "a"},
        Case{"#if 1\na\n#else\n@\n#endif", "a"}, Case{"#if 0\n#error no\n#endif\na", "a"},
        Case{"#pragma vendor @option\na", "a"},
        // What is refused.
        Case{"#error do not @build this\n", "MP216:1"}, Case{"#if 1\na", "MP214:1"},
        Case{"#endif\n", "MP214:1"}, Case{"#else\n", "MP214:1"}, Case{"#elif 1\n", "MP214:1"},
        Case{"#if 1\n#else\n#else\n#endif\n", "MP214:3"},
        Case{"#if 1\n#else\n#elif 1\n#endif\n", "MP214:3"}, Case{"#if\n#endif", "MP215:1"},
        Case{"#if 1 +\n#endif", "MP215:1"}, Case{"#if 1.5\n#endif", "MP215:1"},
        Case{"#if 9223372036854775808\n#endif", "MP215:1"},
        Case{"#if 0x10000000000000000\n#endif", "MP215:1"},
        Case{"#if 1lL\n#endif", "MP003:1 MP215:1"}, Case{"#if 1 ? 2 : 1.5\n#endif", "MP215:1"},
        Case{"#define N 1LL\n#if N\na\n#endif", "a"}, Case{"#define N 1LL\nN", "MP200:2"},
        Case{"#if 1 / 0\n#endif", "MP215:1"}, Case{"#if defined\n#endif", "MP215:1"},
        Case{"#if defined(N\n#endif", "MP215:1"}, Case{"#if a = 1\n#endif", "MP215:1"},
        Case{"#ifdef\n#endif", "MP128:1"}, Case{"#ifdef 1\n#else\na\n#endif", "MP128:1"}));

// Conditions are computed with 64 bits, and with a sign unless a number has the suffix U.
TEST(Condition, IsComputedAsInC) {
  for (const char* text : {"2147483647 + 1 > 0",
                           "1 << 40",
                           "0xFFFFFFFF > 0",
                           "-1 < 0",
                           "-1 > 0u",
                           "'a' == 97",
                           "1 ? 2 : 0",
                           "0 && 1 / 0 || 1",
                           "1 || 1 % 0",
                           "7 % 4 == 3 && -7 / 2 == -3",
                           "~0 == -1",
                           "!0",
                           "6 & 3",
                           "6 ^ 2",
                           "1 | 0",
                           "true",
                           "-8 >> 1 == -4",
                           "010 == 8",
                           "0b11 == 3",
                           "5 - 3 == 2",
                           "2 * 3 >= 6",
                           "2 <= 2",
                           "1 != 2",
                           "4611686018427387903 + 1 > 0",
                           "(1 ? -1 : 0u) > 0",
                           "(0 ? 1 / 0u : -1) > 0",
                           "(1 ? -1 : 0 && 0u) < 0",
                           "(1 ? -1 : 1u << 1) > 0",
                           "(1 ? -1 : !0u) < 0",
                           "1 ? 1 : 1 / 0",
                           "0 || (1 ? 2 : 3 % 0)",
                           "9223372036854775807 > 1",
                           "-9223372036854775807 - 1 < 0",
                           "0xFFFFFFFFFFFFFFFF == -1",
                           "0xFFFFFFFFFFFFFFFF > 0x7FFFFFFFFFFFFFFF",
                           "0x8000000000000000 > 0",
                           "0x7FFFFFFFFFFFFFFF + 0 > -1",
                           "18446744073709551615u == ~0u",
                           "01777777777777777777777 == -1",
                           "-1 < 1LL",
                           "-1 > 0ull && 1LLU",
                           "12l == 12 && 12lu == 12"}) {
    EXPECT_EQ(Words(std::string("#if ") + text + "\nyes\n#endif"), "yes") << text;
  }
  for (const char* text : {"0", "1 == 2", "2 < 1", "0 || 0", "1 && 0", "false", "!1", "0 ? 1 : 0",
                           "(1 ? -1 : 0u) < 0", "-1 > 9223372036854775807"}) {
    EXPECT_EQ(Words(std::string("#if ") + text + "\nyes\n#endif"), "") << text;
  }
}

// 0xD4 0x5C is one character of GBK, whose second byte is that of a backslash. The Latin small
// letter o with a stroke is valid UTF-8: there the byte is a backslash.
TEST(Lines, ContinueAfterABackslashButNotAfterHalfACharacter) {
  EXPECT_EQ(Words("a // \\\nb\nc"), "a c");
  EXPECT_EQ(Words("a // \\ \t\r\nb \\\nc\nd"), "a d");
  EXPECT_EQ(Words("a // \xD4\\\nb\nc"), "a b c");
  EXPECT_EQ(Words("a // \xD4\\ \r\nb"), "a b");
  EXPECT_EQ(Words("a // \xD4\\\\\nb\nc"), "a c");
  EXPECT_EQ(Words("a // \xC3\xB8\\\nb\nc"), "a c");
  EXPECT_EQ(Words("a // \\"), "a");
}

TEST(Include, NameMayEndInAGbkCharacterWithTheByteOfABackslash) {
  EXPECT_EQ(Words("#include \"\xD4\\\"\nb", {{"\xD4\\", "a\n"}}), "a b");
}

TEST(Include, FilesMayIncludeOthersAndGuardThemselves) {
  const MemoryFiles files = {
      {"a.h", "#ifndef A_H\n#define A_H\n#include \"folder/b.h\"\na\n#endif\n"},
      {"folder/b.h", "#pragma once\n#include \"c.h\"\n#include \"a.h\"\nb\n"},
      {"folder/c.h", "c\n"},
      {"c.h", "wrong\n"},
      {"open.h", "int f() {\n"},
      {"self.h", "#include \"self.h\"\n"},
      {"twice.h", "#include \"twice.h\"\n#include \"twice.h\"\n"},
      {"unclosed.h", "#if 1\n"}};
  EXPECT_EQ(Words("#include \"a.h\"\n#include \"a.h\"\n#include \"folder/b.h\"\nd", files),
            "c b a d");
  // A file may hold half of a function, as in C, but no half of an #if.
  EXPECT_EQ(Words("#include \"open.h\"\n}", files), "int f ( ) { }");
  EXPECT_EQ(Words("#include \"unclosed.h\"\n#endif", files), "MP214:1 MP214:2");
  EXPECT_EQ(Words("#include \"self.h\"", files), "MP212:1");
  // Read to the end, it would be read 2^32 times.
  EXPECT_EQ(Words("#include \"twice.h\"", files), "MP212:1");
}

// The vendor's header is for hosts; what programs need of it is known.
TEST(Include, OnlyHeadersThatProgramsDoNotNeedAreIgnored) {
  EXPECT_EQ(Words("#include \"gts.h\"\n#include <gts.h>\n#include \"../sdk/gts.h\"\na"), "a");
  EXPECT_EQ(Words("#include <stdbool.h>\na"), "a");
  EXPECT_EQ(Words("#include <stdio.h>\n"), "MP037:1");
  EXPECT_EQ(Words("#include \"missing.h\"\n"), "MP022:1");
  EXPECT_EQ(Words("#include\n"), "MP037:1");
  EXPECT_EQ(Words("#include missing.h\n"), "MP037:1");
  EXPECT_EQ(Words("#include \"\"\n"), "MP037:1");
}

// Macros that double each other reach the limit, not the end of the memory.
TEST(Macro, ExpansionIsLimited) {
  std::string doubling = "#define X0 x\n";
  std::string nested = "#define F(a) a a\nF(";
  for (int i = 0; i < 40; ++i) {
    doubling += "#define X" + std::to_string(i + 1) + " X" + std::to_string(i) + " X" +
                std::to_string(i) + "\n";
    nested += "F(";
  }
  EXPECT_EQ(Words(doubling + "X40"), "MP022:1");
  EXPECT_EQ(Words(nested + "x" + std::string(41, ')')), "MP022:1");
  std::string deep = "#define G(a) a\n";
  for (int i = 0; i < 1000; ++i) deep += "G(";
  EXPECT_TRUE(Words(deep + "x" + std::string(1000, ')')).starts_with("MP130:2"));
}

// What the arguments of nested macros are replaced by counts at every level; the arguments do not.
TEST(Macro, ArgumentsAreCountedWhenTheyAreCopied) {
  const auto nested = [](int levels, int words) {
    std::string text = "#define F(a) a\n";
    for (int i = 0; i < levels; ++i) text += "F(";
    for (int i = 0; i < words; ++i) text += "x ";
    return text + std::string(static_cast<size_t>(levels), ')');
  };
  EXPECT_EQ(Words(nested(190, 5'000)).size(), 2u * 5'000 - 1);  // 950 000 and 6 000 tokens
  EXPECT_EQ(Words(nested(190, 6'000)), "MP022:1");
  EXPECT_EQ(Words(nested(1, 500'000)).size(), 2u * 500'000 - 1);
  // Those that begin in a macro and end behind it are put together.
  EXPECT_EQ(Words("#define F(a, b) b a\n#define OPEN F(1, \nOPEN 2) OPEN F(3, 4))"), "2 1 4 3 1");
}

// Each macro is replaced while the one before it is: none of them is searched for the others.
TEST(Macro, ChainOfManyIsExpanded) {
  std::string chain = "#define X0 x\n";
  for (int i = 1; i <= 50'000; ++i) {
    chain += "#define X" + std::to_string(i) + " X" + std::to_string(i - 1) + "\n";
  }
  EXPECT_EQ(Words(chain + "X50000"), "x");
}

// Words of a body stand at the use of the macro, for messages; arguments where they are written.
TEST(Macro, TokensOfItsBodyHaveThePlaceOfItsUse) {
  Reporter reporter;
  const Options options;
  const FileReader reader = NoFiles();
  Preprocessor preprocessor(options, reader, reporter);
  const std::string text = "#define SUM(a, b) ((a) + (b))\nSUM(xx, 1)";
  preprocessor.Run(SourceFile("test.c", text));
  for (const Token& token : preprocessor.tokens()) {
    if (token.text.empty()) break;  // the end
    const std::string_view place =
        std::string_view(text).substr(token.range.begin, token.range.end - token.range.begin);
    const bool argument = token.text == "xx" || token.text == "1";
    EXPECT_EQ(place, argument ? token.text : "SUM(xx, 1)");
  }
}

TEST(Macro, MessageInItsBodyHasANoteAboutIt) {
  Reporter reporter;
  const StructuredSource source("test.c", "#define TEXT (\"text\")\nint a = TEXT;\nint *b;\n", {},
                                NoFiles(), reporter);
  source.AddMacroNotes(reporter);
  ASSERT_EQ(reporter.diagnostics().size(), 2u);
  const Diagnostic& in_macro = reporter.diagnostics()[0];
  EXPECT_EQ(in_macro.range, (SourceRange{0, 30, 34}));
  ASSERT_EQ(in_macro.notes.size(), 1u);
  EXPECT_EQ(in_macro.notes[0].range, (SourceRange{0, 8, 12}));
  EXPECT_EQ(in_macro.notes[0].message.en, "this comes from the macro 'TEXT', defined here");
  ASSERT_EQ(reporter.diagnostics()[1].notes.size(), 1u);  // what to write instead
  EXPECT_FALSE(reporter.diagnostics()[1].notes[0].has_place);
}

}  // namespace
}  // namespace oncard::compiler
