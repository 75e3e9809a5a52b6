// A lowered program beside its C: which rows there are, and how they are printed.
#include "compiler/lowering/two_columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

std::string Columns(const std::string& program, int width, const MemoryFiles& files = {}) {
  const Lowering lowering = LowerText("p.c", program, {}, {.comments = false}, ReaderOf(files));
  EXPECT_TRUE(lowering.text.has_value()) << program;
  return lowering.text ? FormatTwoColumns(lowering, {.width = width}) : std::string();
}

TEST(TwoColumns, HaveEachStatementInTheRowsOfThoseThatItBecame) {
  EXPECT_EQ(Columns("int v;\n\nvoid t0(int n) {\n  // counts\n  for (; n > 0; n--) {\n    v += n;\n"
                    "    // done\n  }\n  do {\n    v = v * 2 + 1;\n  } while (v < 9);\n}\n",
                    70),
            " 1  int v;                          | int v;\n"
            " 2\n"
            " 3  void t0(int n) {                | void t0(int n) {\n"
            "                                    |   int tmp1;\n"
            " 4    // counts\n"
            " 5    for (; n > 0; n--) {          | lbl_for_5:\n"
            "                                    |   tmp1 = n <= 0;\n"
            "                                    |   if (tmp1) goto lbl_for_5_end;\n"
            " 6      v += n;                     |   v = v + n;\n"
            " 7      // done\n"
            " 8    }\n"
            " 5    for (; n > 0; n--) {          |   n = n - 1;\n"
            "                                    |   goto lbl_for_5;\n"
            "                                    | lbl_for_5_end:\n"
            " 9    do {                          | lbl_do_9:\n"
            "10      v = v * 2 + 1;              |   tmp1 = v * 2;\n"
            "                                    |   v = tmp1 + 1;\n"
            "11    } while (v < 9);              |   tmp1 = v < 9;\n"
            "                                    |   if (tmp1) goto lbl_do_9;\n"
            "12  }                               | }\n");
}

TEST(TwoColumns, KnowTheLinesOfBothTexts) {
  const Lowering lowering = LowerText("p.c", "int v;\n\nvoid t0(int n) {\n  v += 2 * n;\n}\n", {},
                                      {.comments = false}, ReaderOf({}));
  ASSERT_TRUE(lowering.text.has_value());
  const SourceFile lowered("card.c", *lowering.text);
  int cards = 0;
  for (const TwoColumnsRow& row : RowsOf(lowering)) {
    EXPECT_EQ(row.card_line > 0, !row.card.empty());
    if (row.card_line == 0) continue;
    EXPECT_EQ(lowered.Line(row.card_line), row.card);
    ++cards;
  }
  EXPECT_EQ(cards, 6) << *lowering.text;
}

// Those between declarations stand before all of them on the card.
TEST(TwoColumns, KeepDefinedNamesWhereTheyAre) {
  EXPECT_EQ(Columns("// axes\n#define X 1\n#define UNUSED 3\n#define Y 2\nint v;\n#define Z 3\n"
                    "void t0() {\n  GT_AxisOn(Z);\n  GT_AxisOn(Y);\n  GT_AxisOn(X);\n}\n",
                    60),
            " 1  // axes\n"
            " 2  #define X 1                | #define X 1\n"
            " 3  #define UNUSED 3\n"
            " 4  #define Y 2                | #define Y 2\n"
            " 6  #define Z 3                | #define Z 3\n"
            " 5  int v;                     | int v;\n"
            " 7  void t0() {                | void t0() {\n"
            " 8    GT_AxisOn(Z);            |   GT_AxisOn(Z);\n"
            " 9    GT_AxisOn(Y);            |   GT_AxisOn(Y);\n"
            "10    GT_AxisOn(X);            |   GT_AxisOn(X);\n"
            "11  }                          | }\n");
}

// The end of a block stands beside the label of its end.
TEST(TwoColumns, ShowBranchesBesideTheirLabels) {
  EXPECT_EQ(
      Columns("int v;\nvoid t0(int n) {\n  if (n) {\n    v = 1;\n  } else {\n    v = 2;\n  }\n"
              "  v++;\n}\n",
              69),
      "1  int v;                          | int v;\n"
      "2  void t0(int n) {                | void t0(int n) {\n"
      "                                   |   int tmp1;\n"
      "3    if (n) {                      |   tmp1 = !n;\n"
      "                                   |   if (tmp1) goto lbl_if_3_else;\n"
      "4      v = 1;                      |   v = 1;\n"
      "                                   |   goto lbl_if_3_end;\n"
      "5    } else {                      | lbl_if_3_else:\n"
      "6      v = 2;                      |   v = 2;\n"
      "7    }                             | lbl_if_3_end:\n"
      "8    v++;                          |   v = v + 1;\n"
      "9  }                               | }\n");
}

// What is declared elsewhere in C is shown where it became something, in the lowered order.
TEST(TwoColumns, ShowCalledFunctionsWhereTheyAreCalled) {
  EXPECT_EQ(Columns("//@ races: none\nint v;\nint f(int a) {\n  return a * v;\n}\n"
                    "static int unused(void) { return 1; }\nvoid t0() {\n  static int k;\n"
                    "  k = f(3) +\n      1;\n}\nvoid t1() { v = 2; }\n",
                    70),
            " 1  //@ races: none                 | //@ races: none\n"
            " 2  int v;                          | int v;\n"
            " 8    static int k;                 | int t0_k;\n"
            " 6  static int unused(void) { retu\\\n"
            "    rn 1; }\n"
            " 7  void t0() {                     | void t0() {\n"
            "                                    |   int tmp1;\n"
            " 3  int f(int a) {\n"
            " 4    return a * v;                 |   tmp1 = 3 * v;\n"
            " 5  }\n"
            " 9    k = f(3) +                    |   t0_k = tmp1 + 1;\n"
            "10        1;\n"
            "11  }                               | }\n"
            "12  void t1() { v = 2; }            | void t1() {\n"
            "                                    |   v = 2;\n"
            "                                    | }\n");
}

TEST(TwoColumns, NameIncludedFiles) {
  EXPECT_EQ(Columns("#include \"f.h\"\nvoid t0() { step(); }\n", 50,
                    {{"f.h", "#pragma once\nint n;\nvoid step() {\n  n++;\n}\n"}}),
            "   f.h:\n"
            "2  int n;                 | int n;\n"
            "   p.c:\n"
            "1  #include \"f.h\"\n"
            "2  void t0() { step(); }  | void t0() {\n"
            "   f.h:\n"
            "4    n++;                 |   n = n + 1;\n"
            "   p.c:\n"
            "2  void t0() { step(); }  | }\n");
}

// A Chinese character takes two columns, in UTF-8 and in GBK.
TEST(TwoColumns, GoOnInTheNextRowWhereALineIsTooLong) {
  const std::string rows =
      "1  int v;  // 一二三 \\ | int v;\n"
      "   四五六七八九十\n"
      "2  void t0() {         | void t0() {\n"
      "3          v = 1;      |   v = 1;\n"
      "4  }                   | }\n";
  const std::string behind = "\nvoid t0() {\n\tv = 1;\n}\n";
  EXPECT_EQ(Columns("int v;  // 一二三四五六七八九十" + behind, 45), rows);
  EXPECT_EQ(Columns("int v;  // \xD2\xBB\xB6\xFE\xC8\xFD\xCB\xC4\xCE\xE5\xC1\xF9\xC6\xDF\xB0\xCB"
                    "\xBE\xC5\xCA\xAE" +
                        behind,
                    45),
            rows);
}

TEST(TwoColumns, DimWhatIsNotNew) {
  const Lowering lowering =
      LowerText("p.c", "int v = 1;\nvoid t0() {}\n", {}, {.comments = false}, NoFiles());
  const std::string text = FormatTwoColumns(lowering, {.width = 60, .color = true});
  EXPECT_THAT(text, testing::HasSubstr("\x1b[2m1\x1b[0m  int v = 1;"));
  EXPECT_THAT(text, testing::HasSubstr("\x1b[2m1\x1b[0m  \x1b[2mint v = 1;\x1b[0m"));
}

}  // namespace
}  // namespace oncard::compiler
