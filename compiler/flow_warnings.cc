#include "compiler/flow_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vm/arithmetic.h"

namespace oncard::compiler {
namespace {

using vm::Instruction;
using vm::Opcode;
using vm::Storage;
using vm::Symbol;

// New positions and velocities take effect with GT_Update (GTS manual chapter 7).
constexpr std::string_view kUpdate = "GT_Update";
constexpr std::string_view kWaitForUpdate[] = {"GT_SetPos", "GT_SetVel"};

// What sets up a trap or jog motion, which GT_Update then starts; the first argument is the axis.
constexpr std::string_view kSetsUp[] = {"GT_PrfTrap",   "GT_PrfJog", "GT_SetTrapPrm",
                                        "GT_SetJogPrm", "GT_SetPos", "GT_SetVel"};

constexpr int kNone = -1;

bool IsCommand(const Instruction& instruction, std::string_view name,
               const gtcalls::Catalogue& catalogue) {
  return instruction.opcode == Opcode::kCommand && catalogue.Find(instruction.op)->name == name;
}

// The value of a command's first argument, if it is a whole number.
std::optional<int64_t> FirstNumber(const Instruction& instruction) {
  const auto* number = std::get_if<vm::Immediate>(&instruction.operands[0]);
  constexpr int64_t kOne = int64_t{1} << vm::kFractionBits;
  if (number == nullptr || number->raw % kOne != 0) return std::nullopt;
  return number->raw / kOne;
}

bool IsAlways(const Instruction& instruction) {
  return std::holds_alternative<vm::Immediate>(instruction.operands[0]);
}

// Variables by the slots that they occupy.
class Slots {
 public:
  explicit Slots(const std::vector<Symbol>& symbols) : symbols_(symbols) {
    for (size_t i = 0; i < symbols.size(); ++i) {
      const size_t end = static_cast<size_t>(symbols[i].id) + symbols[i].slots();
      if (by_slot_.size() < end) by_slot_.resize(end, kNone);
      std::fill(by_slot_.begin() + symbols[i].id,
                by_slot_.begin() + static_cast<std::ptrdiff_t>(end), static_cast<int>(i));
    }
  }

  int At(size_t slot) const { return slot < by_slot_.size() ? by_slot_[slot] : kNone; }
  const Symbol& operator[](int index) const { return symbols_[static_cast<size_t>(index)]; }
  size_t size() const { return symbols_.size(); }

 private:
  const std::vector<Symbol>& symbols_;
  std::vector<int> by_slot_;
};

// The variables of one storage that an instruction reads, writes, and passes by address.
struct Uses {
  std::vector<int> reads, writes, addresses;
};

class UseFinder {
 public:
  UseFinder(Storage storage, const Slots& slots, const gtcalls::Catalogue& catalogue)
      : storage_(storage), slots_(slots), catalogue_(catalogue) {}

  Uses Find(const Instruction& instruction) const {
    Uses uses;
    const size_t count = instruction.operands.size();
    const bool computes =
        instruction.opcode == Opcode::kUnary || instruction.opcode == Opcode::kBinary;
    const vm::CommandShape* shape = instruction.opcode == Opcode::kCommand
                                        ? &catalogue_.ShapeOf(*catalogue_.Find(instruction.op))
                                        : nullptr;
    for (size_t i = 0; i < count; ++i) {
      const vm::Operand& operand = instruction.operands[i];
      const bool address = shape != nullptr && shape->parameters[i].address;
      const bool target = computes && i + 1 == count;
      const size_t slots = address ? std::max<size_t>(1, shape->parameters[i].slots.size()) : 1;
      Add(operand, slots, address ? &uses.addresses : target ? &uses.writes : &uses.reads);
      if (const auto* element = std::get_if<vm::Element>(&operand)) {
        Add(element->index, 1, &uses.reads);
      }
    }
    return uses;
  }

  /// The variable of an operand, or kNone.
  int Of(const vm::Operand& operand) const {
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
      return variable->storage == storage_ ? slots_.At(variable->id) : kNone;
    }
    if (const auto* element = std::get_if<vm::Element>(&operand)) {
      return element->storage == storage_ ? slots_.At(element->base) : kNone;
    }
    return kNone;
  }

 private:
  void Add(const vm::Operand& operand, size_t slots, std::vector<int>* list) const {
    const int first = Of(operand);
    if (first == kNone) return;
    list->push_back(first);
    const auto* variable = std::get_if<vm::Variable>(&operand);
    for (size_t i = 1; variable != nullptr && i < slots; ++i) {
      const int next = slots_.At(variable->id + i);
      if (next != kNone && next != list->back()) list->push_back(next);
    }
  }

  Storage storage_;
  const Slots& slots_;
  const gtcalls::Catalogue& catalogue_;
};

// The paths through a function. The position after the last statement is its end.
class Paths {
 public:
  explicit Paths(const vm::Function& function) : code_(function.instructions) {
    const size_t count = code_.size();
    next_.resize(count + 1);
    before_.resize(count + 1);
    for (size_t i = 0; i < count; ++i) {
      const Instruction& instruction = code_[i];
      const bool leaves =
          instruction.opcode == Opcode::kJump || instruction.opcode == Opcode::kReturn;
      if (!leaves || !IsAlways(instruction)) Add(i, i + 1);
      if (instruction.opcode == Opcode::kJump) {
        Add(i, static_cast<size_t>(static_cast<std::ptrdiff_t>(i) + instruction.displacement));
      }
      if (instruction.opcode == Opcode::kReturn) Add(i, count);
    }
  }

  const std::vector<size_t>& After(size_t at) const { return next_[at]; }
  size_t end() const { return code_.size(); }

  /// The positions that can be reached from a position; it is included only if a path leads back to
  /// it.
  std::vector<bool> ReachedFrom(size_t from) const { return Search({from}, next_); }
  /// The positions from which one of `places` can be reached, and `places` themselves.
  std::vector<bool> ComingTo(const std::vector<size_t>& places) const {
    std::vector<bool> found = Search(places, before_);
    for (const size_t place : places) found[place] = true;
    return found;
  }

 private:
  using Edges = std::vector<std::vector<size_t>>;

  void Add(size_t from, size_t to) {
    next_[from].push_back(to);
    before_[to].push_back(from);
  }
  static std::vector<bool> Search(std::vector<size_t> open, const Edges& edges) {
    std::vector<bool> found(edges.size());
    while (!open.empty()) {
      const size_t at = open.back();
      open.pop_back();
      for (const size_t next : edges[at]) {
        if (found[next]) continue;
        found[next] = true;
        open.push_back(next);
      }
    }
    return found;
  }

  const std::vector<Instruction>& code_;
  Edges next_, before_;
};

// A set of variables for each position in a function.
class VariableSets {
 public:
  VariableSets(size_t positions, size_t variables)
      : words_((variables + kBits - 1) / kBits), bits_(positions * words_) {}

  bool Has(size_t position, int variable) const {
    return (bits_[Word(position, variable)] & Bit(variable)) != 0;
  }
  /// True if it was not there.
  bool Insert(size_t position, int variable) {
    if (Has(position, variable)) return false;
    bits_[Word(position, variable)] |= Bit(variable);
    return true;
  }
  /// Adds the set of another position; true if that changes something.
  bool Join(size_t position, size_t other) {
    uint64_t added = 0;
    for (size_t i = 0; i < words_; ++i) {
      uint64_t& bits = bits_[position * words_ + i];
      const uint64_t more = bits_[other * words_ + i] & ~bits;
      bits |= more;
      added |= more;
    }
    return added != 0;
  }

 private:
  static constexpr size_t kBits = 64;

  size_t Word(size_t position, int variable) const {
    return position * words_ + static_cast<size_t>(variable) / kBits;
  }
  static uint64_t Bit(int variable) {
    return uint64_t{1} << (static_cast<size_t>(variable) % kBits);
  }

  size_t words_;
  std::vector<uint64_t> bits_;
};

// Sets of axes as a mask has them: bit n-1 for axis n.
using AxisBits = uint64_t;
constexpr int64_t kAxesOfMask = 32;
/// Another bit: axes whose numbers are not known.
constexpr AxisBits kUnknownAxis = AxisBits{1} << kAxesOfMask;

AxisBits BitOf(std::optional<int64_t> axis) {
  return axis && *axis >= 1 && *axis <= kAxesOfMask ? AxisBits{1} << (*axis - 1) : kUnknownAxis;
}

// `axis 3`, `axes 1, 2`; and `1 << (1 - 1) | 1 << (2 - 1)`.
struct AxisNames {
  Message names;
  std::string bits;
};

AxisNames NamesOf(AxisBits axes) {
  if (axes == 0) return {{"no axis", "没有轴"}, "0"};
  std::vector<int64_t> numbers;
  for (int64_t axis = 1; axis <= kAxesOfMask; ++axis) {
    if ((axes & BitOf(axis)) != 0) numbers.push_back(axis);
  }
  AxisNames result;
  result.names.en =
      fmt::format("{} {}", numbers.size() == 1 ? "axis" : "axes", fmt::join(numbers, ", "));
  result.names.zh = fmt::format("轴 {}", fmt::join(numbers, "、"));
  for (const int64_t axis : numbers) {
    result.bits += fmt::format("{}1 << ({} - 1)", result.bits.empty() ? "" : " | ", axis);
  }
  return result;
}

class FunctionWarnings {
 public:
  FunctionWarnings(const vm::Function& function, const FunctionPlaces& places,
                   const gtcalls::Catalogue& catalogue, Reporter& reporter)
      : function_(function),
        code_(function.instructions),
        places_(places),
        catalogue_(catalogue),
        reporter_(reporter),
        paths_(function),
        locals_(function.variables),
        finder_(Storage::kLocal, locals_, catalogue) {
    reached_ = paths_.ReachedFrom(0);
    if (!code_.empty()) reached_[0] = true;
  }

  void Unreachable() {
    for (size_t i = 0; i < code_.size(); ++i) {
      if (reached_[i]) continue;
      size_t end = i;
      while (end < code_.size() && !reached_[end]) ++end;
      // A return after an endless loop is a common habit and harmless.
      const bool only_returns =
          end == code_.size() &&
          std::all_of(code_.begin() + static_cast<std::ptrdiff_t>(i), code_.end(),
                      [](const Instruction& rest) { return rest.opcode == Opcode::kReturn; });
      if (!only_returns) reporter_.Report(Code::kUnreachable, places_.statements[i]);
      i = end;
    }
  }

  void EndlessLoop() {
    std::vector<size_t> ways_out = {paths_.end()};
    for (size_t i = 0; i < code_.size(); ++i) {
      // Commands may wait, or read inputs and axes.
      if (code_[i].opcode == Opcode::kCommand) ways_out.push_back(i);
    }
    const std::vector<bool> leaves = paths_.ComingTo(ways_out);
    for (size_t i = 0; i < code_.size(); ++i) {
      if (!reached_[i] || leaves[i]) continue;
      reporter_.Report(Code::kEndlessLoop, places_.statements[i], function_.name);
      return;
    }
  }

  // Variables that are read although no path has written them before.
  void NeverWritten() {
    std::vector<bool> reported(locals_.size());
    const VariableSets written = MayBeWritten();
    for (size_t i = 0; i < code_.size(); ++i) {
      if (!reached_[i]) continue;
      for (const int variable : finder_.Find(code_[i]).reads) {
        const size_t index = static_cast<size_t>(variable);
        if (IsParameter(variable) || written.Has(i, variable) || reported[index]) continue;
        reported[index] = true;
        reporter_.Report(Code::kNeverWritten, places_.statements[i], locals_[variable].name);
      }
    }
  }

  void UnusedResult() {
    std::vector<bool> used(locals_.size());
    for (const Instruction& instruction : code_) {
      const Uses uses = finder_.Find(instruction);
      for (const int variable : uses.reads) used[static_cast<size_t>(variable)] = true;
      for (const int variable : uses.addresses) used[static_cast<size_t>(variable)] = true;
    }
    for (size_t i = 0; i < code_.size(); ++i) {
      for (const int variable : finder_.Find(code_[i]).writes) {
        const size_t index = static_cast<size_t>(variable);
        // All members of a structure may be set for a command that uses only some of them.
        const bool member = locals_[variable].name.find('.') != std::string::npos;
        if (used[index] || member || IsParameter(variable)) continue;
        used[index] = true;
        reporter_.Report(Code::kUnusedResult, places_.statements[i], locals_[variable].name);
      }
    }
  }

  bool CallsUpdate() const {
    return std::any_of(code_.begin(), code_.end(), [this](const Instruction& instruction) {
      return IsCommand(instruction, kUpdate, catalogue_);
    });
  }

  /// The axes that the function sets up.
  AxisBits SetsUp() const {
    AxisBits axes = 0;
    for (size_t i = 0; i < code_.size(); ++i) {
      if (reached_[i]) axes |= SetUpBy(code_[i]);
    }
    return axes;
  }

  /// Warns of masks without any axis that the function has set up before: those that are the number
  /// of such an axis, and those of axes that nothing in the program sets up.
  void WrongMask(AxisBits of_program) {
    if (!CallsUpdate()) return;
    const std::vector<AxisBits> set_up = MayBeSetUp();
    for (size_t i = 0; i < code_.size(); ++i) {
      if (!reached_[i] || !IsCommand(code_[i], kUpdate, catalogue_)) continue;
      const std::optional<int64_t> number = FirstNumber(code_[i]);
      if (!number) continue;
      const AxisBits mask = static_cast<uint32_t>(*number);
      const AxisBits before = set_up[i];
      if (before == 0 || (before & (kUnknownAxis | mask)) != 0) continue;
      const bool elsewhere = (of_program & (kUnknownAxis | mask)) != 0;
      if (elsewhere && (before & BitOf(number)) == 0) continue;
      const AxisNames right = NamesOf(before);
      reporter_.Report(Code::kUpdateMask, places_.statements[i], *number, NamesOf(mask).names,
                       right.names, static_cast<int64_t>(before), std::string_view(right.bits));
    }
  }

  void MissingUpdate() {
    std::vector<size_t> updates;
    for (size_t i = 0; i < code_.size(); ++i) {
      if (IsCommand(code_[i], kUpdate, catalogue_)) updates.push_back(i);
    }
    const std::vector<bool> updated = paths_.ComingTo(updates);
    for (size_t i = 0; i < code_.size(); ++i) {
      const bool waits = std::any_of(
          std::begin(kWaitForUpdate), std::end(kWaitForUpdate),
          [this, i](std::string_view name) { return IsCommand(code_[i], name, catalogue_); });
      if (!waits || !reached_[i] || updated[i]) continue;
      reporter_.Report(Code::kNoUpdate, places_.statements[i], catalogue_.Find(code_[i].op)->name);
      return;
    }
  }

 private:
  AxisBits SetUpBy(const Instruction& instruction) const {
    const bool sets_up = std::any_of(
        std::begin(kSetsUp), std::end(kSetsUp),
        [&](std::string_view name) { return IsCommand(instruction, name, catalogue_); });
    return sets_up ? BitOf(FirstNumber(instruction)) : 0;
  }

  // For each position the axes that a path to it sets up.
  std::vector<AxisBits> MayBeSetUp() const {
    std::vector<AxisBits> before(code_.size() + 1);
    std::vector<size_t> open;
    for (size_t i = 0; i < code_.size(); ++i) {
      if (reached_[i] && SetUpBy(code_[i]) != 0) open.push_back(i);
    }
    while (!open.empty()) {
      const size_t at = open.back();
      open.pop_back();
      const AxisBits after = before[at] | (at < code_.size() ? SetUpBy(code_[at]) : 0);
      for (const size_t next : paths_.After(at)) {
        if ((after & ~before[next]) == 0) continue;
        before[next] |= after;
        open.push_back(next);
      }
    }
    return before;
  }

  bool IsParameter(int variable) const { return locals_[variable].id < places_.parameter_slots; }

  // For each position the locals that a path to it writes.
  VariableSets MayBeWritten() const {
    VariableSets before(code_.size() + 1, locals_.size());
    std::vector<bool> seen(code_.size() + 1);
    std::vector<size_t> open = {0};
    seen[0] = true;
    while (!open.empty()) {
      const size_t at = open.back();
      open.pop_back();
      if (at == code_.size()) continue;
      const Uses uses = finder_.Find(code_[at]);
      for (const size_t next : paths_.After(at)) {
        bool changed = before.Join(next, at);
        for (const int variable : uses.writes) changed |= before.Insert(next, variable);
        for (const int variable : uses.addresses) changed |= before.Insert(next, variable);
        if (seen[next] && !changed) continue;
        seen[next] = true;
        open.push_back(next);
      }
    }
    return before;
  }

  const vm::Function& function_;
  const std::vector<Instruction>& code_;
  const FunctionPlaces& places_;
  const gtcalls::Catalogue& catalogue_;
  Reporter& reporter_;
  Paths paths_;
  Slots locals_;
  UseFinder finder_;
  std::vector<bool> reached_;
};

// A global that no function writes is 0 unless the host writes it.
void WarnAboutDivisors(const vm::Object& object, const std::vector<FunctionPlaces>& places,
                       const gtcalls::Catalogue& catalogue, Reporter& reporter) {
  const Slots globals(object.globals);
  const UseFinder finder(Storage::kGlobal, globals, catalogue);
  std::vector<bool> written(globals.size());
  for (const vm::Function& function : object.functions) {
    for (const Instruction& instruction : function.instructions) {
      const Uses uses = finder.Find(instruction);
      for (const int variable : uses.writes) written[static_cast<size_t>(variable)] = true;
      for (const int variable : uses.addresses) written[static_cast<size_t>(variable)] = true;
    }
  }
  for (size_t f = 0; f < object.functions.size(); ++f) {
    const std::vector<Instruction>& code = object.functions[f].instructions;
    for (size_t i = 0; i < code.size(); ++i) {
      const bool divides = code[i].opcode == Opcode::kBinary &&
                           vm::Divides(static_cast<vm::BinaryOperator>(code[i].op));
      const int divisor = divides ? finder.Of(code[i].operands[1]) : kNone;
      if (divisor == kNone || written[static_cast<size_t>(divisor)]) continue;
      written[static_cast<size_t>(divisor)] = true;
      reporter.Report(Code::kZeroDivisor, places[f].statements[i], globals[divisor].name);
    }
  }
}

}  // namespace

void WarnAboutFlow(const vm::Object& object, const std::vector<FunctionPlaces>& places,
                   const gtcalls::Catalogue& catalogue, Reporter& reporter) {
  std::deque<FunctionWarnings> functions;  // a deque does not move its elements
  for (size_t i = 0; i < object.functions.size(); ++i) {
    functions.emplace_back(object.functions[i], places[i], catalogue, reporter);
  }
  // Another thread may call GT_Update for the registers that this one sets.
  const bool updates = std::any_of(functions.begin(), functions.end(),
                                   [](const auto& function) { return function.CallsUpdate(); });
  AxisBits set_up = 0;
  for (const FunctionWarnings& function : functions) set_up |= function.SetsUp();
  for (FunctionWarnings& function : functions) {
    function.WrongMask(set_up);
    function.Unreachable();
    function.EndlessLoop();
    function.NeverWritten();
    function.UnusedResult();
    if (!updates || function.CallsUpdate()) function.MissingUpdate();
  }
  WarnAboutDivisors(object, places, catalogue, reporter);
}

}  // namespace oncard::compiler
