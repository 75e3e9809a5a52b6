#include "runtime/observe/statement_access.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <variant>

#include "runtime/observe/step_log.h"
#include "vm/operand_slots.h"

namespace oncard::runtime {
namespace {

using gtcalls::Part;
using gtcalls::Resource;

/// A thread's next statement with the current values of its operands.
class NextStatement {
 public:
  NextStatement(const Controller& controller, int thread, bool precise)
      : controller_(controller),
        precise_(precise),
        machine_(controller.machine()),
        state_(machine_.thread(thread)),
        object_(machine_.image()->object) {}

  StatementAccess Access() {
    const vm::Function& function = object_.functions[state_.function];
    if (state_.pc >= function.instructions.size()) return {};
    const vm::Instruction& instruction = function.instructions[state_.pc];
    if (instruction.opcode == vm::Opcode::kCommand) {
      AddCommand(instruction);
      return std::move(access_);
    }
    const bool writes =
        instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
    for (size_t i = 0; i < instruction.operands.size(); ++i) {
      AddOperand(instruction.operands[i], 1, writes && i + 1 == instruction.operands.size());
    }
    return std::move(access_);
  }

 private:
  void Add(Resource resource, uint32_t number, bool write, uint32_t bits = ~uint32_t{0}) {
    const Touched touched = {resource, number, write, bits};
    if (std::ranges::find(access_, touched) == access_.end()) access_.push_back(touched);
  }

  int32_t ValueOf(const vm::Variable& variable) const {
    return static_cast<int32_t>(
        machine_.ReadRaw({variable.storage == vm::Storage::kGlobal,
                          static_cast<uint8_t>(state_.page), variable.id, vm::DataType::kInt}));
  }
  /// The value of a selector or a count. 0 for an element out of bounds: the statement faults.
  int32_t ValueOf(const vm::Operand& operand) const {
    if (const auto* immediate = std::get_if<vm::Immediate>(&operand)) {
      return static_cast<int32_t>(immediate->raw >> vm::kFractionBits);
    }
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) return ValueOf(*variable);
    const auto& element = std::get<vm::Element>(operand);
    const auto index = static_cast<uint32_t>(ValueOf(element.index));
    if (index >= element.size) return 0;
    return ValueOf(vm::Variable{element.storage, static_cast<uint16_t>(element.base + index)});
  }

  /// Adds the globals of an operand that has `slots` consecutive slots.
  void AddOperand(const vm::Operand& operand, uint32_t slots, bool write) {
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
      if (variable->storage != vm::Storage::kGlobal) return;
      for (uint32_t i = 0; i < slots; ++i) Add(Resource::kVariable, variable->id + i, write);
    } else if (const auto* element = std::get_if<vm::Element>(&operand)) {
      const auto index = static_cast<uint32_t>(ValueOf(element->index));
      if (element->index.storage == vm::Storage::kGlobal) {
        Add(Resource::kVariable, element->index.id, false);
      }
      if (element->storage != vm::Storage::kGlobal || index >= element->size) return;
      for (uint32_t i = 0; i < slots; ++i) {
        Add(Resource::kVariable, element->base + index + i, write);
      }
    }
  }

  void AddCommand(const vm::Instruction& instruction) {
    const gtcalls::Command* command = controller_.family().catalogue.Find(instruction.op);
    const vm::CommandShape* shape = controller_.commands().Find(instruction.op);
    if (command == nullptr || shape == nullptr) {
      return Add(Resource::kEverything, Touched::kAll, true);
    }
    const auto& operands = instruction.operands;
    for (size_t i = 0; i < operands.size() && i < shape->parameters.size(); ++i) {
      const vm::ParameterShape& parameter = shape->parameters[i];
      if (!parameter.address) {
        AddOperand(operands[i], 1, false);
        continue;
      }
      const int count = parameter.count_parameter;
      int32_t elements = count < 0 ? 1 : std::max(0, ValueOf(operands[Index(count)]));
      if (parameter.elements_on_card) {
        elements = static_cast<int32_t>(
            controller_.commands().Elements(instruction.op, i, ValueOf(operands[0])));
      }
      const auto slots = static_cast<uint32_t>(parameter.slots.size()) *
                         static_cast<uint32_t>(std::min(elements, vm::kSlotCount));
      AddOperand(operands[i], slots, command->parameters[i].passing == gtcalls::Passing::kOutput);
    }
    for (const gtcalls::Access& access : command->accesses) AddResource(access, operands);
  }

  static size_t Index(int number) { return static_cast<size_t>(number); }

  void AddResource(const gtcalls::Access& access, const std::vector<vm::Operand>& operands) {
    // Accesses of a thread to itself order nothing, and only time changes the clock.
    if (access.resource == Resource::kNone || access.resource == Resource::kThread) return;
    if (access.resource == Resource::kClock) return;
    // The operand is the variable itself.
    if (access.resource == Resource::kVariable) return;
    if (precise_ && access.part != Part::kWhole) return AddPart(access, operands);
    if (access.selector < 0 || Index(access.selector) >= operands.size()) {
      return Add(access.resource, Touched::kAll, access.write);
    }
    if (IsOfAxis(access.resource) && !AxesAreApart()) {
      return Add(access.resource, Touched::kAll, access.write);
    }
    const auto value = static_cast<uint32_t>(ValueOf(operands[Index(access.selector)]));
    if (access.mask) {
      // The bits behind the axes are coordinate systems, which can have any axes.
      if (value >> controller_.motion().axis_count() != 0) {
        return Add(access.resource, Touched::kAll, access.write);
      }
      for (uint32_t bit = 0; bit < 32; ++bit) {
        if ((value >> bit & 1) != 0) Add(access.resource, bit + 1, access.write);
      }
      return;
    }
    const int counting = access.count_parameter;
    const int32_t count = counting < 0 || Index(counting) >= operands.size()
                              ? 1
                              : std::clamp(ValueOf(operands[Index(counting)]), 0, 32);
    for (uint32_t i = 0; i < static_cast<uint32_t>(count); ++i) {
      Add(access.resource, value + i, access.write);
    }
  }

  uint32_t Parameter(int index, const std::vector<vm::Operand>& operands) const {
    return index < 0 || Index(index) >= operands.size()
               ? 0
               : static_cast<uint32_t>(ValueOf(operands[Index(index)]));
  }

  void AddPart(const gtcalls::Access& access, const std::vector<vm::Operand>& operands) {
    const uint32_t detail = Parameter(access.detail, operands);
    const auto add_bits = [&](uint32_t bits) {
      Add(access.resource, Parameter(access.selector, operands), access.write, bits);
    };
    // A number out of range is refused.
    const auto bit_of = [](uint32_t number) {
      return number < Touched::kFirstChannel ? uint32_t{1} << number : uint32_t{0};
    };
    switch (access.part) {
      case Part::kBit:
        return add_bits(bit_of(detail - static_cast<uint32_t>(access.first)));
      case Part::kBits:
        return add_bits((uint32_t{1} << Touched::kFirstChannel) - 1);
      case Part::kChannel:
        return add_bits(bit_of(detail) << Touched::kFirstChannel);
      case Part::kNumbers: {
        const uint32_t count =
            access.detail_count < 0 ? 1 : Parameter(access.detail_count, operands);
        for (uint32_t i = 0; i < std::min(count, kCountMax); ++i) {
          Add(access.resource, detail + i, access.write);
        }
        return;
      }
      case Part::kEnableOutputs:
        return Add(access.resource, static_cast<uint32_t>(access.first), access.write,
                   EnableOutputsOf(detail));
      case Part::kWhole:
      case Part::kSelected:
      case Part::kStopped:
      case Part::kStoppedAxis:
      case Part::kPathAxes:
        break;
    }
    if (!AxesAreApart()) return Add(access.resource, Touched::kAll, access.write);
    const Selection selection = SelectionOf(access.part, detail);
    const uint32_t selected = access.resource == Resource::kCrd ? selection.crds : selection.axes;
    for (uint32_t bit = 0; bit < 32; ++bit) {
      if ((selected >> bit & 1) != 0) Add(access.resource, bit + 1, access.write);
    }
  }

  /// Bit n: the output n enables the axis, which counts from 1.
  uint32_t EnableOutputsOf(uint32_t axis) const {
    uint32_t outputs = 0;
    uint32_t bit = 1;
    for (const int8_t enabled : controller_.motion().state().enable_axes) {
      if (enabled >= 0 && static_cast<uint32_t>(enabled) + 1 == axis) outputs |= bit;
      bit <<= 1;
    }
    return outputs;
  }

  /// Axes and coordinate systems; bit 0 is the first one.
  struct Selection {
    uint32_t axes = 0;
    uint32_t crds = 0;
  };
  /// What a command selects with a mask or an axis, and what it reaches by that.
  Selection SelectionOf(Part part, uint32_t detail) const {
    const motion::MotionCore& motion = controller_.motion();
    const size_t axis_count = motion.axis_count();
    const uint32_t all = (uint32_t{1} << axis_count) - 1;
    Selection selection;
    if (part == Part::kPathAxes) {
      selection.crds = detail;
    } else if (part == Part::kStoppedAxis) {
      if (detail >= 1 && detail <= axis_count) selection.axes = uint32_t{1} << (detail - 1);
    } else {
      selection = {detail & all, controller_.family().crds_of_mask(detail, axis_count)};
    }
    const bool stops = part == Part::kStopped || part == Part::kStoppedAxis;
    const uint32_t named = selection.axes;
    uint32_t bit = 1;
    for (const motion::Crd& crd : motion.state().crds) {
      const uint32_t members = MembersOf(crd, axis_count);
      if (stops && (members & named) != 0) selection.crds |= bit;
      if ((selection.crds & bit) != 0) selection.axes |= MovesOthers(crd) ? all : members;
      bit <<= 1;
    }
    return selection;
  }
  static uint32_t MembersOf(const motion::Crd& crd, size_t axis_count) {
    uint32_t members = 0;
    for (size_t profile = 0; crd.exists() && profile < axis_count; ++profile) {
      if (crd.HasMember(profile)) members |= uint32_t{1} << profile;
    }
    return members;
  }
  /// True if buffered commands of the coordinate system move axes that do not belong to it.
  static bool MovesOthers(const motion::Crd& crd) {
    return crd.gear_count != 0 || std::ranges::any_of(crd.fifos, &motion::CrdFifo::awaits_move);
  }

  /// The profile, encoder, controller and pulse output of an axis normally have its number, but not
  /// in a gantry or with another mapping in the configuration. Then a command for one axis may
  /// access any other.
  bool AxesAreApart() const {
    const motion::MotionState& state = controller_.motion().state();
    const auto own_or_none = [](int8_t number, size_t own) {
      return number < 0 || static_cast<size_t>(number) == own;
    };
    for (size_t i = 0; i < state.axes.size(); ++i) {
      const uint32_t bit = uint32_t{1} << i;
      if (state.axes[i].profile_map != bit || state.axes[i].encoder_map != bit ||
          !own_or_none(state.controls[i].axis, i) || !own_or_none(state.controls[i].encoder, i) ||
          !own_or_none(state.steps[i].axis, i)) {
        return false;
      }
    }
    return true;
  }

  /// More elements than any command has.
  static constexpr uint32_t kCountMax = 32;

  const Controller& controller_;
  bool precise_;
  const vm::Machine& machine_;
  const vm::ThreadState& state_;
  const vm::Object& object_;
  StatementAccess access_;
};

bool Depend(const Touched& one, const Touched& other) {
  if (!one.write && !other.write) return false;
  if (one.resource == Resource::kEverything || other.resource == Resource::kEverything) {
    return one.resource != Resource::kVariable && other.resource != Resource::kVariable;
  }
  return one.resource == other.resource && (one.bits & other.bits) != 0 &&
         (one.number == other.number || one.number == Touched::kAll ||
          other.number == Touched::kAll);
}

std::string_view NameOf(Resource resource) {
  switch (resource) {
    case Resource::kNone:
    case Resource::kEverything:
      return "card";
    case Resource::kClock:
      return "clock";
    case Resource::kThread:
      return "thread";
    case Resource::kVariable:
      return "variable";
    case Resource::kProgram:
      return "program";
    case Resource::kDigitalInput:
      return "di";
    case Resource::kDigitalOutput:
      return "do";
    case Resource::kAnalog:
      return "analog";
    case Resource::kExtension:
      return "extension module";
    case Resource::kAxis:
      return "axis";
    case Resource::kEncoder:
      return "encoder";
    case Resource::kControl:
      return "control";
    case Resource::kCrd:
      return "crd";
    case Resource::kCapture:
      return "capture";
    case Resource::kCompare:
      return "compare";
    case Resource::kPvtTable:
      return "PVT table";
    case Resource::kUserVariable:
      return "user variable";
    case Resource::kConfiguration:
      break;
  }
  return "configuration";
}

}  // namespace

bool IsOfAxis(Resource resource) {
  return resource == Resource::kAxis || resource == Resource::kEncoder ||
         resource == Resource::kControl;
}

void AddAccesses(const StatementAccess& from, StatementAccess* to) {
  for (const Touched& touched : from) {
    if (std::ranges::find(*to, touched) == to->end()) to->push_back(touched);
  }
}

StatementAccess NextAccess(const Controller& controller, int thread) {
  return NextStatement(controller, thread, false).Access();
}

StatementAccess NextPreciseAccess(const Controller& controller, int thread) {
  return NextStatement(controller, thread, true).Access();
}

const Touched* FindDependence(const StatementAccess& one, const StatementAccess& other) {
  for (const Touched& touched : one) {
    for (const Touched& with : other) {
      if (!Depend(touched, with)) continue;
      return touched.number == Touched::kAll ? &with : &touched;
    }
  }
  return nullptr;
}

std::vector<bool> AwaitedGlobals(const vm::Object& object, const gtcalls::Catalogue& catalogue) {
  std::vector<bool> slots;
  const auto add = [&](const vm::Operand& operand) {
    vm::ForEachSlot(operand, vm::Storage::kGlobal, [&](uint32_t slot) {
      if (slots.size() <= slot) slots.resize(size_t{slot} + 1);
      slots[slot] = true;
    });
  };
  for (const vm::Function& function : object.functions) {
    for (const vm::Instruction& instruction : function.instructions) {
      if (instruction.opcode != vm::Opcode::kCommand) continue;
      const gtcalls::Command* command = catalogue.Find(instruction.op);
      if (command == nullptr) continue;
      const auto writes_thread = [](const gtcalls::Access& access) {
        return access.resource == Resource::kThread && access.write;
      };
      if (std::ranges::none_of(command->accesses, writes_thread)) continue;
      for (const gtcalls::Access& access : command->accesses) {
        if (access.resource != Resource::kVariable || access.selector < 0) continue;
        add(instruction.operands[static_cast<size_t>(access.selector)]);
      }
    }
  }
  return slots;
}

Message DescribeRacingPair(const std::string& what, const PlacedAccess& first,
                           const PlacedAccess& second) {
  const auto does = [](const PlacedAccess& access) {
    return access.writes ? Message{"writes", "写"} : Message{"reads", "读"};
  };
  return {
      fmt::format("thread {} {} {} in line {}, thread {} {} it in line {}", first.thread,
                  does(first).en, what, first.line, second.thread, does(second).en, second.line),
      fmt::format("线程 {} 在第 {} 行{} {}，线程 {} 在第 {} 行{}它", first.thread, first.line,
                  does(first).zh, what, second.thread, second.line, does(second).zh)};
}

Message DescribeDataRace(const std::string& what, const PlacedAccess& first,
                         const PlacedAccess& second) {
  const Message pair = DescribeRacingPair(what, first, second);
  return {"data race: " + pair.en + ", and nothing orders the two",
          "数据竞争：" + pair.zh + "，两者之间没有顺序"};
}

std::string NameOf(const Touched& touched, const vm::Object& object) {
  if (touched.resource == Resource::kVariable && touched.number != Touched::kAll) {
    return NameOfSlot({true, 0, static_cast<uint16_t>(touched.number)}, 0, object);
  }
  const std::string_view name = NameOf(touched.resource);
  return touched.number == Touched::kAll ? std::string(name)
                                         : fmt::format("{} {}", name, touched.number);
}

}  // namespace oncard::runtime
