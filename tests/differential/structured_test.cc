// Random programs of ordinary C, after all fix-its, must compute with oncard what the originals
// compute when compiled by g++. ONCARD_STRUCTURED_PROGRAMS=10000 tests more than the default
// number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "compiler/fix_it_applier.h"
#include "machine_run.h"
#include "oracle.h"
#include "structured_program.h"

namespace oncard::differential {
namespace {

constexpr int kUsualPrograms = 250;
constexpr int kProgramsPerBatch = 250;

int ProgramCount() {
  const char* wanted = std::getenv("ONCARD_STRUCTURED_PROGRAMS");
  return wanted != nullptr ? std::atoi(wanted) : kUsualPrograms;
}

// One C file with all programs, each of which prints its result and its globals. Macros keep their
// names apart.
std::string OracleText(const std::vector<StructuredProgram>& programs) {
  std::string text = "#include <stdbool.h>\n#include <stdio.h>\n";
  std::string calls;
  for (const StructuredProgram& program : programs) {
    text += "#undef C0\n#undef C1\n";
    for (const char* name : {"f", "fuel", "b0", "g0", "g1", "g2", "g3", "a", "m"}) {
      text += fmt::format("#undef {0}\n#define {0} {0}_{1}\n", name, program.seed);
    }
    text += fmt::format("{}void run_{}() {{\n  printf(\"%d\", f());\n", program.text, program.seed);
    for (const std::string& global : program.globals) {
      text += fmt::format("  printf(\" %d\", {});\n", global);
    }
    text += "  printf(\"\\n\");\n}\n";
    calls += fmt::format("run_{}();\n", program.seed);
  }
  return text + fmt::format("int main() {{\n{}}}\n", calls);
}

// The same values from a run of the corrected program; empty if it does not end.
Values RunCorrected(const StructuredProgram& program, const vm::Object& object) {
  NoCommands commands;
  vm::Machine machine(&commands);
  auto image = vm::LinkObject(object, commands);
  EXPECT_TRUE(image.ok());
  machine.Load(std::move(image).value());
  machine.Bind(0, 1, 0);
  machine.Run(0);
  machine.Execute(kEndless);
  if (!machine.Quiet()) return {};
  EXPECT_EQ(machine.thread(0).error, 0) << "fault";
  Values values = {machine.thread(0).result};
  for (const std::string& name : program.globals) {
    const size_t bracket = name.find('[');
    const vm::Symbol* symbol = vm::FindGlobal(*machine.image(), name.substr(0, bracket));
    const int element = bracket == std::string::npos ? 0 : name[bracket + 1] - '0';
    vm::SlotAddress slot;
    slot.global = true;
    slot.id = static_cast<uint16_t>(symbol->id + element);
    slot.type = symbol->type;
    values.push_back(machine.ReadRaw(slot));
  }
  return values;
}

TEST(StructuredTest, CorrectedProgramsComputeWhatGccComputes) {
  const int count = ProgramCount();
  for (int begin = 0; begin < count; begin += kProgramsPerBatch) {
    std::vector<StructuredProgram> programs;
    for (int i = begin; i < std::min(begin + kProgramsPerBatch, count); ++i) {
      programs.push_back(MakeStructuredProgram(static_cast<uint64_t>(i)));
    }
    // With -fwrapv ints wrap as in the language.
    const auto oracle = RunOracle(OracleText(programs), "-x c -fwrapv",
                                  std::string(ONCARD_BUILD_DIR) + "/tests/differential/structured");
    ASSERT_TRUE(oracle.ok()) << oracle.error().message.en;
    ASSERT_EQ(oracle.value().size(), programs.size());
    for (size_t i = 0; i < programs.size(); ++i) {
      const StructuredProgram& program = programs[i];
      const compiler::CorrectedProgram corrected = compiler::ApplyAllFixIts(
          "random.c", program.text, {}, [](const std::string& path) -> Result<std::string> {
            return MakeError(1, "no file '{}'", "没有文件“{}”", path);
          });
      const std::string listing =
          fmt::format("seed {}\n{}\ncorrected\n{}", program.seed, program.text,
                      corrected.files.contains("random.c") ? corrected.files.at("random.c") : "");
      ASSERT_TRUE(corrected.compilation.ok()) << ErrorsOf(corrected.compilation) << listing;
      ASSERT_EQ(RunCorrected(program, *corrected.compilation.object), oracle.value()[i]) << listing;
    }
  }
}

}  // namespace
}  // namespace oncard::differential
