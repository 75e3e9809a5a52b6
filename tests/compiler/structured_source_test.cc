// Structured C as a tree: what the front end accepts, and the shape that it gives it.
#include "compiler/structured_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/dialect.h"
#include "compiler/fix_it_applier.h"
#include "tests/compiler/compiler_support.h"
#include "tests/compiler/tree_text.h"

namespace oncard::compiler {
namespace {

// The tree of a program, or what was reported about it.
std::string Read(const std::string& text, const MemoryFiles& files = {}) {
  Reporter reporter;
  const StructuredSource source("test.c", text, {}, ReaderOf(files), reporter);
  std::string reported;
  for (const Diagnostic& diagnostic : reporter.diagnostics()) {
    reported += DiagnosticName(diagnostic.info->code) + ": " + diagnostic.message.en + '\n';
  }
  return reported.empty() ? TreeText(source.tree().items) : reported;
}

// The tree of the statements of a function's body.
std::string ReadBody(const std::string& statements) {
  const std::string before = "(void t0 () {";
  const std::string tree = Read("void t0() { " + statements + " }");
  if (!tree.starts_with(before)) return tree;
  return tree.substr(before.size(), tree.size() - before.size() - 2);
}

struct Row {
  std::string text;
  std::string tree;
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.text; }

class DeclarationTest : public testing::TestWithParam<Row> {};
TEST_P(DeclarationTest, IsReadAsThisTree) { EXPECT_EQ(Read(GetParam().text), GetParam().tree); }

INSTANTIATE_TEST_SUITE_P(
    Rules, DeclarationTest,
    testing::Values(
        // Enums: named, anonymous, with values, with a comma at the end, used as a type.
        Row{"enum Color { kRed, kGreen = 5, kBlue };", "(decl enum Color{ kRed kGreen=5 kBlue })"},
        Row{"enum { kMax = 2 * 8, };", "(decl enum { kMax=(* 2 8) })"},
        Row{"enum Mode { kOff } mode = kOff;", "(decl enum Mode{ kOff } mode=kOff)"},
        Row{"const enum Mode mode;", "(decl const enum Mode mode)"},
        Row{"enum Mode next(enum Mode mode);", "(enum Mode next (enum Mode mode))"},
        // Structures: named, anonymous, nested, used as a type, declared alone.
        Row{"struct point { int x, y[2]; };", "(decl struct point{ (decl int x y[2]) })"},
        Row{"struct { double d; } a, b[2];", "(decl struct { (decl double d) } a b[2])"},
        Row{"static struct line { struct point from; struct { int z; } to; } one;",
            "(decl static struct line{ (decl struct point from) "
            "(decl struct { (decl int z) } to) } one)"},
        Row{"const struct point p = {1};", "(decl const struct point p=(values 1))"},
        Row{"struct point;", "(decl struct point)"},
        Row{"struct point next(struct point p, struct point *q);",
            "(struct point next (struct point p, struct point *q))"},
        Row{"typedef struct point { int x; } point; point p;",
            "(decl typedef struct point{ (decl int x) } point) (decl point p)"},
        // Initial values: nested, without a size, empty, with a comma at the end.
        Row{"int a[2][3] = {{1, 2, 3}, {4, 5, 6}};",
            "(decl int a[2][3]=(values (values 1 2 3) (values 4 5 6)))"},
        Row{"int a[] = {1, 2,};", "(decl int a[]=(values 1 2))"},
        Row{"int a[][2] = {{1}, {2}};", "(decl int a[][2]=(values (values 1) (values 2)))"},
        Row{"int a[4] = {};", "(decl int a[4]=(values))"},
        Row{"int a = {1};", "(decl int a=(values 1))"},
        Row{"int a = 1, b[2], c = 2 + 3;", "(decl int a=1 b[2] c=(+ 2 3))"},
        // Words of a type, in any order.
        Row{"static const unsigned char table[2] = {1, 2};",
            "(decl static const unsigned char table[2]=(values 1 2))"},
        Row{"short const limit = 3;", "(decl short const limit=3)"},
        Row{"bool a; _Bool b;", "(decl bool a) (decl _Bool b)"},
        Row{"volatile int shared;", "(decl volatile int shared)"},
        // Prototypes.
        Row{"int f(void); int g(int a, double b);", "(int f (void)) (int g (int a, double b))"},
        Row{"int f(int, double);", "(int f (int, double))"},
        Row{"int f(int [], int [][3]);", "(int f (int [], int [][3]))"},
        Row{"static int f(const int a[4]);", "(static int f (const int a[4]))"},
        Row{"void f(int a[], int b[2][3]) { }", "(void f (int a[], int b[2][3]) {})"}));

class StatementTest : public testing::TestWithParam<Row> {};
TEST_P(StatementTest, IsReadAsThisTree) { EXPECT_EQ(ReadBody(GetParam().text), GetParam().tree); }

INSTANTIATE_TEST_SUITE_P(
    Rules, StatementTest,
    testing::Values(
        // sizeof takes an expression or a type, but no cast.
        Row{"a = sizeof b;", "(= a (sizeof b))"}, Row{"a = sizeof(b);", "(= a (sizeof (paren b)))"},
        Row{"a = sizeof(int);", "(= a (sizeof int))"},
        Row{"a = sizeof(unsigned char[4][2]);", "(= a (sizeof unsigned char[4][2]))"},
        Row{"a = sizeof(int) - 1;", "(= a (- (sizeof int) 1))"},
        Row{"a = sizeof(int[2]) / sizeof a[0];", "(= a (/ (sizeof int[2]) (sizeof (index a 0))))"},
        Row{"a = sizeof sizeof(enum Mode);", "(= a (sizeof (sizeof enum Mode)))"},
        Row{"a = (unsigned char) b + 1;", "(= a (+ (cast unsigned char b) 1))"},
        // A label belongs to the statement after it.
        Row{"if (a) done: b = 1; b = 2;", "(if a {(label done) (= b 1)}) (= b 2)"},
        Row{"if (a) x: y: b = 1; else z: b = 2;",
            "(if a {(label x) (label y) (= b 1)} else {(label z) (= b 2)})"},
        Row{"while (a) next: a--;", "(while a {(label next) (post-- a)})"},
        Row{"do next: a--; while (a);", "(do {(label next) (post-- a)} while a)"},
        Row{"for (;;) next: a--;", "(for empty; ; ; {(label next) (post-- a)})"},
        // It may stand before a declaration, before the end of a block, and after another one.
        Row{"here: int a;", "(label here) (decl int a)"},
        Row{"{ goto end; end: }", "{(goto end) (label end)}"},
        Row{"a: b: c = 1;", "(label a) (label b) (= c 1)"},
        Row{"a: c = d ? e : f; g: c = 1;", "(label a) (= c (? d e f)) (label g) (= c 1)"},
        // Cases: values, ranges, conditional values, several before one statement.
        Row{"switch (a) { case 1: case 2 + 1: b = 1; break; default: b = 2; }",
            "(switch a {(case 1) (case (+ 2 1)) (= b 1) break default (= b 2)})"},
        Row{"switch (a) { case 1 ... 5: break; case 'a'...'z': ; }",
            "(switch a {(case 1 ... 5) break (case 'a' ... 'z') empty})"},
        Row{"switch (a) { case b ? 1 : 2: c = 1; }", "(switch a {(case (? b 1 2)) (= c 1)})"},
        Row{"switch (a) case 1: default: b = 1; b = 2;",
            "(switch a {(case 1) default (= b 1)}) (= b 2)"},
        Row{"switch (a) { case 1: { int b; b = 1; } case 2: }",
            "(switch a {(case 1) {(decl int b) (= b 1)} (case 2)})"},
        // An else belongs to the inner if, also behind a label.
        Row{"if (a) x: if (b) c = 1; else c = 2;",
            "(if a {(label x) (if b (= c 1) else (= c 2))})"},
        Row{"for (int i = 0, j = 1; i < j; i++, j--) continue;",
            "(for (decl int i=0 j=1); (< i j); (, (post++ i) (post-- j)); continue)"},
        Row{"int a[2] = {b, c}, d = e, f;", "(decl int a[2]=(values b c) d=e f)"},
        Row{"int a[4] = {[1] = b, [2 ... 3] = c}, d[2][2] = {[0][1] = e, .f = {[1] = g}};",
            "(decl int a[4]=(values (at b 1) (at c 2 3)) "
            "d[2][2]=(values (at (at e 1) 0) (.f (values (at g 1)))))"},
        // Names of types, and variables that hide them.
        Row{"typedef int word, row[2]; word a; row b; a = (word)b + sizeof(row);",
            "(decl typedef int word row[2]) (decl word a) (decl row b) "
            "(= a (+ (cast word b) (sizeof row)))"},
        Row{"typedef int t; { int t; t = 1; a.t = t * b; } { t c; } t d;",
            "(decl typedef int t) {(decl int t) (= t 1) (= (.t a) (* t b))} "
            "{(decl t c)} (decl t d)"},
        Row{"static int calls = 0; enum { kLocal = 3 };",
            "(decl static int calls=0) (decl enum { kLocal=3 })"},
        Row{"a = b = c ? d, e : f ? g : h;", "(= a (= b (? c (, d e) (? f g h))))"}));

// The text with the fix-its of what is reported about it.
std::string Corrected(const std::string& text) {
  Reporter reporter;
  const StructuredSource source("test.c", text, {}, NoFiles(), reporter);
  std::vector<FixIt> edits;
  for (const Diagnostic& diagnostic : reporter.diagnostics()) {
    edits.insert(edits.end(), diagnostic.fixits.begin(), diagnostic.fixits.end());
  }
  return ApplyEdits(text, edits);
}

TEST(StructuredFixIts, MakeWordsOfOtherCompilersThoseOfStructuredC) {
  const Row rows[] = {
      {"void t0() { v = L'x' + u8'\\n'; }", "void t0() { v = 'x' + '\\n'; }"},
      // C before 1999: an int may be left out, and the types of parameters stand before the body.
      {"static n;\nconst limit = 3;", "static int n;\nconst int limit = 3;"},
      {"int n;\nset(int a) {\n  n = a;\n}", "int n;\nint set(int a) {\n  n = a;\n}"},
      {"int f(a, b) { return a + b; }", "int f(int a, int b) { return a + b; }"},
      {"int f(a, b, c)\nunsigned char b[2][3];\nenum e c;\n{\n  return a;\n}",
       "int f(int a, unsigned char b[2][3], enum e c)\n{\n  return a;\n}"},
      {"void f(a, b, c) double a, c; int b; {}", "void f(double a, int b, double c) {}"},
  };
  for (const Row& row : rows) EXPECT_EQ(Corrected(row.text), row.tree) << row.text;
}

TEST(StructuredMessages, SayWhatToWriteInsteadOfAPointer) {
  Reporter reporter;
  const StructuredSource source("test.c", "void f(int **list) {}\nint *place;\n", {}, NoFiles(),
                                reporter);
  ASSERT_EQ(reporter.diagnostics().size(), 2u);
  ASSERT_EQ(reporter.diagnostics()[0].notes.size(), 1u);
  EXPECT_THAT(reporter.diagnostics()[0].notes[0].message.en, testing::HasSubstr("'int *list'"));
  ASSERT_EQ(reporter.diagnostics()[1].notes.size(), 1u);
  EXPECT_THAT(reporter.diagnostics()[1].notes[0].message.en, testing::HasSubstr("an index"));
}

// Each as "BEFORE|COMMENT|BEHIND", with the words around it, and a star if it is alone on its
// lines.
std::vector<std::string> CommentsOf(const std::string& text) {
  Reporter reporter;
  const StructuredSource source("test.c", text, {}, NoFiles(), reporter);
  EXPECT_FALSE(reporter.HasErrors()) << text;
  std::vector<std::string> comments;
  const auto word_at = [&text](uint32_t at) {
    return text.substr(at, text.find_first_of(" ;\n", at + 1) - at);
  };
  for (const SourceComment& comment : source.comments()) {
    const SourceRange& range = comment.range;
    comments.push_back(word_at(comment.before) + "|" +
                       text.substr(range.begin, range.end - range.begin) + "|" +
                       word_at(comment.behind) + (comment.alone ? "*" : ""));
  }
  return comments;
}

TEST(StructuredComments, StandAloneOrBesideWords) {
  using testing::ElementsAre;
  EXPECT_THAT(CommentsOf("// a\n/* b */ // c\nint v; // d\n /* e\n */\n/* f */ int w; /* g\n*/\n"),
              ElementsAre("//|// a|int*", "//|/* b */|int*", "//|// c|int*", ";|// d|int",
                          ";|/* e\n */|int*", ";|/* f */|int", ";|/* g\n*/|"));
  EXPECT_THAT(CommentsOf("int v; /* a\n */ // b\n\n/* c\n*/ int w;\n"),
              ElementsAre(";|/* a\n */|int", ";|// b|int*", ";|/* c\n*/|int"));
  EXPECT_THAT(CommentsOf("int v; // a \\\n b\nint w; //"),
              ElementsAre(";|// a \\\n b|int", ";|//|"));
}

TEST(StructuredComments, AreNoPartsOfTextsLinesForToolsOrSkippedText) {
  using testing::ElementsAre;
  EXPECT_THAT(CommentsOf("//@ structured\n  //@ final: v == 1\nint v; //@ a\n"),
              ElementsAre(";|//@ a|"));
  EXPECT_THAT(CommentsOf("#define A \"/*\" // a\n#if 0\n// b\n#endif\nint v = 7 / 2;\n"),
              ElementsAre("\"/*\"|// a|#if"));
}

TEST(DialectTest, FirstLineSelectsStructuredC) {
  for (const char* text : {"//@ structured", "//@ structured\nint a;", "//@structured\r\nint a;",
                           "\xEF\xBB\xBF  //@  structured  \n"}) {
    EXPECT_TRUE(WantsStructured(text)) << text;
  }
  for (const char* text : {"", "// structured", "\n//@ structured", "//@ structure",
                           "//@ structured C", "int a; //@ structured", "//@ Structured"}) {
    EXPECT_FALSE(WantsStructured(text)) << text;
  }
}

TEST(DialectTest, WordsOfStructuredCKeepTheirMeaningInTheCardsLanguage) {
  struct CardCase {
    std::string text;
    std::vector<int> codes;
  };
  for (const CardCase& row : std::vector<CardCase>{
           {"enum { kA };", {115}},
           {"int t0() { return sizeof(int); }", {115}},
           {"int volatile; int inline; int asm; int t0() { return volatile; }", {}},
           {"int bool; int t0() { return bool; }", {}},
           {"int int32_t; int __inline__; int L; int t0() { return int32_t; }", {}},
           {"int t0() <% return 0; %>", {40, 32, 4}},
           {"int f(int []); int t0() { return 0; }", {128}},
           {"int a[2] = {}; int t0() { return a[0]; }", {127, 24, 27}},
           {"int a; int t0() { switch (a) { case 1 ... 2: a = 1; } return a; }", {105, 128}},
           {"int t0() { return 0b11; }", {3}},
           {"int t0() { return 010; }", {118}}}) {
    EXPECT_EQ(CodesOf(CompileString(row.text)), row.codes) << row.text;
  }
}

}  // namespace
}  // namespace oncard::compiler
