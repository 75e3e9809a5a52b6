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

TEST(KeptComments, OfAnIncludedFileStandWithItsDeclarations) {
  EXPECT_EQ(TextOf("#include \"f.h\"\nvoid t0() { step(); }\n",
                   {{"f.h",
                     "// A header.\n\n// Counts.\nint n;  // up\n//@ final: n == 7\n"
                     "void step() {\n  n++;\n}\n// its end\n"}}),
            "// A header.\n\n// Counts.\nint n;  // up\n\nvoid t0() {\n  // f.h:7: n++;\n"
            "  n = n + 1;\n}\n");
}

// What is printed must not become code, nor a line for tools.
TEST(KeptComments, StayComments) {
  ExpectLowered({
      {"int v;  // one \\\n  two\n/* a *\\\n/ b */\n/* c */ //@ final: v == 3\nvoid t0() {}\n",
       "int v;  // one two\n\n/* a *\n/ b */\n/* c */\n// @ final: v == 3\nvoid t0() {\n}\n"},
      {"int v;\n/* a\n   //@ final: v == 1 */\nvoid t0() {}\n",
       "//@ final: v == 1 */\n\nint v;\n\n/* a\n*/\nvoid t0() {\n}\n"},
      // A character of GBK whose second byte is a backslash (0xD45C).
      {"int v;  // \xD4\\\nvoid t0() {}\n", "int v;  // \xD4\\\n\nvoid t0() {\n}\n"},
  });
}

}  // namespace
}  // namespace oncard::compiler
