#include "runtime/observe/step_log.h"

#include <algorithm>
#include <optional>

#include "runtime/observe/quantity.h"
#include "vm/symbol_names.h"

namespace oncard::runtime {
namespace {

using vm::SlotAddress;

const vm::Symbol* SymbolOf(const SlotAddress& slot, int function, const vm::Object& object) {
  const auto& symbols =
      slot.global ? object.globals : object.functions[static_cast<size_t>(function)].variables;
  const auto holds = [&](const vm::Symbol& symbol) {
    return slot.id >= symbol.id && slot.id < symbol.id + symbol.slots();
  };
  const auto found = std::ranges::find_if(symbols, holds);
  return found == symbols.end() ? nullptr : &*found;
}

int64_t RawOf(const vm::MachineState& state, const SlotAddress& slot) {
  return slot.global ? state.globals[slot.id] : state.pages[slot.page][slot.id];
}

/// The slots that the operands of an instruction refer to in a state.
class Operands {
 public:
  Operands(const vm::MachineState& state, int page) : state_(state), page_(page) {}

  SlotAddress SlotOf(const vm::Variable& variable) const {
    const bool global = variable.storage == vm::Storage::kGlobal;
    return {global, static_cast<uint8_t>(global ? 0 : page_), variable.id};
  }
  /// Empty for a literal and for an index out of bounds.
  std::optional<SlotAddress> SlotOf(const vm::Operand& operand) const {
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) return SlotOf(*variable);
    const auto* element = std::get_if<vm::Element>(&operand);
    if (element == nullptr) return std::nullopt;
    const auto index =
        static_cast<uint32_t>(static_cast<int32_t>(RawOf(state_, SlotOf(element->index))));
    if (index >= element->size) return std::nullopt;
    return SlotOf(vm::Variable{element->storage, static_cast<uint16_t>(element->base + index)});
  }
  void AddRead(const SlotAddress& slot, std::vector<SlotValue>* reads) const {
    const auto same = [&](const SlotValue& read) { return SameSlot(read.slot, slot); };
    if (std::ranges::any_of(*reads, same)) return;
    reads->push_back({slot, RawOf(state_, slot)});
  }
  void AddRead(const vm::Operand& operand, std::vector<SlotValue>* reads) const {
    AddIndex(operand, reads);
    if (const auto slot = SlotOf(operand)) AddRead(*slot, reads);
  }
  void AddIndex(const vm::Operand& operand, std::vector<SlotValue>* reads) const {
    const auto* element = std::get_if<vm::Element>(&operand);
    if (element != nullptr) AddRead(SlotOf(element->index), reads);
  }

 private:
  const vm::MachineState& state_;
  int page_;
};

/// Adds the slots whose values differ from those before.
void AddChanges(const vm::MachineState& before, const vm::MachineState& after,
                std::vector<SlotChange>* writes) {
  const auto add = [&](const SlotAddress& slot) {
    const int64_t old = RawOf(before, slot);
    const int64_t now = RawOf(after, slot);
    const auto same = [&](const SlotChange& write) { return SameSlot(write.slot, slot); };
    if (old != now && std::ranges::none_of(*writes, same)) writes->push_back({slot, old, now});
  };
  for (int id = 0; id < vm::kSlotCount; ++id) add({true, 0, static_cast<uint16_t>(id)});
  const uint32_t used = before.pages.used() | after.pages.used();
  for (int page = 0; page < vm::kPageCount; ++page) {
    if ((used >> page & 1) == 0) continue;
    for (int id = 0; id < vm::kSlotCount; ++id) {
      add({false, static_cast<uint8_t>(page), static_cast<uint16_t>(id)});
    }
  }
}

bool IsConditional(const vm::Instruction& instruction) {
  return (instruction.opcode == vm::Opcode::kJump || instruction.opcode == vm::Opcode::kReturn) &&
         !std::holds_alternative<vm::Immediate>(instruction.operands.front());
}

}  // namespace

bool SameSlot(const SlotAddress& a, const SlotAddress& b) {
  return a.global == b.global && a.id == b.id && (a.global || a.page == b.page);
}

std::string NameOf(const LoggedStep& step, const SlotAddress& slot, const vm::Object& object) {
  return NameOfSlot(slot, step.function, object);
}

std::string NameOfSlot(const SlotAddress& slot, int function, const vm::Object& object) {
  const vm::Symbol* symbol = SymbolOf(slot, function, object);
  if (symbol == nullptr) return {};
  return vm::NameOfElement(*symbol, slot.id - symbol->id);
}

std::string ValueText(const LoggedStep& step, const SlotAddress& slot, int64_t raw,
                      const vm::Object& object) {
  const vm::Symbol* symbol = SymbolOf(slot, step.function, object);
  const vm::DataType type = symbol == nullptr ? vm::DataType::kInt : symbol->type;
  const double value = type == vm::DataType::kDouble
                           ? vm::DoubleFromFixed(raw)
                           : static_cast<double>(static_cast<int32_t>(raw));
  return FormatNumber(value, FormOf(type));
}

void StepWatch::Before() {
  const vm::MachineState& state = controller_.machine().state();
  if (before_ == nullptr) {
    before_ = std::make_unique<vm::MachineState>(state);
  } else {
    *before_ = state;
  }
  at_ms_ = controller_.NowMs();
}

int StepWatch::ThreadOfStep() const {
  const vm::MachineState& after = controller_.machine().state();
  for (size_t thread = 0; thread < after.threads.size(); ++thread) {
    const vm::ThreadState& was = before_->threads[thread];
    const vm::ThreadState& is = after.threads[thread];
    const bool faulted = is.run == vm::ThreadRun::kFaulted && was.run != vm::ThreadRun::kFaulted;
    if (faulted || is.executed == was.executed + 1) return static_cast<int>(thread);
  }
  return -1;
}

LoggedStep StepWatch::After(int thread) const {
  const vm::ThreadState& state = before_->threads[static_cast<size_t>(thread)];
  const vm::Object& object = controller_.machine().image()->object;
  const vm::Function& function = object.functions[state.function];
  LoggedStep step;
  step.thread = thread;
  step.function = state.function;
  step.position = state.pc;
  step.line = function.lines[state.pc];
  step.at_ms = at_ms_;
  const vm::Instruction& instruction = function.instructions[state.pc];
  const Operands operands(*before_, state.page);
  const bool computes =
      instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
  step.command = instruction.opcode == vm::Opcode::kCommand;
  step.decides = IsConditional(instruction);
  const vm::CommandShape* shape =
      step.command ? controller_.commands().Find(instruction.op) : nullptr;
  for (size_t i = 0; i < instruction.operands.size(); ++i) {
    const vm::Operand& operand = instruction.operands[i];
    const bool address =
        shape != nullptr && i < shape->parameters.size() && shape->parameters[i].address;
    const bool target = computes && i + 1 == instruction.operands.size();
    if (!address && !target) {
      operands.AddRead(operand, &step.reads);
      continue;
    }
    operands.AddIndex(operand, &step.reads);
    const auto slot = target ? operands.SlotOf(operand) : std::nullopt;
    if (slot) {
      const int64_t after = RawOf(controller_.machine().state(), *slot);
      step.writes.push_back({*slot, RawOf(*before_, *slot), after});
    }
  }
  AddChanges(*before_, controller_.machine().state(), &step.writes);
  return step;
}

RunEnd RunLogged(Controller* controller, int64_t limit_cycles, StepLog* log) {
  vm::Machine& machine = controller->machine();
  log->image = machine.shared_image();
  StepWatch watch(*controller);
  for (int64_t ran = 0; !machine.Quiet(); ++ran) {
    if (controller->Deadlocked()) return RunEnd::kDeadlock;
    if (ran >= limit_cycles) return RunEnd::kTimeLimit;
    const int64_t budget = controller->BeginCycle();
    machine.Execute(0);
    controller->ShowState();
    for (int64_t executed = 0; executed < budget;) {
      const int64_t part = std::min(budget - executed, controller->StatementsUntilHost(executed));
      const bool logs = log->steps.size() < StepLog::kStepMax;
      if (logs) watch.Before();
      const int64_t done = machine.Execute(logs || controller->shows_states() ? 1 : part);
      if (done != 0) controller->ShowState();
      const int thread = logs ? watch.ThreadOfStep() : -1;
      if (thread >= 0) log->steps.push_back(watch.After(thread));
      log->executed += done;
      if (done == 0 || machine.last_stop() != vm::Stop::kBudget) break;
      executed += done;
    }
    if (machine.Quiet()) break;
    if (machine.last_stop() == vm::Stop::kScheduleEnd) return RunEnd::kScheduleEnd;
    if (machine.last_stop() == vm::Stop::kScheduleDiverged) return RunEnd::kScheduleDiverged;
  }
  return RunEnd::kQuiet;
}

}  // namespace oncard::runtime
