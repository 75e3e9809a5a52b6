#include "gtcalls/gt400/background.h"

#include <array>
#include <string_view>

#include "gtcalls/gt400/catalogue.h"
#include "gtcalls/gt400/gt400_state.h"
#include "gtcalls/gt400/registers.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gt400 {
namespace {

// The layout of the memory; everything has 16 or 32 bits, the least significant byte first.
constexpr size_t kHeaderSize = 4;  ///< the number of kinds, a reserve
constexpr size_t kKindSize = 4;    ///< InterruptMask, CommandCount
constexpr size_t kCommandSize = 16;
// Members of a command.
constexpr size_t kResultAt = 6;
constexpr size_t kInAt = 8;
constexpr size_t kOutAt = 12;

constexpr uint32_t kDone = 0;
constexpr uint32_t kRefusedResult = 0xFFFF;

uint16_t ReadWord(std::span<const uint8_t> memory, size_t at) {
  return static_cast<uint16_t>(memory[at] | memory[at + 1] << 8);
}

uint32_t ReadLong(std::span<const uint8_t> memory, size_t at) {
  return ReadWord(memory, at) | static_cast<uint32_t>(ReadWord(memory, at + 2)) << 16;
}

void WriteWord(std::span<uint8_t> memory, size_t at, uint32_t value) {
  memory[at] = static_cast<uint8_t>(value);
  memory[at + 1] = static_cast<uint8_t>(value >> 8);
}

void WriteLong(std::span<uint8_t> memory, size_t at, uint32_t value) {
  WriteWord(memory, at, value);
  WriteWord(memory, at + 2, value >> 16);
}

// --- Commands ------------------------------------------------------------------------------------

constexpr uint16_t kAxisFirst = 0x30;  ///< GT_Axis(1), with which the numbers of the others follow
constexpr uint16_t kAxisLast = kAxisFirst + kAxisMax - 1;

/// The command of a number (constants.def); nullptr if there is none.
const Command* FindCommand(uint16_t number) {
  constexpr std::string_view kPrefix = "Intr_";
  const Catalogue& catalogue = Gt400Catalogue();
  for (const Constant& constant : catalogue.constants()) {
    if (constant.value != number || !constant.name.starts_with(kPrefix)) continue;
    const std::string_view name = constant.name.substr(kPrefix.size());
    return catalogue.Find(name == "GT_Intgr" ? "GT_GetIntgr" : name);
  }
  return nullptr;
}

bool IsKnown(uint16_t number) {
  return (number >= kAxisFirst && number <= kAxisLast) || FindCommand(number) != nullptr;
}

/// Reals have 16 bits after the point, jerks 32.
double FractionOf(const Parameter& parameter) {
  return parameter.unit == Unit::kPulsePerSt3 ? 0x1p32 : 0x1p16;
}

double ReadOperand(const Parameter& parameter, uint32_t data) {
  switch (parameter.type) {
    case Scalar::kDouble:
      // A jerk has no sign.
      return parameter.unit == Unit::kPulsePerSt3
                 ? data / FractionOf(parameter)
                 : static_cast<int32_t>(data) / FractionOf(parameter);
    case Scalar::kShort:
      return static_cast<int16_t>(data);
    case Scalar::kUnsignedShort:
      return static_cast<uint16_t>(data);
    default:
      return static_cast<int32_t>(data);
  }
}

uint32_t WriteResult(const Parameter& parameter, double value) {
  const bool real = parameter.type == Scalar::kDouble;
  return static_cast<uint32_t>(
      static_cast<int64_t>(motion::Whole(real ? value * FractionOf(parameter) : value)));
}

/// An Update takes effect in this tick.
bool Update(Card& card, uint32_t axes) { return axes != 0 && !UpdateAtOnce(card, axes); }

/// Executes a command, whose only parameter is its operand or its result; true if it is accepted.
bool Execute(Card& card, const Command& command, std::span<uint8_t> memory) {
  // The sample of the manual has its data in `in` once, and once in `out`.
  const uint32_t in = ReadLong(memory, kInAt);
  const uint32_t data = in != 0 ? in : ReadLong(memory, kOutAt);
  const Gt400State& state = card.state<Gt400State>();
  if (command.name == "GT_Update") return Update(card, 1u << state.current);
  if (command.name == "GT_MltiUpdt") return Update(card, data & ((1u << kAxisMax) - 1));
  std::array<vm::CommandArgument, 1> arguments{};
  double cell = 0;
  const std::span<const Parameter> parameters = command.parameters;
  if (!parameters.empty()) {
    arguments[0].value = ReadOperand(parameters[0], data);
    arguments[0].cells = std::span(&cell, 1);
  }
  Call call{command, card, vm::kHostCaller, std::span(arguments).first(parameters.size()), {}};
  const bool accepted = ExecuteCommand(call) == vm::kOk;
  if (accepted && !parameters.empty() && parameters[0].passing == Passing::kOutput) {
    WriteLong(memory, kOutAt, WriteResult(parameters[0], cell));
  }
  return accepted;
}

void ExecuteOne(Card& card, std::span<uint8_t> memory) {
  const uint16_t number = ReadWord(memory, 0);
  bool accepted = true;
  if (number >= kAxisFirst && number <= kAxisLast) {
    card.state<Gt400State>().current = static_cast<uint8_t>(number - kAxisFirst);
  } else {
    accepted = Execute(card, *FindCommand(number), memory);
  }
  WriteWord(memory, kResultAt, accepted ? kDone : kRefusedResult);
}

}  // namespace

std::optional<Message> CheckBackgroundSet(std::span<const uint8_t> memory, size_t* size) {
  const auto too_short = [&] {
    return MakeMessage("the set does not fit its size of {} bytes", "命令集超出其长度 {} 字节",
                       memory.size());
  };
  if (memory.size() < kHeaderSize) return too_short();
  size_t at = kHeaderSize;
  for (int kind = ReadWord(memory, 0); kind > 0; --kind) {
    if (memory.size() - at < kKindSize) return too_short();
    const size_t commands = ReadWord(memory, at + 2);
    at += kKindSize;
    if ((memory.size() - at) / kCommandSize < commands) return too_short();
    for (size_t i = 0; i < commands; ++i, at += kCommandSize) {
      const uint16_t number = ReadWord(memory, at);
      if (IsKnown(number)) continue;
      return MakeMessage("0x{:02X} is the number of no background command",
                         "0x{:02X} 不是后台命令的编号", number);
    }
  }
  *size = at;
  return std::nullopt;
}

void RunBackgroundSet(Card& card, size_t axis, uint16_t word) {
  Gt400State& state = card.state<Gt400State>();
  auto& set = state.interrupts.answers.background;
  if (!set) return;
  const uint8_t current = state.current;
  const std::span<uint8_t> memory = set->bytes;
  size_t at = kHeaderSize;
  for (int kind = ReadWord(memory, 0); kind > 0; --kind) {
    const bool wanted = (ReadWord(memory, at) & word) != 0;
    const size_t commands = ReadWord(memory, at + 2);
    at += kKindSize;
    state.current = static_cast<uint8_t>(axis);
    for (size_t i = 0; i < commands; ++i, at += kCommandSize) {
      if (wanted) ExecuteOne(card, memory.subspan(at, kCommandSize));
    }
  }
  state.current = current;
}

}  // namespace oncard::gtcalls::gt400
