// Comments and empty lines of C in the lowered program: where they stand, and that they stay
// comments. The programs say what they are about.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "compiler/lowering/lowering.h"
#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

std::string TextOf(const std::string& program, const MemoryFiles& files = {}) {
  const Lowering lowering = LowerText("p.c", program, {}, {}, ReaderOf(files));
  EXPECT_TRUE(lowering.text.has_value()) << program;
  if (!lowering.text) return {};
  const SourceFile text("lowered.c", *lowering.text);
  EXPECT_EQ(static_cast<size_t>(text.line_count()), lowering.origins.size()) << *lowering.text;
  return *lowering.text;
}

struct Kept {
  std::string program;
  std::string lowered;
};

void ExpectLowered(const std::vector<Kept>& rows) {
  for (const Kept& row : rows) EXPECT_EQ(TextOf(row.program), row.lowered) << row.program;
}

TEST(KeptComments, StandAboveAndBesideGlobals) {
  ExpectLowered({
      {"// Of a part.\nint v;  // in pulses\n\n\n/* of all */\nint w, u; /* both\n  are */\nvoid "
       "t0() {}\n",
       "// Of a part.\nint v;  // in pulses\n\n/* of all */\nint w;  /* both are */\nint u;\n\n"
       "void t0() {\n}\n"},
      // Variables of a structure have those of the structure once.
      {"struct { int x; int y; } p;  // where\nvoid t0() {}\n",
       "int p_x;  // where\nint p_y;\n\nvoid t0() {\n}\n"},
      // So has a constant that is printed.
      {"int v;\n\n// The feeder.\n#define AXIS 1  // of two\n#define OTHER 2  // of two\n"
       "void t0() { GT_AxisOn(AXIS); }\n",
       "// The feeder.\n#define AXIS 1  // of two\n\nint v;\n\nvoid t0() {\n"
       "  // 6: void t0() { GT_AxisOn(AXIS); }\n  GT_AxisOn(AXIS);\n}\n"},
  });
}

TEST(KeptComments, OfThingsThatAreLeftOutGoWithThem) {
  ExpectLowered({
      // An empty line parts what is about more than one thing.
      {"int v;\n\n// Sizes.\n\n// Of a row.\ntypedef int row[4];  // wide\n// A prototype.\nint "
       "f(int);\n"
       "row w;\nvoid t0() {}\n",
       "int v;\n\n// Sizes.\n\nint w[4];\n\nvoid t0() {\n}\n"},
      {"int v;\nvoid t0() {\n  // never\n  if (0) {\n    // nor this\n    v = 1;  // nor that\n  "
       "}\n"
       "  // always\n  v = 2;\n}\n",
       "int v;\n\nvoid t0() {\n  // always\n  // 9: v = 2;\n  v = 2;\n}\n"},
      {"int v;\n#if 0\n// skipped\n#endif  // 0\nvoid t0() {\n#ifdef A  // with A\n  // "
       "no\n#endif\n}\n",
       "int v;\n\nvoid t0() {\n}\n"},
  });
}

TEST(KeptComments, TheFirstOneIsTheTitle) {
  ExpectLowered({
      {"//@ structured\n// A program\n// of mine.\n//@ races: none\nint v;\nvoid t0() {}\n",
       "// A program\n// of mine.\n\n//@ races: none\n\nint v;\n\nvoid t0() {\n}\n"},
      {"/* Mine. */\n#define STEPS 4\nint v;\nvoid t0() {}\n",
       "/* Mine. */\n\nint v;\n\nvoid t0() {\n}\n"},
      {"// About v.\nint v;\nvoid t0() {}\n// the end\n",
       "// About v.\nint v;\n\nvoid t0() {\n}\n\n// the end\n"},
  });
}

TEST(KeptComments, StandAboveAndBesideStatements) {
  ExpectLowered({
      {"int v;\n// Runs.\nvoid t0(int n)  // by the host\n{\n  int k;  // counts\n\n  // "
       "first\n\n\n"
       "  v = n;  // set\n  /* second\n   *  of two */\n  v++; /* more\n    and more */\n  // "
       "last\n}  // t0\n",
       "int v;\n\n// Runs.\nvoid t0(int n) {  // by the host\n  // 5: int k;  // counts\n\n  // "
       "first\n\n"
       "  // 10: v = n;  // set\n  v = n;\n  /* second\n   *  of two */\n"
       "  // 13: v++; /* more\n  // and more */\n  v = v + 1;\n  // last\n}  // t0\n"},
      // A line of C has its comment once.
      {"int v;\nvoid t0() {\n  while (v > 0 &&  // one\n         v < 9)    // two\n    v--;\n}\n",
       "int v;\n\nvoid t0() {\n  int tmp1;\n\n  // 3: while (v > 0 &&  // one\n"
       "  // 4: v < 9)    // two\nlbl_while_3:\n  tmp1 = v <= 0;\n  if (tmp1) goto "
       "lbl_while_3_end;\n"
       "  tmp1 = v >= 9;\n  if (tmp1) goto lbl_while_3_end;\n  // 5: v--;\n  v = v - 1;\n"
       "  // 3: v > 0 && ...\n  goto lbl_while_3;\nlbl_while_3_end:\n  return;\n}\n"},
      {"int v = 3;  // begins\nvoid t0() {  // runs\n  v++;\n}\n",
       "int v;  // begins\nint oncard_ready;\nint oncard_entered;\nint oncard_written;\n"
       "int oncard_left;\n\nvoid t0() {  // runs\n  int tmp1;\n\n  // 2: void t0() {\n"
       "  if (oncard_ready) goto lbl_start;\n  oncard_entered = oncard_entered + 1;\n"
       "  if (oncard_written) goto lbl_start_written;\n  // 1: int v = 3;\n  v = 3;\n"
       "  // 2: void t0()\n  oncard_written = 1;\nlbl_start_written:\n"
       "  oncard_left = oncard_left + 1;\nlbl_start_wait:\n  tmp1 = oncard_entered != "
       "oncard_left;\n"
       "  if (tmp1) goto lbl_start_wait;\n  oncard_ready = 1;\nlbl_start:\n  // 3: v++;\n"
       "  v = v + 1;\n}\n"},
  });
}

TEST(KeptComments, StayInTheirBlocks) {
  ExpectLowered({
      {"int v;\nvoid t0(int n) {\n  if (n) {\n    v = 1;\n    // enough\n  }\n  // otherwise\n"
       "  else {  // less\n    v = 2;\n  }\n\n  v++;\n}\n",
       "int v;\n\nvoid t0(int n) {\n  int tmp1;\n\n  // 3: if (n) {\n  tmp1 = !n;\n"
       "  if (tmp1) goto lbl_if_3_else;\n  // 4: v = 1;\n  v = 1;\n  // enough\n"
       "  goto lbl_if_3_end;\nlbl_if_3_else:\n  // otherwise\n  // 8: else {  // less\n"
       "  // 9: v = 2;\n  v = 2;\nlbl_if_3_end:\n\n  // 12: v++;\n  v = v + 1;\n}\n"},
      {"int v;\nvoid t0(int n) {\n  switch (n) {\n    // the first\n    case 1 ... 4:  // of many\n"
       "      v = 1;\n      break;  // out\n\n    // others\n    default:\n      v = 2;\n  }\n}\n",
       "int v;\n\nvoid t0(int n) {\n  int tmp1;\n\n  // 3: switch (n) {\n  tmp1 = n < 1;\n"
       "  if (tmp1) goto lbl_switch_3_default;\n  tmp1 = n > 4;\n"
       "  if (tmp1) goto lbl_switch_3_default;\n  // the first\n"
       "  // 5: case 1 ... 4:  // of many\n  // 6: v = 1;\n  v = 1;\n  // 7: break;  // out\n"
       "  goto lbl_switch_3_end;\n\n  // others\nlbl_switch_3_default:\n  // 11: v = 2;\n  v = 2;\n"
       "lbl_switch_3_end:\n  return;\n}\n"},
      {"int v;\nvoid t0() {\n  // why\n  //@ assert: v > 0\n  // what\n  v = 2;\n  if (v) {\n"
       "    // nothing to do\n    return;\n  }\n  while (v) { /* wait */ }\n}\n",
       "int v;\n\nvoid t0() {\n  int tmp1;\n\n  // why\n  //@ assert: v > 0\n  // what\n  // 6: v "
       "= 2;\n"
       "  v = 2;\n  // 7: if (v) {\n  tmp1 = !v;\n  if (tmp1) goto lbl_if_7_end;\n"
       "  // nothing to do\n  // 9: return;\n  return;\nlbl_if_7_end:\n"
       "  // 11: while (v) { /* wait */ }\nlbl_while_11:\n  tmp1 = v;\n  if (tmp1) goto "
       "lbl_while_11;\n}\n"},
  });
}

TEST(KeptComments, OfACalledFunctionStandOnceInEachFunctionOfTheCard) {
  const std::string called =
      "int v;\n// Adds.\nvoid add(int n) {  // to v\n  // now\n  v += n;  // that\n  // done\n}\n";
  const std::string body =
      "  // Adds.\n  // 3: void add(int n) {  // to v\n  // now\n  // 5: v += n;  // that\n"
      "  v = v + 1;\n  // done\n";
  EXPECT_EQ(TextOf(called + "// Ends.\nvoid t0() { add(1);\n add(2); }\nvoid t1() { add(1); }\n"),
            "int v;\n\n// Ends.\nvoid t0() {\n" + body + "  v = v + 2;\n}\n\nvoid t1() {\n" + body +
                "}\n");
}

TEST(KeptComments, OfAnIncludedFileStandWithItsDeclarations) {
  EXPECT_EQ(TextOf("#include \"f.h\"\nvoid t0() { step(); }\n",
                   {{"f.h",
                     "// A header.\n\n// Counts.\nint n;  // up\n//@ final: n == 7\n"
                     "void step() {\n  // on\n  n++;\n}\n// its end\n"}}),
            "// A header.\n\n// Counts.\nint n;  // up\n\nvoid t0() {\n  // on\n  // f.h:8: n++;\n"
            "  n = n + 1;\n}\n");
}

// What is printed must not become code, nor a line for tools.
TEST(KeptComments, StayComments) {
  ExpectLowered({
      {"int v; // one \\\n  two\nvoid t0() {\n  // three \\\n  four \\ \n\n  v = 1; // five \\\n  "
       "v = 2;\n}\n",
       "int v;  // one two\n\nvoid t0() {\n  // three\n  // four\n\n  // 7: v = 1; // five\n"
       "  // v = 2;\n  v = 1;\n}\n"},
      {"int v;\n/* a *\\\n/ b */\n/* c */ //@ final: v == 3\nvoid t0() {}\n",
       "int v;\n\n/* a *\n/ b */\n/* c */\n// @ final: v == 3\nvoid t0() {\n}\n"},
      {"int v;\n/* a\n   //@ final: v == 1 */\nvoid t0() {\n  // b \\\n  //@ assert: v > 0\n  v = "
       "1;\n}\n",
       "//@ final: v == 1 */\n\nint v;\n\n/* a\n*/\nvoid t0() {\n  // b\n  //@ assert: v > 0\n"
       "  // 7: v = 1;\n  v = 1;\n}\n"},
      // A character of GBK whose second byte is a backslash (0xD45C).
      {"int v;  // \xD4\\\nvoid t0() {\n  /* \xD4\\*/\n  // \xD4\\\n  v = 1;\n  // \xD4\\\\\n  v = "
       "2;\n}\n",
       "int v;  // \xD4\\\n\nvoid t0() {\n  /* \xD4\\*/\n  // \xD4\\\n  // 5: v = 1;\n  v = 1;\n"
       "  // \xD4\\\n  // v = 2;\n}\n"},
      {"int v;\r\n\r\n// a\r\nvoid t0() {\r\n  v = 1;\r\n\r\n  /* b\r\n   c */\r\n  v = "
       "2;\r\n}\r\n",
       "int v;\n\n// a\nvoid t0() {\n  // 5: v = 1;\n  v = 1;\n\n  /* b\n   c */\n  // 9: v = 2;\n"
       "  v = 2;\n}\n"},
  });
}

}  // namespace
}  // namespace oncard::compiler
