#include "structured_run.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "gtcalls/gts/catalogue.h"
#include "oracle.h"

namespace oncard::differential {
namespace {

// Commands that keep structures for the axes 1 to 4, and fail for others, in C and on the machine.
constexpr std::string_view kCommandsInC = R"(
typedef struct { double acc, dec, velStart; short smoothTime; } TTrapPrm;
typedef struct { double kp, ki, kd, kvff, kaff; int integralLimit, derivativeLimit; short limit; } TPid;
static TTrapPrm kept_traps[5];
static TPid kept_pids[5];
static int fails(int axis) { return axis < 1 || axis > 4; }
static short GT_SetTrapPrm(int axis, TTrapPrm *p) { return fails(axis) || (kept_traps[axis] = *p, 0); }
static short GT_GetTrapPrm(int axis, TTrapPrm *p) { return fails(axis) || (*p = kept_traps[axis], 0); }
static short GT_SetPid(int axis, int index, TPid *p) { return fails(axis) || (kept_pids[axis] = *p, 0); }
static short GT_GetPid(int axis, int index, TPid *p) { return fails(axis) || (*p = kept_pids[axis], 0); }
)";

class KeptStructures final : public vm::CommandTable {
 public:
  const vm::CommandShape* Find(uint16_t number) const override {
    const gtcalls::Command* const command = gtcalls::GtsCatalogue().Find(number);
    return command != nullptr ? &gtcalls::GtsCatalogue().ShapeOf(*command) : nullptr;
  }
  int16_t Execute(uint16_t number, vm::Machine& /*machine*/, int /*thread*/,
                  std::span<vm::CommandArgument> arguments) override {
    const int axis = static_cast<int>(arguments.front().value);
    if (axis < 1 || axis > 4) return 1;
    const std::span<double> cells = arguments.back().cells;
    const std::string_view name = gtcalls::GtsCatalogue().Find(number)->name;
    std::vector<double>& kept = kept_[{name.substr(name.find('t') + 1), axis}];
    kept.resize(cells.size());
    if (name.starts_with("GT_Set")) {
      kept.assign(cells.begin(), cells.end());
    } else {
      std::copy(kept.begin(), kept.end(), cells.begin());
    }
    return 0;
  }

 private:
  std::map<std::pair<std::string_view, int>, std::vector<double>> kept_;  // by structure and axis
};

}  // namespace

// Macros keep the names of the programs apart.
std::string StructuredOracleText(const std::vector<StructuredProgram>& programs) {
  std::string text =
      "#include <math.h>\n#include <stdbool.h>\n#include <stdio.h>\n#include <string.h>\n";
  text += kCommandsInC;
  std::string calls;
  for (const StructuredProgram& program : programs) {
    text += "#undef C0\n#undef C1\n";
    for (const char* name :
         {"f",  "fuel", "b0",      "g0",   "g1", "g2", "g3", "a",  "m",  "h",    "k",    "s",  "e",
          "w",  "mean", "eighths", "walk", "c0", "c1", "c2", "d0", "d1", "d2",   "d3",   "r0", "r1",
          "r2", "r3",   "v0",      "v1",   "v2", "v3", "s0", "s1", "c",  "pair", "outer"}) {
      text += fmt::format("#undef {0}\n#define {0} {0}_{1}\n", name, program.seed);
    }
    text += fmt::format(
        "{}void run_{}() {{\n  memset(kept_traps, 0, sizeof kept_traps);\n"
        "  memset(kept_pids, 0, sizeof kept_pids);\n  printf(\"%d\", f());\n",
        program.text, program.seed);
    for (const std::string& global : program.globals) {
      text += fmt::format("  printf(\" %d\", {});\n", global);
    }
    text += "  printf(\"\\n\");\n}\n";
    calls += fmt::format("run_{}();\n", program.seed);
  }
  return text + fmt::format("int main() {{\n{}}}\n", calls);
}

Values RunStructured(const StructuredProgram& program, const vm::Object& object) {
  return RunFirstFunction(object, program.globals, kEndless);
}

Values RunFirstFunction(const vm::Object& object, const std::vector<std::string>& globals,
                        int64_t statements) {
  KeptStructures commands;
  vm::Machine machine(&commands);
  auto image = vm::LinkObject(object, commands);
  EXPECT_TRUE(image.ok());
  machine.Load(std::move(image).value());
  machine.Bind(0, 1, 0);
  machine.Run(0);
  machine.Execute(statements);
  if (!machine.Quiet()) return {};
  EXPECT_NE(machine.thread(0).run, vm::ThreadRun::kFaulted) << machine.thread(0).error;
  Values values = {machine.thread(0).result};
  for (const std::string& name : globals) {
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

namespace {

int GlobalsIn(const vm::Operand& operand) {
  if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
    return variable->storage == vm::Storage::kGlobal ? 1 : 0;
  }
  const auto* element = std::get_if<vm::Element>(&operand);
  if (element == nullptr) return 0;
  return (element->storage == vm::Storage::kGlobal ? 1 : 0) +
         (element->index.storage == vm::Storage::kGlobal ? 1 : 0);
}

}  // namespace

int64_t CountGlobalAccesses(const vm::Object& object) {
  KeptStructures commands;
  vm::Machine machine(&commands);
  machine.Load(std::move(vm::LinkObject(object, commands)).value());
  machine.Bind(0, 1, 0);
  machine.Run(0);
  int64_t count = 0;
  for (int64_t i = 0; i < kEndless; ++i) {
    const vm::Instruction& next = object.functions[0].instructions[machine.thread(0).pc];
    if (!machine.ExecuteOne(0)) break;
    for (const vm::Operand& operand : next.operands) count += GlobalsIn(operand);
  }
  return count;
}

}  // namespace oncard::differential
