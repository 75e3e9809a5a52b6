#include "runtime/observe/lasting_access.h"

#include <algorithm>

#include "gtcalls/gts/numbers.h"

namespace oncard::runtime {
namespace {

using gtcalls::Resource;

constexpr Touched kEverything = {Resource::kEverything, Touched::kAll, true};

class Widened {
 public:
  explicit Widened(const Controller& controller) : controller_(controller) {}

  StatementAccess Take() { return std::move(access_); }

  void Add(const Touched& touched) {
    if (std::ranges::find(access_, touched) == access_.end()) access_.push_back(touched);
  }
  void AddAllAxes() { Add({Resource::kAxis}); }

  void AddInput(motion::DiType type) {
    if (type != motion::DiType::kGpi) return AddAllAxes();
    for (const motion::PositionSwitch& contact : controller_.motion().state().switches) {
      if (contact.type == type) Add({Resource::kAxis, contact.axis + 1u});
    }
  }

  /// `sets_axis`: the statement sets an axis, too, and with it outputs that enable it.
  void AddTouched(const Touched& touched, bool sets_axis) {
    const auto word = static_cast<int>(touched.number);
    switch (touched.resource) {
      case Resource::kAxis:
      case Resource::kEncoder:
      case Resource::kControl:
        return Add({Resource::kAxis, touched.number, touched.write});
      case Resource::kVariable:
      case Resource::kExtension:
        return Add(touched);
      case Resource::kDigitalInput:
        if (touched.write) return Add(kEverything);
        if (const auto type = gtcalls::gts::DiTypeOf(word)) return AddInput(*type);
        return AddAllAxes();
      case Resource::kDigitalOutput:
        if (gtcalls::gts::DoTypeOf(word) != motion::DoType::kGpo) {
          if (touched.write && !sets_axis) return Add(kEverything);
          if (!touched.write) AddAllAxes();
        }
        return Add(touched);
      case Resource::kPvtTable:
      case Resource::kUserVariable:
      case Resource::kCrd:
      case Resource::kCapture:
      case Resource::kCompare:
        return Add(touched.write ? kEverything : touched);
      case Resource::kAnalog:
        if (touched.write) return Add(kEverything);
        return AddAllAxes();
      default:
        return Add(kEverything);
    }
  }

 private:
  const Controller& controller_;
  StatementAccess access_;
};

}  // namespace

StatementAccess NextLastingAccess(const Controller& controller, int thread) {
  const StatementAccess access = NextPreciseAccess(controller, thread);
  const bool sets_axis = std::ranges::any_of(
      access, [](const Touched& touched) { return touched.write && IsOfAxis(touched.resource); });
  Widened widened(controller);
  widened.Add({Resource::kProgram, static_cast<uint32_t>(thread), true});
  widened.Add({Resource::kThread, controller.machine().thread(thread).page, true});
  for (const Touched& touched : access) widened.AddTouched(touched, sets_axis);
  return widened.Take();
}

StatementAccess LastingAccessOf(const Quantity& quantity, const Controller& controller) {
  Widened widened(controller);
  switch (quantity.kind) {
    case QuantityKind::kVariable:
      widened.Add(quantity.slot.global ? Touched{Resource::kVariable, quantity.slot.id}
                                       : Touched{Resource::kThread, quantity.slot.page});
      break;
    case QuantityKind::kThreadRun:
    case QuantityKind::kThreadResult:
    case QuantityKind::kThreadError:
    case QuantityKind::kThreadLine:
    case QuantityKind::kThreadPage:
      widened.Add({Resource::kProgram, static_cast<uint32_t>(quantity.thread)});
      break;
    case QuantityKind::kInputWord:
    case QuantityKind::kInputBit:
      widened.AddInput(static_cast<motion::DiType>(quantity.word));
      break;
    case QuantityKind::kOutputWord:
    case QuantityKind::kOutputBit:
      if (static_cast<motion::DoType>(quantity.word) != motion::DoType::kGpo) widened.AddAllAxes();
      widened.Add(
          {Resource::kDigitalOutput, Touched::kAll, false,
           quantity.kind == QuantityKind::kOutputBit ? uint32_t{1} << quantity.bit : ~uint32_t{0}});
      break;
    case QuantityKind::kMotion:
      widened.Add(quantity.part->of_axis
                      ? Touched{Resource::kAxis, static_cast<uint32_t>(quantity.index) + 1}
                      : kEverything);
      break;
    case QuantityKind::kClock:
      break;
    // How many statements a thread executes in its waits depends on all the others.
    case QuantityKind::kThreadStatements:
    case QuantityKind::kStatements:
      widened.Add(kEverything);
      break;
  }
  return widened.Take();
}

bool WaitsForVariables(const vm::Object& object, const gtcalls::Catalogue& catalogue) {
  const auto waits = [&](const vm::Instruction& instruction) {
    if (instruction.opcode != vm::Opcode::kCommand) return false;
    const gtcalls::Command* command = catalogue.Find(instruction.op);
    return command == nullptr ||
           (command->Touches(Resource::kThread) && command->Touches(Resource::kVariable));
  };
  return std::ranges::any_of(object.functions, [&](const vm::Function& function) {
    return std::ranges::any_of(function.instructions, waits);
  });
}

}  // namespace oncard::runtime
