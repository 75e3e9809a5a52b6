// Programs of csmith that the card can have must compute with oncard what they compute when
// compiled by gcc, plainly, optimised and with its sanitizer for undefined behaviour.
// ONCARD_CSMITH_PROGRAMS=2000 tests so many instead of the default number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "compiler/lowering/lowering.h"
#include "csmith_program.h"
#include "machine_run.h"
#include "oracle.h"
#include "structured_run.h"
#include "tests/base/random_cases.h"
#include "tests/compiler/memory_files.h"

namespace oncard::differential {
namespace {

constexpr size_t kUsualPrograms = 12;
constexpr size_t kProgramsPerBatch = 250;

constexpr const char* kCompilations[] = {
    "", "-O2", "-fsanitize=undefined -fno-sanitize=shift-base -fno-sanitize-recover=all"};

// With the passes, with all slots shared that can be, and without the passes.
constexpr compiler::LoweringOptions kLowerings[] = {{}, {.slots = 0}, {.optimize = false}};

size_t ProgramCount() {
  const char* wanted = std::getenv("ONCARD_CSMITH_PROGRAMS");
  return wanted != nullptr ? std::strtoul(wanted, nullptr, 10) : kUsualPrograms;
}

// Without the passes, a program takes so many times the statements at most.
constexpr int64_t kSlower = 20;

// What a card has too little of for some programs.
bool IsLimit(const compiler::Diagnostic& diagnostic) {
  for (const std::string_view limit : {"lowered-labels", "lowered-too-large", "lowered-too-long"}) {
    if (diagnostic.info->slug == limit) return true;
  }
  return false;
}

struct Accepted {
  uint64_t seed = 0;
  std::string text;
  int64_t checksum = 0;
};

// The result of a program; none if it does not end within so many statements.
std::optional<int64_t> RunMain(const vm::Object& object, int64_t statements) {
  const Values values = RunFirstFunction(object, {std::string(kCsmithResult)}, statements);
  if (values.empty()) return std::nullopt;
  return static_cast<uint32_t>(values[1]);
}

class CsmithTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!HasCsmith()) GTEST_SKIP() << "csmith is not on this machine: install csmith";
    auto header = ReadFile(kCsmithHeader);
    ASSERT_TRUE(header.ok());
    files_["csmith.h"] = std::move(header).value();
  }

  // What a program computes with the passes and without them, if the card has room for it.
  std::optional<int64_t> Checksum(const std::string& text, uint64_t seed) {
    std::optional<int64_t> checksum;
    for (const compiler::LoweringOptions& options : kLowerings) {
      const bool optimize = options.optimize;
      const compiler::Lowering lowering =
          compiler::LowerText("csmith.c", text, {}, options, compiler::ReaderOf(files_));
      if (!lowering.object) {
        const bool limit = std::all_of(
            lowering.diagnostics.begin(), lowering.diagnostics.end(),
            [](const compiler::Diagnostic& diagnostic) {
              return diagnostic.info->severity != compiler::Severity::kError || IsLimit(diagnostic);
            });
        EXPECT_TRUE(limit) << "seed " << seed << ": refused "
                           << lowering.diagnostics.front().message.en;
        if (optimize) return std::nullopt;
        continue;
      }
      const auto computed = RunMain(*lowering.object, checksum ? kSlower * kEndless : kEndless);
      if (!checksum) {
        if (!computed) return std::nullopt;
        checksum = computed;
      }
      EXPECT_EQ(computed, checksum) << "seed " << seed << ", optimize " << optimize;
    }
    return checksum;
  }

  static std::string Folder() {
    return std::string(ONCARD_BUILD_DIR) + "/tests/differential/csmith";
  }

  void Compare(const std::vector<Accepted>& programs) const {
    std::vector<std::string> texts;
    for (const Accepted& program : programs) texts.push_back(program.text);
    const std::string text = CsmithOracleText(files_.at("csmith.h"), texts);
    for (const std::string compilation : kCompilations) {
      const auto oracle = RunOracle(text, "-x c -fwrapv " + compilation, Folder());
      ASSERT_TRUE(oracle.ok()) << oracle.error().message.en;
      ASSERT_EQ(oracle.value().size(), programs.size());
      for (size_t i = 0; i < programs.size(); ++i) {
        EXPECT_EQ(oracle.value()[i], Values{programs[i].checksum})
            << "seed " << programs[i].seed << ", gcc " << compilation;
      }
    }
  }

 private:
  compiler::MemoryFiles files_;
};

TEST_F(CsmithTest, ProgramsComputeWhatGccComputes) {
  const size_t count = RandomCases(ProgramCount());
  std::vector<Accepted> batch;
  size_t accepted = 0;
  uint64_t seed = 0;
  for (; accepted < count && !HasFailure(); ++seed) {
    const auto text = MakeCsmithProgram(seed, Folder());
    ASSERT_TRUE(text.ok()) << text.error().message.en;
    const auto checksum = Checksum(text.value(), seed);
    if (!checksum) continue;
    batch.push_back({seed, text.value(), *checksum});
    ++accepted;
    if (batch.size() < kProgramsPerBatch && accepted < count) continue;
    Compare(batch);
    batch.clear();
  }
  // Most programs fit the card and end.
  EXPECT_LE(seed, 10 + 3 * count);
}

}  // namespace
}  // namespace oncard::differential
