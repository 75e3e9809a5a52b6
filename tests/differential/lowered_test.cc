// Random programs of ordinary C, lowered with and without the passes, must compute with oncard what
// the originals compute when compiled by gcc, plainly, optimised and with its sanitizer for
// undefined behaviour. ONCARD_STRUCTURED_PROGRAMS=20000 tests more than the default number.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "array_program.h"
#include "called_program.h"
#include "compiler/lowering/lowering.h"
#include "fixed_program.h"
#include "machine_run.h"
#include "oracle.h"
#include "recursive_program.h"
#include "struct_program.h"
#include "structured_program.h"
#include "structured_run.h"
#include "tests/base/random_cases.h"
#include "tests/compiler/memory_files.h"
#include "typed_program.h"

namespace oncard::differential {
namespace {

constexpr int kUsualPrograms = 250;
constexpr int kProgramsPerBatch = 250;

// With -fwrapv ints wrap as in the language. Optimised code and the sanitizer show whether a
// program has one meaning in C. Shifting a negative number to the left has one with -fwrapv.
constexpr const char* kCompilations[] = {
    "-x c -fwrapv", "-x c -fwrapv -O2",
    "-x c -fwrapv -fsanitize=undefined -fno-sanitize=shift-base -fno-sanitize-recover=all"};

int ProgramCount() {
  const char* wanted = std::getenv("ONCARD_STRUCTURED_PROGRAMS");
  return wanted != nullptr ? std::atoi(wanted) : kUsualPrograms;
}

std::string MessagesOf(const std::vector<compiler::Diagnostic>& diagnostics) {
  std::string messages;
  for (const compiler::Diagnostic& diagnostic : diagnostics) {
    messages +=
        compiler::DiagnosticName(diagnostic.info->code) + ' ' + diagnostic.message.en + '\n';
  }
  return messages;
}

// The warnings, without those of the original itself: a divisor that it never sets.
std::string WarningsOfLowering(const compiler::Compilation& compilation) {
  std::vector<compiler::Diagnostic> warnings = compilation.diagnostics;
  std::erase_if(warnings, [](const compiler::Diagnostic& diagnostic) {
    return diagnostic.info->slug == "zero-divisor";
  });
  return MessagesOf(warnings);
}

// Whether a program has more labels than the card, and no other error.
bool HasTooManyLabels(const compiler::Lowering& lowering) {
  return std::all_of(lowering.diagnostics.begin(), lowering.diagnostics.end(),
                     [](const compiler::Diagnostic& diagnostic) {
                       return diagnostic.info->slug == "lowered-labels";
                     });
}

// With the passes, with all slots shared that can be, and without the passes.
constexpr compiler::LoweringOptions kLowerings[] = {
    {.annotate = true}, {.slots = 0}, {.optimize = false, .annotate = true}};

// Lowers one program, compiles the text and compares what it computes.
void Check(const StructuredProgram& program, const compiler::LoweringOptions& options,
           const Values& expected) {
  const bool optimize = options.optimize;
  const compiler::Lowering lowering =
      compiler::LowerText("random.c", program.text, {}, options, compiler::NoFiles());
  const std::string listing =
      fmt::format("seed {}, optimize {}, slots {}\n{}\nlowered\n{}", program.seed, optimize,
                  options.slots, program.text, lowering.text.value_or(""));
  // Some programs fit the card only with calls as jumps.
  if (!optimize && !lowering.text && HasTooManyLabels(lowering)) return;
  ASSERT_TRUE(lowering.text.has_value()) << MessagesOf(lowering.diagnostics) << listing;
  const compiler::Compilation compilation =
      compiler::CompileText("lowered.c", *lowering.text, {}, compiler::NoFiles());
  ASSERT_TRUE(compilation.ok()) << ErrorsOf(compilation) << listing;
  // Without the passes, what they would remove may cause warnings.
  if (optimize) {
    EXPECT_EQ(WarningsOfLowering(compilation), "") << listing;
  }
  ASSERT_EQ(RunStructured(program, *compilation.object), expected) << listing;
}

// What all programs of a generator compute, against gcc.
void CheckAll(const std::function<StructuredProgram(uint64_t)>& make, const std::string& folder) {
  const int count = ProgramCount();
  for (int begin = 0; begin < count; begin += kProgramsPerBatch) {
    std::vector<StructuredProgram> programs;
    for (int i = begin; i < std::min(begin + kProgramsPerBatch, count); ++i) {
      programs.push_back(make(static_cast<uint64_t>(i)));
    }
    std::vector<Values> expected;
    for (const char* compilation : kCompilations) {
      const auto oracle =
          RunOracle(StructuredOracleText(programs), compilation,
                    std::string(ONCARD_BUILD_DIR) + "/tests/differential/" + folder);
      ASSERT_TRUE(oracle.ok()) << oracle.error().message.en;
      if (expected.empty()) expected = oracle.value();
      ASSERT_EQ(oracle.value(), expected) << compilation << ", programs from " << begin;
    }
    ASSERT_EQ(expected.size(), programs.size());
    for (size_t i = 0; i < RandomPart(programs.size()); ++i) {
      for (const compiler::LoweringOptions& options : kLowerings) {
        Check(programs[i], options, expected[i]);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(LoweredTest, LoweredProgramsComputeWhatGccComputes) {
  CheckAll([](uint64_t seed) { return MakeStructuredProgram(seed, Floats::kNone); }, "lowered");
}

TEST(LoweredTest, LoweredTypesAndCallsComputeWhatGccComputes) {
  CheckAll(MakeTypedProgram, "typed");
}

TEST(LoweredTest, LoweredDoublesComputeWhatGccComputes) { CheckAll(MakeFixedProgram, "fixed"); }

TEST(LoweredTest, LoweredCallsComputeWhatGccComputes) { CheckAll(MakeCalledProgram, "called"); }

TEST(LoweredTest, LoweredRecursionComputesWhatGccComputes) {
  CheckAll(MakeRecursiveProgram, "recursive");
}

TEST(LoweredTest, LoweredStructuresComputeWhatGccComputes) {
  CheckAll(MakeStructProgram, "structs");
}

TEST(LoweredTest, LoweredArraysHaveTheValuesThatGccGivesThem) {
  CheckAll(MakeArrayProgram, "arrays");
}

constexpr int kCountedPrograms = 60;

// The accesses to globals of some programs, without the passes and with them, must not be more with
// them. Returns how many calls are jumps.
int CheckAccesses(const std::function<StructuredProgram(uint64_t)>& make) {
  int64_t saved = 0;
  int jumps = 0;
  for (int seed = 0; seed < kCountedPrograms; ++seed) {
    const StructuredProgram program = make(static_cast<uint64_t>(seed));
    const auto count = [&program, &jumps](bool optimize) {
      const compiler::Lowering lowering =
          compiler::LowerText("random.c", program.text, {}, {optimize, false}, compiler::NoFiles());
      EXPECT_TRUE(lowering.object.has_value()) << MessagesOf(lowering.diagnostics);
      for (const compiler::JumpCalls& calls : lowering.costs[0].jumps) jumps += calls.calls;
      return CountGlobalAccesses(lowering.object.value());
    };
    const int64_t plain = count(false);
    const int64_t optimized = count(true);
    EXPECT_LE(optimized, plain) << program.text;
    saved += plain - optimized;
  }
  EXPECT_GT(saved, 0);
  return jumps;
}

TEST(LoweredTest, PassesAddNoAccessToGlobals) {
  CheckAccesses([](uint64_t seed) { return MakeStructuredProgram(seed, Floats::kNone); });
}

TEST(LoweredTest, CallsByJumpsAddNoAccessToGlobals) {
  EXPECT_GT(CheckAccesses(MakeCalledProgram), kCountedPrograms);
}

}  // namespace
}  // namespace oncard::differential
