#include "explore/models/thread_future.h"

#include <algorithm>
#include <array>
#include <variant>

#include "explore/models/live_locals.h"
#include "vm/object.h"
#include "vm/operand_slots.h"

namespace oncard::explore {
namespace {

/// Maximum product of statements and locals for which each local is looked at.
constexpr size_t kLocalsMax = size_t{1} << 22;

using Slots = std::vector<uint32_t>;  ///< in order

constexpr uint64_t BitOf(uint32_t cell) { return uint64_t{1} << cell % 64; }

Slots SlotsOf(const LocalSlots& locals) {
  Slots slots;
  for (uint32_t slot = 0; slot < locals.size(); ++slot) {
    if (locals[slot]) slots.push_back(slot);
  }
  return slots;
}

/// What one statement does.
struct Effect {
  AccessBits accesses;
  LocalUse locals;
  std::array<size_t, 2> next{};  ///< statements that can follow; the number of all for the end

  void Read(const vm::Operand& operand) {
    vm::ForEachNamedSlot(operand, vm::Storage::kGlobal,
                         [&](uint32_t slot) { accesses.reads |= BitOf(slot); });
    AddNamedLocals(operand, &locals.read);
  }
  void Write(const vm::Operand& operand) {
    vm::ForEachSlot(operand, vm::Storage::kGlobal,
                    [&](uint32_t slot) { accesses.writes |= BitOf(slot); });
    if (std::holds_alternative<vm::Variable>(operand)) AddOwnLocals(operand, &locals.written);
    if (const vm::Variable* index = vm::IndexVariableOf(operand)) Read(*index);
  }
};

Effect EffectOf(const vm::Instruction& instruction, size_t position, size_t end) {
  Effect effect;
  const auto& operands = instruction.operands;
  const bool computes =
      instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
  for (size_t i = 0; i + (computes ? 1 : 0) < operands.size(); ++i) effect.Read(operands[i]);
  if (computes) effect.Write(operands.back());
  effect.next.fill(std::min(position + 1, end));
  if (instruction.opcode == vm::Opcode::kJump) {
    const auto target = static_cast<int64_t>(position) + instruction.displacement;
    effect.next[1] = std::min(static_cast<size_t>(target), end);
  }
  for (const size_t next : effect.next) {
    if (next < end) effect.locals.next.push_back(next);
  }
  return effect;
}

}  // namespace

AccessBits BitsOf(const AccessSet& access) {
  AccessBits bits;
  for (uint32_t i = 0; i < access.read_count; ++i) bits.reads |= BitOf(access.reads[i]);
  if (access.write != AccessSet::kNone) bits.writes |= BitOf(access.write);
  return bits;
}

ThreadFuture::ThreadFuture(const Model& model, int thread) {
  const auto function = static_cast<size_t>(model.setup(thread).function);
  const auto& instructions = model.image().object.functions[function].instructions;
  const size_t end = instructions.size();
  const size_t locals = model.local_count(thread);
  std::vector<Effect> effects;
  for (size_t i = 0; i < end; ++i) {
    effects.push_back(EffectOf(instructions[i], i, end));
    model.ForEachCheck(thread, i, [&effect = effects.back()](const StatementCheck& check) {
      for (const uint32_t cell : check.globals) effect.accesses.reads |= BitOf(cell);
      for (const uint32_t slot : check.locals) effect.locals.read.set(slot);
    });
  }
  at_.resize(end + 1);
  if (locals * end > kLocalsMax) {
    for (uint32_t slot = 0; slot < locals; ++slot) all_.push_back(slot);
  } else {
    std::vector<LocalUse> uses;
    uses.reserve(effects.size());
    for (const Effect& effect : effects) uses.push_back(effect.locals);
    const std::vector<LocalSlots> live = LiveLocals(uses);
    for (size_t i = 0; i < end; ++i) at_[i].locals = SlotsOf(live[i]);
  }
  for (bool grows = true; grows;) {
    grows = false;
    for (size_t i = end; i-- > 0;) {
      AccessBits before = effects[i].accesses;
      for (const size_t next : effects[i].next) before.Add(at_[next].accesses);
      grows = grows || before != at_[i].accesses;
      at_[i].accesses = before;
    }
  }
}

void FindDeadLocals(Model* model) {
  for (int thread = 0; thread < model->thread_count(); ++thread) {
    const ThreadFuture future(*model, thread);
    const auto function = static_cast<size_t>(model->setup(thread).function);
    const size_t statements = model->image().object.functions[function].instructions.size();
    std::vector<Slots> dead(statements);
    for (size_t position = 0; position < statements; ++position) {
      const Slots& alive = future.Locals(static_cast<int>(position));
      for (uint32_t slot = 0; slot < model->local_count(thread); ++slot) {
        if (!std::ranges::binary_search(alive, slot)) dead[position].push_back(slot);
      }
    }
    model->SetDeadLocals(thread, std::move(dead));
  }
}

}  // namespace oncard::explore
