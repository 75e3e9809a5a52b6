#include "editor/overview.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/editor/marked_source.h"

namespace oncard::editor {
namespace {

std::string OutlineText(const Json& entries, const std::string& indent = {}) {
  std::string text;
  for (const Json& entry : entries) {
    const Json& range = entry["range"];
    text += fmt::format("{}{} {} {}-{} {}:{}\n", indent, entry["kind"].get<std::string>(),
                        entry["name"].get<std::string>(), range["line"].get<int>(),
                        range["end_line"].get<int>(), entry["name_range"]["line"].get<int>(),
                        entry["name_range"]["column"].get<int>());
    if (entry.contains("children")) text += OutlineText(entry["children"], indent + "  ");
  }
  return text;
}

TEST(Outline, HasFunctionsWithWhatIsInThem) {
  const AnalysedSource source(
      "#include \"h.h\"\n#define N 3\nint a, b;\nint f(int k)\n{\n  int i;\nend:\n  i = k;\n}\n"
      "=== h.h\nint c;\n");
  EXPECT_EQ(OutlineText(Outline(source.analysis(), 0)),
            "macro N 2-2 2:9\n"
            "global a 3-3 3:5\n"
            "global b 3-3 3:8\n"
            "function f 4-9 4:5\n"
            "  parameter k 4-4 4:11\n"
            "  local i 6-6 6:7\n"
            "  label end 7-7 7:1\n");
  EXPECT_EQ(OutlineText(Outline(source.analysis(), 1)), "global c 1-1 1:5\n");
}

TEST(Outline, DistinguishesThreadFunctionsAndPrototypes) {
  const AnalysedSource source("int g();\nint f()\n{\n  return g();\n}\nint g()\n{\n}\n",
                              kStructured);
  const Json outline = Outline(source.analysis(), 0);
  ASSERT_EQ(outline.size(), 3u);
  EXPECT_EQ(outline[0]["definition"], false);
  EXPECT_EQ(outline[1]["thread_function"], true);
  EXPECT_EQ(outline[2]["thread_function"], false);
  EXPECT_EQ(outline[2]["definition"], true);
}

TEST(Outline, HasEnumsWithTheirConstants) {
  const AnalysedSource source("enum E { A, B = 4 };\n", kStructured);
  EXPECT_EQ(OutlineText(Outline(source.analysis(), 0)),
            "enum E 1-1 1:6\nconstant A 1-1 1:10\nconstant B 1-1 1:13\n");
}

TEST(Outline, HasStructuresWithTheirMembers) {
  const AnalysedSource source(
      "struct s { int x; int y[2]; };\nstruct s a;\ntypedef struct { int z; } t;\n", kStructured);
  EXPECT_EQ(OutlineText(Outline(source.analysis(), 0)),
            "struct s 1-1 1:8\n"
            "  member x 1-1 1:16\n"
            "  member y 1-1 1:23\n"
            "global a 2-2 2:10\n"
            "typedef t 3-3 3:27\n"
            "  member z 3-3 3:22\n");
}

// Of more structures in each other than the compiler accepts, the inner ones are left out.
TEST(Outline, OfManyStructuresInEachOther) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "struct s {";
  const AnalysedSource source(text + "int x;", kStructured);
  const Json outline = Outline(source.analysis(), 0);
  EXPECT_EQ(outline[0]["name"], "s");
}

// --- Words ---------------------------------------------------------------------------------------

/// Each word of a line with its kind; `!` marks a declaration, `=` what is written.
std::string WordsOf(std::string_view text, bool structured = false) {
  const AnalysedSource source(text, structured);
  const compiler::SourceFile& file = source.analysis().text.file(0).file;
  std::string words;
  for (const Json& word : Tokens(source.analysis(), 0)) {
    const uint32_t begin = OffsetOf(file, {word["line"], word["column"]});
    const uint32_t end = OffsetOf(file, {word["end_line"], word["end_column"]});
    words +=
        fmt::format("{}{}:{}{}", words.empty() ? "" : " ", file.text().substr(begin, end - begin),
                    word["kind"].get<std::string>(), word.value("declaration", false) ? "!" : "");
    if (word.value("write", false)) words += '=';
  }
  return words;
}

TEST(Tokens, HaveKinds) {
  EXPECT_EQ(WordsOf("#define N 3\n"), "#:directive define:directive N:macro! 3:number");
  EXPECT_EQ(WordsOf("#include \"x.h\"\n"), "#:directive include:directive \"x.h\":string");
  EXPECT_EQ(WordsOf("int a; // x\n"), "int:type a:global! // x:comment");
  EXPECT_EQ(WordsOf("TTrapPrm t;\nint f(int k)\n{\n  t.acc = k;\n}\n"),
            "TTrapPrm:type t:global! int:type f:thread-function! int:type k:parameter! t:global= "
            "acc:member k:parameter");
  EXPECT_EQ(WordsOf("int f()\n{\n  int i;\nx:\n  if (i) goto x;\n  GT_AxisOn(1);\n}\n"),
            "int:type f:thread-function! int:type i:local! x:label! if:keyword i:local "
            "goto:keyword x:label GT_AxisOn:command 1:number");
  EXPECT_EQ(WordsOf("static int g(const int x)\n{\n  return x;\n}\n", kStructured),
            "static:keyword int:type g:function! const:keyword int:type x:parameter! "
            "return:keyword x:parameter");
}

TEST(Tokens, OfTextWithMistakes) {
  EXPECT_EQ(WordsOf("int a\nint f(\n{\n  a = ;; 1x } y\n"),
            "int:type a:global! int:type f:thread-function! a:global= 1x:number");
}

TEST(Tokens, HaveCommentsOfSeveralLines) {
  const AnalysedSource source("/* a\n   b */ int x;\n");
  const Json words = Tokens(source.analysis(), 0);
  ASSERT_EQ(words.size(), 3u);
  EXPECT_EQ(words[0], Json::parse(R"({"kind": "comment", "line": 1, "column": 1,
                                      "end_line": 2, "end_column": 8})"));
}

// The second byte of the last character is that of a backslash, in GBK (0xD45C).
TEST(Tokens, HaveCommentsThatEndInGbk) {
  EXPECT_EQ(WordsOf("// \xD4\\\nint x;\n", kStructured), "// \xD4\\:comment int:type x:global!");
  EXPECT_EQ(WordsOf("// a\\\nint x;\nint y;", kStructured),
            "// a\\\nint x;:comment int:type y:global!");
}

// --- Folds ---------------------------------------------------------------------------------------

std::string FoldsOf(std::string_view text) {
  const AnalysedSource source(text, kStructured);
  std::string folds;
  for (const Json& fold : Folds(source.analysis(), 0)) {
    folds += fmt::format("{} {}-{}\n", fold["kind"].get<std::string>(), fold["line"].get<int>(),
                         fold["end_line"].get<int>());
  }
  return folds;
}

TEST(Folds, AreFunctionsBlocksCommentsAndDirectives) {
  EXPECT_EQ(FoldsOf("int f()\n{\n  if (a) {\n    b;\n  }\n}\n"), "function 2-6\nblock 3-5\n");
  EXPECT_EQ(FoldsOf("/* a\n b */\n"), "comment 1-2\n");
  EXPECT_EQ(FoldsOf("// a\n// b\nint x;\n// c\n"), "comment 1-2\n");
  EXPECT_EQ(FoldsOf("int x; // a\n// b\n"), "");
  EXPECT_EQ(FoldsOf("#if A\nint x;\n#else\nint y;\n#endif\n"), "directive 1-2\ndirective 3-5\n");
  EXPECT_EQ(FoldsOf("int f()\n{\n  { a;\n"), "");
  EXPECT_EQ(FoldsOf("}\n#endif\n#else\n"), "");
}

// A program in one line: a place is found without counting from its beginning.
TEST(Tokens, OfALongLine) {
  constexpr int kStatements = 100'000;
  std::string text = "int x;/*值*/void f(){";
  for (int i = 0; i < kStatements; ++i) text += "x=1;";
  const AnalysedSource source(text + "}");
  const Json tokens = Tokens(source.analysis(), 0);
  EXPECT_EQ(tokens.back()["column"], 1 + 20 + 4 * (kStatements - 1) + 2);
}

// --- Hints ---------------------------------------------------------------------------------------

std::string HintsOf(std::string_view text, bool structured = false) {
  const AnalysedSource source(text, structured);
  std::string hints;
  for (const Json& hint : Hints(source.analysis(), 0, source.object())) {
    hints += fmt::format("{}:{} {}\n", hint["line"].get<int>(), hint["column"].get<int>(),
                         hint["label"].get<std::string>());
  }
  return hints;
}

TEST(Hints, NameArgumentsAndSlots) {
  EXPECT_EQ(HintsOf("int a;\ndouble v[2];\nint f(int k)\n{\n  GT_SetVel(1, v[1]);\n}\n"),
            "5:13 profile:\n5:16 vel [pulse/ms]:\n1:6 @0\n2:9 @1\n3:12 @0\n");
}

TEST(Hints, HaveNoSlotsWithoutAnObject) {
  EXPECT_EQ(HintsOf("int a;\nint f()\n{\n  GT_AxisOn(1);\n  b = 1;\n}\n"), "4:13 axis:\n");
}

TEST(Hints, HaveNoSlotsOfBlocksThatShareAName) {
  EXPECT_EQ(HintsOf("int g;\nint f()\n{\n  { int i = g; g = i; }\n  { int i = g; g = i + 1; }\n}\n",
                    kStructured),
            "1:6 @0\n");
}

TEST(Hints, HaveTheUnitsOfMembersThatGetAValue) {
  EXPECT_EQ(HintsOf("TTrapPrm t;\nTJogPrm j;\nint f()\n{\n  t.acc = 0.5;\n  t.smoothTime = 5;\n"
                    "  j.smooth = 0.5;\n  j.dec = t.acc;\n  t.velStart == 1;\n}\n"),
            "5:11 [pulse/ms^2]:\n6:18 [ms]:\n8:11 [pulse/ms^2]:\n");
  EXPECT_EQ(
      HintsOf("struct s { TTrapPrm trap; } a[2];\nint f(int i)\n{\n  a[i].trap.dec = 1;\n  +\n}\n",
              kStructured),
      "4:19 [pulse/ms^2]:\n");
}

TEST(Hints, OfNestedCalls) {
  EXPECT_EQ(HintsOf("int f()\n{\n  GT_AxisOn((1 + 2), 3\n  GT_AxisOn(\n", kStructured),
            "3:13 axis:\n");
}

}  // namespace
}  // namespace oncard::editor
