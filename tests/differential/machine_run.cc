// Sets variables by their symbols, runs, and reads them by their symbols.
#include "machine_run.h"

#include <fmt/core.h>

#include "tests/compiler/memory_files.h"

namespace oncard::differential {
namespace {

constexpr int kGlobals = -1;  // instead of a function's number

}  // namespace

compiler::Compilation CompileSource(const std::string& text, vm::DoubleFormat format) {
  compiler::Options options;
  options.double_format = format;
  return compiler::CompileText("random.c", text, options, compiler::NoFiles());
}

std::string ErrorsOf(const compiler::Compilation& compilation) {
  std::string text;
  for (const compiler::Diagnostic& diagnostic : compilation.diagnostics) {
    if (diagnostic.severity != compiler::Severity::kError) continue;
    const auto& file = compilation.files[static_cast<size_t>(diagnostic.range.file)];
    text +=
        fmt::format("line {}: {}\n", file.LineOf(diagnostic.range.begin), diagnostic.message.en);
  }
  return text;
}

Result<std::shared_ptr<const vm::Image>> CompileAndLink(const RandomProgram& program) {
  compiler::Compilation compilation = CompileSource(SourceText(program), program.format);
  if (!compilation.ok()) {
    const std::string errors = ErrorsOf(compilation);
    return MakeError(1, "the compiler refuses the program: {}", "编译器拒绝该程序：{}", errors);
  }
  return vm::LinkObject(std::move(*compilation.object), NoCommands());
}

MachineRun::MachineRun(const RandomProgram& program, std::shared_ptr<const vm::Image> image)
    : machine_(&commands_), program_(program) {
  machine_.Load(std::move(image));
  Initialise(kGlobals, program.globals);
  for (int i = 0; i < static_cast<int>(program.functions.size()); ++i) {
    const RandomFunction& function = program.functions[static_cast<size_t>(i)];
    machine_.Bind(i, vm::FindFunction(*machine_.image(), function.name) + 1, i);
    Initialise(i, function.parameters);
    Initialise(i, function.locals);
  }
}

vm::SlotAddress MachineRun::Address(int function, const Declaration::Slot& slot) const {
  const vm::Symbol* symbol =
      function == kGlobals
          ? vm::FindGlobal(*machine_.image(), slot.symbol)
          : vm::FindLocal(*machine_.image(), machine_.thread(function).function, slot.symbol);
  vm::SlotAddress address;
  address.global = function == kGlobals;
  address.page = static_cast<uint8_t>(function == kGlobals ? 0 : function);
  address.id = static_cast<uint16_t>(symbol->id + slot.element);
  address.type = symbol->type;
  return address;
}

void MachineRun::Initialise(int function, const std::vector<Declaration>& declarations) {
  for (const Declaration& declaration : declarations) {
    for (const Declaration::Slot& slot : declaration.slots) {
      machine_.WriteRaw(Address(function, slot), slot.initial);
    }
  }
}

bool MachineRun::RunInSequence(int64_t chunk) {
  for (int i = 0; i < static_cast<int>(program_.functions.size()); ++i) {
    machine_.Run(i);
    while (!machine_.Quiet()) {
      if (machine_.Execute(chunk) == 0 || executed() > kEndless) break;
    }
    if (!machine_.Quiet()) return false;
  }
  return true;
}

bool MachineRun::RunInterleaved(const Interleaving& interleaving) {
  for (int i = 0; i < static_cast<int>(program_.functions.size()); ++i) machine_.Run(i);
  for (const char digit : interleaving.order) machine_.ExecuteOne(digit - '0');
  vm::Policy policy;
  policy.quantum = interleaving.quantum;
  machine_.SetPolicy(policy);
  machine_.Execute(kEndless);
  return machine_.Quiet();
}

void MachineRun::Collect(int function, const std::vector<Declaration>& declarations,
                         Values* values) const {
  for (const Declaration& declaration : declarations) {
    for (const Declaration::Slot& slot : declaration.slots) {
      values->push_back(machine_.ReadRaw(Address(function, slot)));
    }
  }
}

Values MachineRun::FinalValues() const {
  Values values;
  for (int i = 0; i < static_cast<int>(program_.functions.size()); ++i) {
    const RandomFunction& function = program_.functions[static_cast<size_t>(i)];
    Collect(i, function.parameters, &values);
    Collect(i, function.locals, &values);
    values.push_back(machine_.thread(i).result);
    values.push_back(machine_.thread(i).error);
  }
  Collect(kGlobals, program_.globals, &values);
  return values;
}

}  // namespace oncard::differential
