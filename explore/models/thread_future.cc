#include "explore/models/thread_future.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <variant>

#include "vm/object.h"

namespace oncard::explore {
namespace {

/// Maximum product of statements and locals for which each local is looked at.
constexpr size_t kLocalsMax = size_t{1} << 22;

using Slots = std::vector<uint32_t>;  ///< in order

constexpr uint64_t BitOf(uint32_t cell) { return uint64_t{1} << cell % 64; }

Slots UnionOfSlots(const Slots& a, const Slots& b) {
  Slots both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

Slots Sorted(Slots slots) {
  std::ranges::sort(slots);
  return slots;
}

/// What one statement does.
struct Effect {
  AccessBits accesses;
  Slots used;                    ///< locals that it reads
  int64_t set = -1;              ///< the local that it always writes; -1 if there is none
  std::array<size_t, 2> next{};  ///< statements that can follow; the number of all for the end

  void Read(const vm::Variable& variable) {
    if (variable.storage == vm::Storage::kGlobal) {
      accesses.reads |= BitOf(variable.id);
    } else {
      used.push_back(variable.id);
    }
  }
  void Read(const vm::Operand& operand) {
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) Read(*variable);
    const auto* element = std::get_if<vm::Element>(&operand);
    if (element == nullptr) return;
    Read(element->index);
    for (uint32_t i = 0; i < element->size; ++i) {
      Read(vm::Variable{element->storage, static_cast<uint16_t>(element->base + i)});
    }
  }
  void Write(const vm::Operand& operand) {
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
      if (variable->storage == vm::Storage::kGlobal) {
        accesses.writes |= BitOf(variable->id);
      } else {
        set = variable->id;
      }
    }
    const auto* element = std::get_if<vm::Element>(&operand);
    if (element == nullptr) return;
    Read(element->index);
    for (uint32_t i = 0; i < element->size && element->storage == vm::Storage::kGlobal; ++i) {
      accesses.writes |= BitOf(element->base + i);
    }
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
  std::ranges::sort(effect.used);
  effect.used.erase(std::unique(effect.used.begin(), effect.used.end()), effect.used.end());
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
      effect.used = UnionOfSlots(effect.used, Sorted(check.locals));
    });
  }
  if (locals * end > kLocalsMax) {
    for (Effect& effect : effects) effect.used.clear();
    for (uint32_t slot = 0; slot < locals; ++slot) all_.push_back(slot);
  }
  at_.resize(end + 1);
  for (bool grows = true; grows;) {
    grows = false;
    for (size_t i = end; i-- > 0;) {
      const Effect& effect = effects[i];
      Place before = {effect.accesses, {}};
      for (const size_t next : effect.next) {
        before.accesses.Add(at_[next].accesses);
        before.locals = UnionOfSlots(before.locals, at_[next].locals);
      }
      if (effect.set >= 0) std::erase(before.locals, static_cast<uint32_t>(effect.set));
      before.locals = UnionOfSlots(before.locals, effect.used);
      grows = grows || before.accesses.reads != at_[i].accesses.reads ||
              before.accesses.writes != at_[i].accesses.writes ||
              before.locals.size() != at_[i].locals.size();
      at_[i] = std::move(before);
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
