// A motion program's call of a GT command: reads the arguments into doubles, calls the command
// table, writes the outputs back. Every scalar of the interface fits a double exactly.
// Tested by tests/vm/command_call_test.cc.
#include <array>
#include <cmath>
#include <vector>

#include "vm/handlers.h"
#include "vm/interpreter.h"

namespace oncard::vm {
namespace {

struct OperandPlace {
  int64_t* address = nullptr;
  SlotAddress slot;
  int extent_used = 0;  // elements of the array before this one
};

// Finds a variable operand; address is nullptr when its index is out of bounds.
OperandPlace FindPlace(Frame& frame, uint16_t operand, uint8_t page) {
  OperandPlace place;
  place.slot.page = page;
  switch (ClassOf(operand)) {
    case OperandClass::kLocal:
      place.address = frame.locals() + IndexOf(operand);
      break;
    case OperandClass::kGlobal:
      place.slot.global = true;
      place.address = frame.bases[kGlobalBase] + IndexOf(operand);
      break;
    case OperandClass::kElement: {
      const ElementReference& element = frame.function->elements[IndexOf(operand)];
      place.slot.global = element.array_class == kGlobalBase;
      place.address = ElementAddress(frame, operand);
      if (place.address == nullptr) return place;
      const int64_t* base = frame.bases[element.array_class];
      place.extent_used = static_cast<int>(place.address - base) - element.base;
      break;
    }
    case OperandClass::kConstant:
      break;
  }
  const int64_t* base = frame.bases[place.slot.global ? kGlobalBase : kLocalBase];
  place.slot.id = static_cast<uint16_t>(place.address - base);
  return place;
}

double DoubleOf(int64_t raw, DataType type) {
  return type == DataType::kDouble ? DoubleFromFixed(raw)
                                   : static_cast<double>(static_cast<int32_t>(raw));
}

// Converts an output of a command to a slot: truncated toward zero, wrapped to the slot's width.
int64_t RawOf(double value, DataType type, int wrap_shift) {
  constexpr double kTwoTo64 = 18446744073709551616.0;
  double scaled = std::trunc(type == DataType::kDouble ? value * kFractionScale : value);
  if (!std::isfinite(scaled)) return 0;
  scaled = std::fmod(scaled, kTwoTo64);
  const uint64_t bits =
      scaled < 0 ? 0 - static_cast<uint64_t>(-scaled) : static_cast<uint64_t>(scaled);
  return type == DataType::kDouble ? WrapFixed(static_cast<int64_t>(bits), wrap_shift)
                                   : static_cast<int32_t>(static_cast<uint32_t>(bits));
}

}  // namespace

Exit CallCommand(Frame& frame, const CallSite& site) {
  Machine& machine = *frame.machine;
  ThreadState& thread = machine.ThreadAt(frame.thread);
  const size_t count = site.arguments.size();
  std::array<CommandArgument, kCommandArgumentMax> arguments;
  std::array<OperandPlace, kCommandArgumentMax> places;
  std::array<size_t, kCommandArgumentMax> cell_counts{};
  size_t cell_total = 0;

  for (size_t i = 0; i < count; ++i) {
    const CallSite::Argument& argument = site.arguments[i];
    if (ClassOf(argument.operand) == OperandClass::kConstant) {
      arguments[i].value =
          DoubleOf(frame.function->constants[IndexOf(argument.operand)], argument.type);
      continue;
    }
    places[i] = FindPlace(frame, argument.operand, thread.page);
    if (places[i].address == nullptr) {
      frame.fault = Fault::kIndexOutOfBounds;
      return Exit::kFault;
    }
    if (!argument.address) arguments[i].value = DoubleOf(*places[i].address, argument.type);
  }
  for (size_t i = 0; i < count; ++i) {
    const CallSite::Argument& argument = site.arguments[i];
    if (!argument.address) continue;
    int64_t elements = 1;
    if (argument.count_argument >= 0) {
      elements =
          static_cast<int64_t>(arguments[static_cast<size_t>(argument.count_argument)].value);
      if (elements < 0) elements = 0;  // the command refuses a negative count
    } else if (argument.elements_on_card) {
      elements = machine.commands_->Elements(site.command, i, arguments[0].value);
    }
    const int64_t slots = elements * static_cast<int64_t>(argument.slots.size());
    const int64_t extent = argument.extent - places[i].extent_used;
    if (slots > extent) {
      frame.fault = Fault::kOutputBeyondStorage;
      frame.fault_value = slots;
      frame.fault_limit = extent;
      return Exit::kFault;
    }
    cell_counts[i] = static_cast<size_t>(slots);
    cell_total += cell_counts[i];
  }

  std::vector<double>& cells = machine.cells_;
  if (cells.size() < cell_total) cells.resize(cell_total);
  double* next_cell = cells.data();
  for (size_t i = 0; i < count; ++i) {
    const CallSite::Argument& argument = site.arguments[i];
    if (!argument.address) continue;
    arguments[i].slot = places[i].slot;
    arguments[i].slot.type = argument.type;
    arguments[i].cells = {next_cell, cell_counts[i]};
    for (size_t cell = 0; cell < cell_counts[i]; ++cell) {
      next_cell[cell] =
          DoubleOf(places[i].address[cell], argument.slots[cell % argument.slots.size()]);
    }
    next_cell += cell_counts[i];
  }

  // An observer of commands reads from pc which statement makes the call.
  thread.pc = static_cast<uint16_t>(frame.pc - frame.function->code.data());
  thread.error = machine.commands_->Execute(site.command, machine, frame.thread,
                                            std::span(arguments.data(), count));
  if (thread.error == kOk) {
    for (size_t i = 0; i < count; ++i) {
      const CallSite::Argument& argument = site.arguments[i];
      for (size_t cell = 0; cell < cell_counts[i]; ++cell) {
        places[i].address[cell] =
            RawOf(arguments[i].cells[cell], argument.slots[cell % argument.slots.size()],
                  frame.wrap_shift);
      }
    }
  }
  frame.bases[kLocalBase] = machine.state_->pages.Use(thread.page).data();
  if (!machine.CanContinue(thread)) return Exit::kBlocked;
  // A delay or a wait that ends at once must not change the state.
  thread.wake_cycle = 0;
  thread.waiting = false;
  return Exit::kBudget;
}

}  // namespace oncard::vm
