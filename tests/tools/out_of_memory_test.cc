// Commands that run out of memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

/// Three threads that count: far too many states for the memory limit set here.
constexpr const char* kLarge =
    "int x, y, z;\n"
    "void t0()\n{\nL:\n  x = x + 1;\n  goto L;\n}\n"
    "void t1()\n{\nL:\n  y = y + 1;\n  goto L;\n}\n"
    "void t2()\n{\nL:\n  z = z + 1;\n  goto L;\n}\n";

class OutOfMemory : public testing::Test {
 protected:
  OutOfMemory() {
    scratch_.Write("p.c", kLarge);
    std::string scenario = "program = \"p.c\"\nexplore = { engine = \"stateful\" }\n";
    for (const std::string thread : {"0", "1", "2"}) {
      scenario += "[[thread]]\nthread = " + thread + "\nfunction = \"t" + thread + "\"\n";
    }
    scratch_.Write("s.toml", scenario);
  }
  /// Runs a command with a limit of 150 MB.
  ProcessResult Run(const std::string& arguments) const {
    return RunProgram({"bash", "-c", "ulimit -v 150000; exec \"$0\" " + arguments,
                       ONCARD_BUILD_DIR "/bin/oncard"},
                      scratch_.path(), {"LANG=C", "LC_ALL=C"});
  }
  ScratchFolder scratch_;
};

TEST_F(OutOfMemory, ASearchSaysSoAndWhatNeedsLess) {
  const ProcessResult ended = Run("explore s.toml");
  EXPECT_EQ(ended.exit_code, 6) << ended.err;
  EXPECT_THAT(ended.err,
              HasSubstr("oncard: out of memory: 'explore' needs less with --max-states"));
}

TEST_F(OutOfMemory, ATestHasFailedAndTheOthersRun) {
  scratch_.Write("t.toml", "program = \"p.c\"\nuntil_ms = 1\n");
  const ProcessResult ended = Run("test s.toml t.toml");
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_THAT(ended.out + ended.err, HasSubstr("there was not enough memory for it"))
      << ended.out << ended.err;
  EXPECT_THAT(ended.out + ended.err, HasSubstr("t.toml")) << ended.out;
}

// 60 KB of source: the arguments of all levels together would take 1.5 GB.
TEST_F(OutOfMemory, NestedMacrosTakeNoneForEachLevel) {
  std::string program = "//@ structured\n#define F(a) a\nint v = ";
  for (int i = 0; i < 190; ++i) program += "F(";
  program += "1";
  for (int i = 0; i < 30'000; ++i) program += "+1";
  scratch_.Write("deep.c", program + std::string(190, ')') + ";\n");
  const ProcessResult ended = Run("check deep.c");
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_THAT(ended.out + ended.err,
              HasSubstr("expanding its macros takes more than 1048576 tokens"));
}

}  // namespace
}  // namespace oncard::tools
