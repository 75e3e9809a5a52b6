// Properties of every program between text and machine: the same text gives the same bytes, files
// are read as they were written, layout and comments have no effect.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "machine_run.h"
#include "random_program.h"
#include "tests/base/random_cases.h"
#include "vm/object_reader.h"
#include "vm/object_writer.h"

namespace oncard::differential {
namespace {

constexpr uint64_t kFirstSeed = 2'000'000;

uint64_t LastSeed() { return kFirstSeed + RandomCases(uint64_t{500}) - 1; }

vm::Object Compiled(const std::string& text, vm::DoubleFormat format) {
  compiler::Compilation compilation = CompileSource(text, format);
  EXPECT_TRUE(compilation.ok()) << ErrorsOf(compilation) << text;
  return compilation.ok() ? *compilation.object : vm::Object{};
}

// The same tokens with other white space, comments and line ends.
std::string AnotherLayout(const std::string& text, uint64_t seed) {
  // Each begins with white space, because it may follow a division sign.
  static const char* const kGaps[] = {"  ", "\t",           "\r\n", " /* between; */ ",
                                      " ",  " // rest \n ", "\n\n", " /* two\r\nlines */"};
  std::mt19937_64 random(seed);
  std::string other;
  bool directive = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (i == 0 || text[i - 1] == '\n') directive = c == '#';
    if (c == '\n') {
      other += random() % 2 == 0 ? "\r\n" : " // end of line\n";
    } else if (directive || text.compare(i, 2, "/*") == 0 || c == '*') {
      other += c;
    } else if (c == ' ') {
      other += kGaps[random() % std::size(kGaps)];
    } else if ((c == ';' || c == '[' || c == ']' || c == ')') && random() % 3 == 0) {
      other += fmt::format(" {}\t", c);
    } else {
      other += c;
    }
  }
  return other;
}

TEST(PipelineTest, TheSameTextGivesTheSameBytes) {
  for (uint64_t seed = kFirstSeed; seed <= LastSeed(); ++seed) {
    const RandomProgram program = MakeProgram(seed, Sharing::kSequential);
    const std::string text = SourceText(program);
    const vm::ObjectFiles first = vm::WriteObject(Compiled(text, program.format), false);
    const vm::ObjectFiles second = vm::WriteObject(Compiled(text, program.format), false);
    ASSERT_EQ(first.bin, second.bin) << "seed " << seed << '\n' << text;
    ASSERT_EQ(first.ini, second.ini) << "seed " << seed << '\n' << text;
  }
}

TEST(PipelineTest, LayoutAndCommentsMeanNothing) {
  for (uint64_t seed = kFirstSeed; seed <= LastSeed(); ++seed) {
    const RandomProgram program = MakeProgram(seed, Sharing::kSequential);
    const std::string text = SourceText(program);
    const std::string other = AnotherLayout(text, seed);
    ASSERT_EQ(vm::WriteObject(Compiled(text, program.format), true).bin,
              vm::WriteObject(Compiled(other, program.format), true).bin)
        << "seed " << seed << '\n'
        << other;
  }
}

TEST(PipelineTest, FilesGiveBackTheProgram) {
  for (uint64_t seed = kFirstSeed; seed <= LastSeed(); ++seed) {
    const RandomProgram program = MakeProgram(seed, Sharing::kInterleaved);
    const std::string text = SourceText(program);
    const vm::Object object = Compiled(text, program.format);
    const Result<vm::Object> read = vm::ReadObject(vm::WriteObject(object, false));
    ASSERT_TRUE(read.ok()) << read.error().message.en << "\nseed " << seed << '\n' << text;
    const auto direct = vm::LinkObject(object, NoCommands());
    const auto linked = vm::LinkObject(read.value(), NoCommands());
    ASSERT_TRUE(direct.ok() && linked.ok()) << "seed " << seed << '\n' << text;
    ASSERT_EQ(linked.value()->hash, direct.value()->hash) << "seed " << seed << '\n' << text;
    MachineRun expected(program, direct.value());
    MachineRun run(program, linked.value());
    ASSERT_TRUE(expected.RunInterleaved({})) << "seed " << seed << '\n' << text;
    ASSERT_TRUE(run.RunInterleaved({})) << "seed " << seed << '\n' << text;
    ASSERT_EQ(run.FinalValues(), expected.FinalValues()) << "seed " << seed << '\n' << text;
    ASSERT_EQ(run.Hash(), expected.Hash()) << "seed " << seed << '\n' << text;
  }
}

}  // namespace
}  // namespace oncard::differential
