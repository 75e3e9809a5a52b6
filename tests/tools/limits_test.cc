// Every limit of base/limits.h: documented in docs/limits.md, accepted at the limit, refused one
// beyond it. The limits of the language itself are tested by tests/compiler/limits_test.cc.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/limits.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string Times(size_t count, const std::string& piece) {
  std::string text;
  text.reserve(count * piece.size());
  for (size_t i = 0; i < count; ++i) text += piece;
  return text;
}

struct PageRow {
  const char* what;
  size_t bound;
};

class LimitPageTest : public testing::TestWithParam<PageRow> {};

TEST_P(LimitPageTest, SaysTheBound) {
  const std::string page = ReadFile(ONCARD_SOURCE_DIR "/docs/limits.md").value();
  const std::string row = fmt::format("| {} | {} |", GetParam().what, GetParam().bound);
  EXPECT_THAT(page, HasSubstr(row));
}

INSTANTIATE_TEST_SUITE_P(
    Limits, LimitPageTest,
    testing::Values(PageRow{"bytes of a program and all it includes", kSourceKind.bytes_max},
                    PageRow{"tokens of a program and all it includes", kTokenMax},
                    PageRow{"bytes of what a program of structured C becomes", kLoweredBytesMax},
                    PageRow{"bytes of a `.bin` or `.ini`", kObjectKind.bytes_max},
                    PageRow{"bytes of a scenario", kScenarioKind.bytes_max},
                    PageRow{"keys and tables of a scenario", kTomlKeyMax},
                    PageRow{"brackets within brackets", kTomlDepthMax},
                    PageRow{"parts of a dotted key", kTomlKeyPartMax},
                    PageRow{"bytes of a schedule", kScheduleKind.bytes_max},
                    PageRow{"bytes of a search file", kSearchKind.bytes_max},
                    PageRow{"bytes of a request of a session", kRequestKind.bytes_max},
                    PageRow{"keys of one object in a request of a session or in a line of a record "
                            "of host calls",
                            kJsonKeysMax},
                    PageRow{"bytes of a `.cfg`", kConfigKind.bytes_max},
                    PageRow{"bytes of `Gecat.eni`", kEniKind.bytes_max}));

struct LargeFile {
  const char* name;
  FileKind kind;
  std::vector<std::string> command;
};

void PrintTo(const LargeFile& file, std::ostream* stream) { *stream << file.name; }

class LargeFileTest : public testing::TestWithParam<LargeFile> {};

// The file is sparse; reading all of it would take its full size in memory.
TEST_P(LargeFileTest, IsRefusedUnread) {
  const ScratchFolder folder;
  folder.Write("p.ini", "");
  const std::string path = folder.Write(GetParam().name, "");
  ASSERT_EQ(::truncate(path.c_str(), static_cast<off_t>(GetParam().kind.bytes_max + 1)), 0);
  std::vector<std::string> command = GetParam().command;
  command.push_back(path);
  const ProcessResult result = RunOncard(command, folder.path());
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.out + result.err,
              HasSubstr(fmt::format("has at most {}", GetParam().kind.bytes_max)))
      << result.out << result.err;
}

INSTANTIATE_TEST_SUITE_P(Limits, LargeFileTest,
                         testing::Values(LargeFile{"p.c", kSourceKind, {"check"}},
                                         LargeFile{"p.c", kSourceKind, {"run"}},
                                         LargeFile{"p.bin", kObjectKind, {"verify"}},
                                         LargeFile{"p.toml", kScenarioKind, {"run"}},
                                         LargeFile{"p.schedule", kScheduleKind, {"replay"}},
                                         LargeFile{
                                             "p.search", kSearchKind, {"explore", "--merge"}}));

struct NeverEnding {
  std::vector<std::string> command;
  std::string said = "not a regular file";
};

void PrintTo(const NeverEnding& row, std::ostream* stream) { *stream << row.command.front(); }

class NeverEndingTest : public testing::TestWithParam<NeverEnding> {};

TEST_P(NeverEndingTest, InputIsRefused) {
  const ScratchFolder folder;
  folder.Write("p.c", "#include \"/dev/zero\"\nint t0() { return 0; }\n");
  folder.Write("q.c", "#include \"pipe\"\nint t0() { return 0; }\n");
  folder.Write("sub/f", "");
  folder.Write("r.c", "#include \"sub\"\nint t0() { return 0; }\n");
  ASSERT_EQ(::mkfifo((folder.path() + "/pipe").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("/dev/zero", (folder.path() + "/z.toml").c_str()), 0);
  ASSERT_EQ(::symlink("/dev/zero", (folder.path() + "/z.bin").c_str()), 0);
  const ProcessResult result = RunOncard(GetParam().command, folder.path());
  EXPECT_NE(result.exit_code, 0);
  const std::string all = result.out + result.err;
  const size_t said = all.find(GetParam().said);
  EXPECT_NE(said, std::string::npos) << all;
  EXPECT_EQ(all.find(GetParam().said, said + 1), std::string::npos) << all;
}

INSTANTIATE_TEST_SUITE_P(
    Limits, NeverEndingTest,
    testing::Values(NeverEnding{{"check", "p.c"}}, NeverEnding{{"check", "q.c"}},
                    NeverEnding{{"check", "--fix", "p.c"}}, NeverEnding{{"check", "pipe"}},
                    NeverEnding{{"check", "r.c"}, "it is a folder"},
                    NeverEnding{{"check", "sub"}, "it is a folder"}, NeverEnding{{"build", "p.c"}},
                    NeverEnding{{"run", "p.c"}}, NeverEnding{{"check", "/dev/zero"}},
                    NeverEnding{{"run", "z.toml"}}, NeverEnding{{"test", "z.toml"}},
                    NeverEnding{{"verify", "z.bin"}}, NeverEnding{{"replay", "/dev/zero"}},
                    NeverEnding{{"replay", "pipe"}},
                    NeverEnding{{"explore", "--merge", "/dev/zero"}}));

TEST(SourceLimits, CountAllIncludedFilesTogether) {
  const ScratchFolder folder;
  const std::string program = "#include \"a.h\"\nint t0() { return 0; }\n";
  folder.Write("p.c", program);
  const size_t rest = kSourceKind.bytes_max - program.size();
  folder.Write("a.h", std::string(rest, '\n'));
  EXPECT_EQ(RunOncard({"check", "p.c"}, folder.path()).exit_code, 0);
  folder.Write("a.h", std::string(rest + 1, '\n'));
  const ProcessResult past = RunOncard({"check", "p.c"}, folder.path());
  EXPECT_EQ(past.exit_code, 1);
  EXPECT_THAT(past.err, HasSubstr(fmt::format("more than {} bytes", kSourceKind.bytes_max)));
}

TEST(SourceLimits, Tokens) {
  const ScratchFolder folder;
  const std::string end = "int t0() { return 0; }\n";
  constexpr size_t kOwn = 9;
  const std::string said = "more than 1048576 tokens";
  folder.Write("p.c", Times(kTokenMax - kOwn, ";") + end);
  EXPECT_THAT(RunOncard({"check", "p.c"}, folder.path()).err, Not(HasSubstr(said)));
  folder.Write("p.c", Times(kTokenMax - kOwn + 1, ";") + end);
  const ProcessResult past = RunOncard({"check", "p.c"}, folder.path());
  EXPECT_EQ(past.exit_code, 1);
  EXPECT_NE(past.err.find(said), std::string::npos) << past.err.substr(0, 1000);
}

struct TomlBound {
  const char* name;
  std::string at;
  std::string past;
  std::string said;
};

void PrintTo(const TomlBound& bound, std::ostream* stream) { *stream << bound.name; }

class TomlBoundTest : public testing::TestWithParam<TomlBound> {};

TEST_P(TomlBoundTest, IsJudgedBeforeTheTextIsParsed) {
  const ScratchFolder folder;
  folder.Write("at.toml", GetParam().at);
  folder.Write("past.toml", GetParam().past);
  const ProcessResult at = RunOncard({"run", "at.toml"}, folder.path());
  EXPECT_EQ(at.err.find(GetParam().said), std::string::npos) << at.err.substr(0, 1000);
  const ProcessResult past = RunOncard({"run", "past.toml"}, folder.path());
  EXPECT_EQ(past.exit_code, 3);
  EXPECT_NE(past.err.find(GetParam().said), std::string::npos) << past.err.substr(0, 1000);
}

INSTANTIATE_TEST_SUITE_P(
    Limits, TomlBoundTest,
    testing::Values(
        TomlBound{"depth", "a = " + Times(kTomlDepthMax, "[") + Times(kTomlDepthMax, "]") + "\n",
                  "a = " + Times(kTomlDepthMax + 1, "[") + Times(kTomlDepthMax + 1, "]") + "\n",
                  "past.toml:1:37: brackets are nested at most 32 deep"},
        TomlBound{"key_parts", "a" + Times(kTomlKeyPartMax - 1, ".a") + " = 1\n",
                  "a" + Times(kTomlKeyPartMax, ".a") + " = 1\n",
                  "past.toml:1:64: a key has at most 32 parts"},
        TomlBound{"keys", Times(kTomlKeyMax, "[[a]]\n"), Times(kTomlKeyMax + 1, "[[a]]\n"),
                  "past.toml:100001:1: a file has at most 100000 keys"},
        // A letter for which toml++ 3.3 has undefined behaviour.
        TomlBound{"letters", "\"\xD1\x9C\" = 1 # \xD1\x9C\n", "\xD1\x9C = 1\n",
                  "past.toml:1:1: non-ASCII characters are allowed only in strings and comments"}));

}  // namespace
}  // namespace oncard::tools
