// Output that cannot be written is an error of its own; and the effects of names and comments on
// output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kOncard = ONCARD_BUILD_DIR "/bin/oncard";
constexpr const char* kProgram = "int sum;\nint add() { sum = sum + 1; return sum; }\n";
constexpr const char* kUseless = "int sum\n";

using Words = std::vector<std::string>;

ProcessResult RunInShell(const std::string& line, const Words& arguments,
                         const std::string& folder) {
  Words command = {"/bin/sh", "-c", line, kOncard};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunProgram(command, folder);
}

void PrepareFolder(const ScratchFolder& folder) {
  folder.Write("p.c", kProgram);
  folder.Write("bad.c", kUseless);
  folder.Write("p.toml", "program = \"p.c\"\n[[thread]]\nthread = 0\nfunction = \"add\"\n");
  ASSERT_EQ(RunOncard({"build", "p.c"}, folder.path()).exit_code, 0);
  ASSERT_EQ(RunOncard({"run", "p.toml", "--record", "p.schedule"}, folder.path()).exit_code, 0);
}

struct CommandLine {
  Words words;
};

void PrintTo(const CommandLine& line, std::ostream* stream) {
  for (const std::string& word : line.words) *stream << word << ' ';
}

class FullOutputTest : public testing::TestWithParam<CommandLine> {};

TEST_P(FullOutputTest, IsReported) {
  const ScratchFolder folder;
  ASSERT_NO_FATAL_FAILURE(PrepareFolder(folder));
  const ProcessResult result =
      RunInShell("exec \"$0\" \"$@\" > /dev/full", GetParam().words, folder.path());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("oncard: cannot write to standard output"));
}

INSTANTIATE_TEST_SUITE_P(
    LostOutput, FullOutputTest,
    testing::Values(CommandLine{{"check", "--diagnostics=json", "bad.c"}},
                    CommandLine{{"check", "--diagnostics=sarif", "p.c"}}, CommandLine{{"explain"}},
                    CommandLine{{"explain", "MP027"}}, CommandLine{{"run", "p.toml"}},
                    CommandLine{{"run", "p.c", "--format=json"}}, CommandLine{{"test", "p.toml"}},
                    CommandLine{{"test", "p.toml", "--format=tap"}},
                    CommandLine{{"replay", "p.schedule"}}, CommandLine{{"explore", "p.toml"}},
                    CommandLine{{"explore", "p.toml", "--format=json"}},
                    CommandLine{{"dump", "p.bin"}}, CommandLine{{"dump", "--json", "p.bin"}},
                    CommandLine{{"verify", "--format=json", "p.bin"}}, CommandLine{{"doctor"}},
                    CommandLine{{"doctor", "--commands"}}, CommandLine{{"completion", "bash"}},
                    CommandLine{{"man"}}, CommandLine{{"schema"}}, CommandLine{{"--help"}},
                    CommandLine{{"run", "--help"}}, CommandLine{{"--version"}}));

TEST(LostOutput, ClosedOutputIsReported) {
  const ScratchFolder folder;
  const ProcessResult result = RunInShell("exec \"$0\" doctor >&-", {}, folder.path());
  EXPECT_EQ(result.exit_code, 3);
}

TEST(LostOutput, LostDiagnosticsAreNoSuccess) {
  const ScratchFolder folder;
  folder.Write("p.c", "int t0() { int a; a = 1.5; return a; }\n");
  EXPECT_EQ(RunInShell("exec \"$0\" check p.c 2> /dev/full", {}, folder.path()).exit_code, 3);
}

// A link with the ending that the option needs, to a device that accepts no data.
class FullFileTest : public testing::TestWithParam<CommandLine> {};

TEST_P(FullFileTest, IsReported) {
  const ScratchFolder folder;
  ASSERT_NO_FATAL_FAILURE(PrepareFolder(folder));
  Words words = GetParam().words;
  std::filesystem::create_symlink("/dev/full", std::filesystem::path(folder.path()) / words.back());
  const ProcessResult result = RunOncard(words, folder.path());
  EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot write '" + words.back()));
}

INSTANTIATE_TEST_SUITE_P(
    LostOutput, FullFileTest,
    testing::Values(CommandLine{{"run", "p.toml", "--record", "full.schedule"}},
                    CommandLine{{"run", "p.toml", "--trace", "full.csv"}},
                    CommandLine{{"run", "p.toml", "--trace", "full.vcd"}},
                    CommandLine{{"run", "p.toml", "--plot", "full.svg"}},
                    CommandLine{{"explore", "p.toml", "--report", "full.html"}}));

TEST(LostOutput, ObjectThatCannotBeWrittenIsReported) {
  for (const char* name : {"p.bin", "p.ini"}) {
    const ScratchFolder folder;
    folder.Write("p.c", kProgram);
    std::filesystem::create_symlink("/dev/full", std::filesystem::path(folder.path()) / name);
    const ProcessResult result = RunOncard({"build", "p.c"}, folder.path());
    EXPECT_EQ(result.exit_code, 3) << name;
    EXPECT_THAT(result.err, HasSubstr(name));
  }
}

TEST(LostOutput, FileLimitOfTheShellIsReported) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the run-time library of ThreadSanitizer writes a file before main()";
#endif
  const ScratchFolder folder;
  folder.Write("p.c", kProgram);
  const ProcessResult result =
      RunInShell("ulimit -f 0; exec \"$0\" build p.c 2> /dev/null", {}, folder.path());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_FALSE(folder.Has("p.bin"));
}

// --- What names may do ---------------------------------------------------------------------------

TEST(HostileNames, DoNotReachTheTerminalRaw) {
  const ScratchFolder folder;
  const std::string name = "\x1B[2Jx\n.c";
  folder.Write(name, "int a\n");
  for (const Words& words :
       {Words{"check", name}, Words{"check", name + "missing"}, Words{"run", name + ".toml"},
        Words{"verify", name + ".bin"}, Words{"run", "x.c", "--set", name}, Words{name},
        Words{"run", "--" + name}}) {
    const ProcessResult result = RunOncard(words, folder.path());
    EXPECT_THAT(result.out + result.err, Not(HasSubstr("\x1B")))
        << words.front() << ": " << result.out << result.err;
  }
}

TEST(HostileNames, LeaveTheObjectWhole) {
  const ScratchFolder folder;
  folder.Write("x\n[oncard]\x1B.c", kProgram);
  ASSERT_EQ(RunOncard({"build", "x\n[oncard]\x1B.c"}, folder.path()).exit_code, 0);
  const ProcessResult result = RunOncard({"verify", "x\n[oncard]\x1B.bin"}, folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(GbkText, IsReplacedInEveryJson) {
  const ScratchFolder folder;
  // A comment, a name and an operand that are not valid UTF-8.
  folder.Write("p.c", "int x;\nint a() { x = 1; /* \xD6\xE1 */ }\nint b() { x = 2; }\n");
  folder.Write("p.toml",
               "program = \"p.c\"\ntitle = \"t\"\nraces = \"none\"\n[[thread]]\nthread = 0\n"
               "function = \"a\"\n[[thread]]\nthread = 1\nfunction = \"b\"\n");
  for (const Words& words : {Words{"explore", "p.toml", "--report", "p.html"},
                             Words{"explore", "p.toml", "--search", "p.search"},
                             Words{"explore", "p.toml", "--format=json"}}) {
    const ProcessResult result = RunOncard(words, folder.path());
    EXPECT_THAT(result.err, Not(HasSubstr("internal error")));
    EXPECT_NE(result.exit_code, 4);
  }
}

}  // namespace
}  // namespace oncard::tools
