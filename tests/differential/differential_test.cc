// Random programs must compute with oncard exactly what they compute when compiled by g++: every
// variable, every result, every fault, bit for bit. The programs are text, so this checks the
// lexer, the parser, the translation, the linker's fused instructions and the arithmetic together.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "machine_run.h"
#include "oracle.h"
#include "random_program.h"
#include "tests/base/random_cases.h"

namespace oncard::differential {
namespace {

constexpr int kBatches = 8;
constexpr int kProgramsPerBatch = 250;
constexpr int kInterleavedPrograms = 208;
constexpr int kInterleavedSeed = 1'000'000;

std::string Folder(const std::string& name) {
  return std::string(ONCARD_BUILD_DIR) + "/tests/differential/" + name;
}

// Describes the difference; empty if there is none.
std::string Difference(const RandomProgram& program, const Values& expected,
                       const Values& computed) {
  const std::vector<std::string> names = ValueNames(program);
  if (expected.size() != names.size() || computed.size() != names.size()) {
    return fmt::format("{} values expected, {} from g++, {} computed\n", names.size(),
                       expected.size(), computed.size());
  }
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (expected[i] == computed[i]) continue;
    text += fmt::format("{} is {}, g++ has {}\n", names[i], computed[i], expected[i]);
  }
  return text;
}

std::string Listing(const RandomProgram& program) {
  return fmt::format("seed {}, double={}\n{}", program.seed,
                     program.format == vm::DoubleFormat::k32_16 ? "32.16" : "16.16",
                     SourceText(program));
}

class DifferentialTest : public testing::TestWithParam<int> {};

TEST_P(DifferentialTest, ProgramsComputeWhatGccComputes) {
  std::vector<RandomProgram> programs;
  for (int i = 0; i < kProgramsPerBatch; ++i) {
    programs.push_back(MakeProgram(static_cast<uint64_t>(GetParam() * kProgramsPerBatch + i),
                                   Sharing::kSequential));
  }
  const auto oracle = RunOracle(programs, {}, Folder(fmt::format("batch_{}", GetParam())));
  ASSERT_TRUE(oracle.ok()) << oracle.error().message.en;
  ASSERT_EQ(oracle.value().size(), programs.size());
  for (size_t i = 0; i < RandomPart(programs.size()); ++i) {
    const RandomProgram& program = programs[i];
    const auto image = CompileAndLink(program);
    ASSERT_TRUE(image.ok()) << image.error().message.en << '\n' << Listing(program);
    MachineRun run(program, image.value());
    ASSERT_TRUE(run.RunInSequence(kEndless)) << "does not end\n" << Listing(program);
    const std::string difference = Difference(program, oracle.value()[i], run.FinalValues());
    ASSERT_EQ(difference, "") << Listing(program);

    // With single steps no instruction is fused; odd chunks end inside fused statements.
    for (const int64_t chunk : {1, 7}) {
      MachineRun chunked(program, image.value());
      ASSERT_TRUE(chunked.RunInSequence(chunk));
      ASSERT_EQ(chunked.Hash(), run.Hash()) << "chunks of " << chunk << '\n' << Listing(program);
      ASSERT_EQ(chunked.executed(), run.executed()) << Listing(program);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Batches, DifferentialTest, testing::Range(0, kBatches));

// Of four interleaved programs two run with the plain round robin, one with longer turns, and one
// begins in a random order.
std::vector<Interleaving> MakeInterleavings(const std::vector<RandomProgram>& programs) {
  constexpr int kQuanta[] = {2, 3, 7};
  std::vector<Interleaving> interleavings;
  for (size_t i = 0; i < programs.size(); ++i) {
    Interleaving interleaving;
    if (i % 4 == 2) interleaving.quantum = kQuanta[i / 4 % 3];
    if (i % 4 == 3) {
      uint64_t state = programs[i].seed;
      for (int step = 0; step < 100; ++step) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        interleaving.order += static_cast<char>('0' + (state >> 33) % programs[i].functions.size());
      }
    }
    interleavings.push_back(interleaving);
  }
  return interleavings;
}

TEST(InterleavingTest, ThreadsInterleaveStatementByStatement) {
  std::vector<RandomProgram> programs;
  for (int i = 0; i < kInterleavedPrograms; ++i) {
    programs.push_back(
        MakeProgram(static_cast<uint64_t>(kInterleavedSeed + i), Sharing::kInterleaved));
  }
  const std::vector<Interleaving> interleavings = MakeInterleavings(programs);
  const auto oracle = RunOracle(programs, interleavings, Folder("interleaved"));
  ASSERT_TRUE(oracle.ok()) << oracle.error().message.en;
  ASSERT_EQ(oracle.value().size(), programs.size());
  for (size_t i = 0; i < RandomPart(programs.size()); ++i) {
    const RandomProgram& program = programs[i];
    const auto image = CompileAndLink(program);
    ASSERT_TRUE(image.ok()) << image.error().message.en << '\n' << Listing(program);
    MachineRun run(program, image.value());
    ASSERT_TRUE(run.RunInterleaved(interleavings[i])) << "does not end\n" << Listing(program);
    const std::string difference = Difference(program, oracle.value()[i], run.FinalValues());
    ASSERT_EQ(difference, "") << "order " << interleavings[i].order << ", quantum "
                              << interleavings[i].quantum << '\n'
                              << Listing(program);
  }
}

}  // namespace
}  // namespace oncard::differential
