#include "structured_run.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "oracle.h"

namespace oncard::differential {

// Macros keep the names of the programs apart.
std::string StructuredOracleText(const std::vector<StructuredProgram>& programs) {
  std::string text = "#include <math.h>\n#include <stdbool.h>\n#include <stdio.h>\n";
  std::string calls;
  for (const StructuredProgram& program : programs) {
    text += "#undef C0\n#undef C1\n";
    for (const char* name :
         {"f",  "fuel", "b0", "g0", "g1",   "g2",      "g3",   "a",  "m",    "h",
          "k",  "s",    "e",  "w",  "mean", "eighths", "walk", "c0", "c1",   "c2",
          "d0", "d1",   "r0", "r1", "v0",   "v1",      "s0",   "s1", "pair", "outer"}) {
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

Values RunStructured(const StructuredProgram& program, const vm::Object& object) {
  return RunFirstFunction(object, program.globals, kEndless);
}

Values RunFirstFunction(const vm::Object& object, const std::vector<std::string>& globals,
                        int64_t statements) {
  NoCommands commands;
  vm::Machine machine(&commands);
  auto image = vm::LinkObject(object, commands);
  EXPECT_TRUE(image.ok());
  machine.Load(std::move(image).value());
  machine.Bind(0, 1, 0);
  machine.Run(0);
  machine.Execute(statements);
  if (!machine.Quiet()) return {};
  EXPECT_EQ(machine.thread(0).error, 0) << "fault";
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
  NoCommands commands;
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
