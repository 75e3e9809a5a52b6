// The only way to execute a command: finds its function, checks the arguments against the
// catalogue, and calls it.
// Tested by tests/gtcalls/card_command_test.cc.
#include "gtcalls/card.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "gtcalls/card_elements.h"

namespace oncard::gtcalls {
namespace {

/// "1-11", or "1-4, 9-11", in characters that both languages use.
std::string SpellEncoders(const motion::MotionCore& core) {
  const size_t axes = core.axis_count();
  if (!core.has_auxiliary()) return fmt::format("1-{}", axes);
  constexpr size_t kLast = motion::kAuxiliaryFirst + motion::kAuxiliaryCount;
  if (axes == motion::kAuxiliaryFirst) return fmt::format("1-{}", kLast);
  return fmt::format("1-{}, {}-{}", axes, motion::kAuxiliaryFirst + 1, kLast);
}

constexpr double kLongMax = 2147483647;
constexpr double kUnsignedLongMax = 4294967295;

struct Bounds {
  double minimum;
  double maximum;
};

/// The range of a parameter's C type on the card, whose long has 32 bits. Masks and bit words of
/// type long may be given as signed or as unsigned numbers.
Bounds BoundsOf(Scalar type, Unit unit) {
  switch (type) {
    case Scalar::kChar:
      return {-128, 127};
    case Scalar::kUnsignedChar:
      return {0, 255};
    case Scalar::kShort:
      return {-32768, 32767};
    case Scalar::kUnsignedShort:
      return {0, 65535};
    case Scalar::kInt:
      return {-kLongMax - 1, kLongMax};
    case Scalar::kLong: {
      const bool bits = unit == Unit::kMask || unit == Unit::kBits;
      return {-kLongMax - 1, bits ? kUnsignedLongMax : kLongMax};
    }
    case Scalar::kUnsignedLong:
      return {0, kUnsignedLongMax};
    case Scalar::kDouble:
      break;
  }
  return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

int16_t CheckValue(Call& call, size_t index) {
  const Parameter& parameter = call.command.parameters[index];
  const double value = call.value(index);
  if (std::isnan(value)) {
    return call.Refuse(vm::kBadParameter, MakeMessage("parameter {0} is not a number",
                                                      "参数 {0} 不是数值", parameter.name));
  }
  if (value < parameter.minimum || value > parameter.maximum) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("parameter {0} is {1}; the range is {2}", "参数 {0} 为 {1}；取值范围为 {2}",
                    parameter.name, value, SpellRange(parameter)));
  }
  const int axes = call.card.motion.config().axis_count;
  if (parameter.axis_number && value > axes) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("parameter {0} is {1}; this card has 1 to {2}",
                    "参数 {0} 为 {1}；本控制卡的编号为 1 到 {2}", parameter.name, value, axes));
  }
  if (parameter.encoder_number && !call.card.motion.HasEncoder(static_cast<size_t>(value) - 1)) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("parameter {0} is {1}; this card has the encoders {2}",
                                   "参数 {0} 为 {1}；本控制卡的编码器为 {2}", parameter.name, value,
                                   SpellEncoders(call.card.motion)));
  }
  const Bounds type = BoundsOf(parameter.type, parameter.unit);
  if (value < type.minimum || value > type.maximum) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("parameter {0} is {1}; its type {2} holds {3} to {4}",
                    "参数 {0} 为 {1}；其类型 {2} 的范围为 {3} 到 {4}", parameter.name, value,
                    SpellScalar(parameter.type), type.minimum, type.maximum));
  }
  return vm::kOk;
}

int16_t CheckPointer(Call& call, size_t index) {
  const Parameter& parameter = call.command.parameters[index];
  const vm::CommandArgument& argument = call.arguments[index];
  if (!argument.null) return vm::kOk;
  if (parameter.nullable) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("parameter {0} is NULL; pass the address of a variable",
                                 "参数 {0} 为 NULL；应传入变量的地址", parameter.name));
}

/// Calls `visit(name, type)` for the cells of a structure in their order, until it returns a code
/// other than 0.
template <typename Visit>
int16_t VisitCells(const Structure& structure, const Visit& visit) {
  for (const Member& member : structure.members) {
    if (member.pointer || (member.structure == nullptr && member.type == Scalar::kChar)) continue;
    for (int i = 0; i < std::max(member.array_size, 1); ++i) {
      const int16_t code = member.structure != nullptr ? VisitCells(*member.structure, visit)
                                                       : visit(member.name, member.type);
      if (code != vm::kOk) return code;
    }
  }
  return vm::kOk;
}

/// Padding members of a structure: hosts do not set them.
bool IsPadding(std::string_view member) { return member.starts_with("pad"); }

/// The values that an input pointer refers to must fit their integer types, like values passed
/// directly: an int of a motion program is wider than a short, and a host's long can be wider than
/// the card's. A long in a structure may be a word of bits, given as an unsigned number. Doubles
/// are checked by the commands that use them.
int16_t CheckCells(Call& call, size_t index) {
  const Parameter& parameter = call.command.parameters[index];
  const std::span<const double> cells = call.cells(index);
  size_t next = 0;
  const auto check = [&](std::string_view name, Scalar type, Unit unit) {
    // The last structure of a list may be incomplete; the command checks whether it has enough.
    if (next == cells.size()) return vm::kOk;
    const double value = cells[next++];
    if (type == Scalar::kDouble) return vm::kOk;
    const Bounds bounds = BoundsOf(type, unit);
    // Written so that the check fails for a NaN.
    if (value >= bounds.minimum && value <= bounds.maximum) return vm::kOk;
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("{0} holds {1}; its type {2} holds {3} to {4}",
                                   "{0} 中的值为 {1}；其类型 {2} 的范围为 {3} 到 {4}", name, value,
                                   SpellScalar(type), bounds.minimum, bounds.maximum));
  };
  int16_t code = vm::kOk;
  while (code == vm::kOk && next < cells.size()) {
    if (parameter.structure == nullptr) {
      code = check(parameter.name, parameter.type, parameter.unit);
    } else {
      code = VisitCells(*parameter.structure, [&](std::string_view member, Scalar type) {
        return check(member, IsPadding(member) ? Scalar::kDouble : type, Unit::kBits);
      });
    }
  }
  return code;
}

/// A range of axes must not go beyond the last one, and every encoder must exist.
int16_t CheckLastAxis(Call& call, size_t index) {
  const int axes = call.card.motion.config().axis_count;
  const int count = call.integer(index);
  const int last = call.integer(0) + count - 1;
  for (int number = call.integer(0); call.command.parameters[0].encoder_number && number <= last;
       ++number) {
    if (call.card.motion.HasEncoder(static_cast<size_t>(number) - 1)) continue;
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("{0} starting at {1} extend to {2}; this card has the encoders {3}",
                    "从 {1} 起共 {0} 个，到 {2} 为止；本控制卡的编码器为 {3}", count,
                    call.integer(0), last, SpellEncoders(call.card.motion)));
  }
  if (!call.command.parameters[0].axis_number || last <= axes) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} starting at {1} extend to {2}; this card has 1 to {3}",
                                 "从 {1} 起共 {0} 个，到 {2} 为止；本控制卡的编号为 1 到 {3}",
                                 count, call.integer(0), last, axes));
}

int16_t CheckArguments(Call& call) {
  assert(call.arguments.size() == call.command.parameters.size());
  for (size_t i = 0; i < call.command.parameters.size(); ++i) {
    const bool by_value = call.command.parameters[i].passing == Passing::kValue;
    int16_t code = by_value ? CheckValue(call, i) : CheckPointer(call, i);
    if (code == vm::kOk && call.command.parameters[i].passing == Passing::kInput && call.given(i)) {
      code = CheckCells(call, i);
    }
    if (code == vm::kOk && call.command.parameters[i].axis_count) code = CheckLastAxis(call, i);
    if (code != vm::kOk) return code;
  }
  return vm::kOk;
}

int16_t Perform(Call& call) {
  const Family& family = call.card.family;
  const CommandFunction function = family.FunctionOf(call.command);
  if (function == nullptr) {
    Message reason =
        MakeMessage("{0} is not supported by this card", "本控制卡不支持 {0}", call.command.name);
    if (const Message* why = family.why_unsupported(call.command)) {
      reason.en += ": " + why->en;
      reason.zh += "：" + why->zh;
    }
    return call.Refuse(family.not_supported, std::move(reason));
  }
  const int16_t code = CheckArguments(call);
  return code != vm::kOk ? code : function(call);
}

/// `code`: what the function has returned.
int16_t Finish(Call& call, int16_t code) {
  const auto finish = call.card.family.finish;
  return call.waits || finish == nullptr ? code : finish(call, code);
}

}  // namespace

int16_t ExecuteCommand(Call& call) { return Finish(call, Perform(call)); }

int16_t ResumeCommand(Call& call) {
  call.waits = false;
  call.ticked = true;
  return Finish(call, call.card.family.FunctionOf(call.command)(call));
}

const vm::CommandShape* CardCommands::Find(uint16_t number) const {
  const Catalogue& catalogue = card_->family.catalogue;
  const Command* command = catalogue.Find(number);
  return command == nullptr ? nullptr : &catalogue.ShapeOf(*command);
}

int64_t CardCommands::Elements(uint16_t number, size_t parameter, double first) const {
  // The number was verified when the program was loaded.
  const Command& command = card_->family.catalogue.commands()[number - 1u];
  return static_cast<int64_t>(ElementsOnCard(command.parameters[parameter], *card_, first));
}

int16_t CardCommands::Execute(uint16_t number, vm::Machine&, int thread,
                              std::span<vm::CommandArgument> arguments) {
  if (prepare_) prepare_();
  // The number was verified when the program was loaded.
  Call call{card_->family.catalogue.commands()[number - 1u], *card_, thread, arguments, {}};
  const int16_t code = Execute(call);
  if (code != vm::kOk && refusals_) refusals_(call, code);
  return code;
}

int16_t CardCommands::Execute(Call& call) {
  if (observer_ == nullptr) return ExecuteCommand(call);
  observer_->BeforeCommand(call);
  const int16_t code = ExecuteCommand(call);
  if (!call.waits) observer_->AfterCommand(call, code);
  return code;
}

int16_t CardCommands::Resume(Call& call) {
  const int16_t code = ResumeCommand(call);
  if (observer_ != nullptr && !call.waits) observer_->AfterCommand(call, code);
  return code;
}

}  // namespace oncard::gtcalls
