// Random programs of ordinary C, after all fix-its, must compute with oncard what the originals
// compute when compiled by g++. ONCARD_STRUCTURED_PROGRAMS=10000 tests more than the default
// number.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "compiler/fix_it_applier.h"
#include "machine_run.h"
#include "oracle.h"
#include "structured_program.h"
#include "structured_run.h"
#include "tests/base/random_cases.h"
#include "tests/compiler/memory_files.h"

namespace oncard::differential {
namespace {

constexpr int kUsualPrograms = 250;
constexpr int kProgramsPerBatch = 250;

int ProgramCount() {
  const char* wanted = std::getenv("ONCARD_STRUCTURED_PROGRAMS");
  return wanted != nullptr ? std::atoi(wanted) : kUsualPrograms;
}

TEST(StructuredTest, CorrectedProgramsComputeWhatGccComputes) {
  const int count = ProgramCount();
  for (int begin = 0; begin < count; begin += kProgramsPerBatch) {
    std::vector<StructuredProgram> programs;
    for (int i = begin; i < std::min(begin + kProgramsPerBatch, count); ++i) {
      programs.push_back(MakeStructuredProgram(static_cast<uint64_t>(i)));
    }
    // With -fwrapv ints wrap as in the language.
    const auto oracle = RunOracle(StructuredOracleText(programs), "-x c -fwrapv",
                                  std::string(ONCARD_BUILD_DIR) + "/tests/differential/structured");
    ASSERT_TRUE(oracle.ok()) << oracle.error().message.en;
    ASSERT_EQ(oracle.value().size(), programs.size());
    for (size_t i = 0; i < RandomPart(programs.size()); ++i) {
      const StructuredProgram& program = programs[i];
      const compiler::CorrectedProgram corrected =
          compiler::ApplyAllFixIts("random.c", program.text, {}, compiler::NoFiles());
      const std::string listing =
          fmt::format("seed {}\n{}\ncorrected\n{}", program.seed, program.text,
                      corrected.files.contains("random.c") ? corrected.files.at("random.c") : "");
      ASSERT_TRUE(corrected.compilation.ok()) << ErrorsOf(corrected.compilation) << listing;
      ASSERT_EQ(RunStructured(program, *corrected.compilation.object), oracle.value()[i])
          << listing;
    }
  }
}

}  // namespace
}  // namespace oncard::differential
