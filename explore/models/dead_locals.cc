#include "explore/models/dead_locals.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "explore/models/cycle_code.h"

namespace oncard::explore {
namespace {

/// Bit n: the local with the slot n.
using LocalSlots = std::bitset<vm::kSlotCount>;

constexpr uint32_t kUnknown = ~uint32_t{0};

/// The locals of an operand that can be read.
void AddLocals(const vm::Operand& operand, LocalSlots* slots) {
  const auto add = [&](const vm::Variable& variable) {
    if (variable.storage == vm::Storage::kLocal) slots->set(variable.id);
  };
  if (const auto* variable = std::get_if<vm::Variable>(&operand)) add(*variable);
  const auto* element = std::get_if<vm::Element>(&operand);
  if (element == nullptr) return;
  add(element->index);
  if (element->storage != vm::Storage::kLocal) return;
  for (size_t i = 0; i < element->size; ++i) slots->set(element->base + i);
}

/// What a statement does with locals.
struct LocalEffect {
  LocalSlots read;
  LocalSlots written;  ///< always
};

LocalEffect LocalEffectOf(const vm::Instruction& instruction, const CardSteps::Outputs& outputs) {
  const bool computes =
      instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
  LocalEffect effect;
  for (size_t i = 0; i < instruction.operands.size(); ++i) {
    const vm::Operand& operand = instruction.operands[i];
    const bool target = computes && i + 1 == instruction.operands.size() &&
                        std::holds_alternative<vm::Variable>(operand);
    if (target) {
      AddLocals(operand, &effect.written);
    } else if (std::ranges::find(outputs.operands, i) == outputs.operands.end()) {
      AddLocals(operand, &effect.read);
    }
  }
  for (const uint16_t slot : outputs.slots) effect.written.set(slot);
  return effect;
}

}  // namespace

DeadLocals::DeadLocals(const CardModel& model, CardSteps* rows)
    : object_(model.image()->object), rows_(*rows), threads_(rows->thread_count()) {
  rows->WatchOutputs();
  uint32_t pages = 0;
  for (int number = 0; number < model.thread_count(); ++number) {
    const ThreadSetup& setup = model.setup(number);
    OfThread& thread = threads_[rows->PlaceOf(number)];
    thread.function = static_cast<size_t>(setup.function);
    thread.page = static_cast<uint8_t>(setup.page);
    thread.unsure.resize(object_.functions[thread.function].instructions.size());
    shares_pages_ = shares_pages_ || (pages >> thread.page & 1) != 0;
    pages |= 1u << thread.page;
    for (const vm::SlotAddress& slot : model.NamedLocals()) {
      if (slot.page == thread.page) thread.named.set(slot.id);
    }
  }
}

void DeadLocals::Begin() {
  grown_ = false;
  for (OfThread& thread : threads_) {
    thread.dead = DeadIn(thread);
    thread.forgotten.clear();
  }
}

std::vector<DeadLocals::Slots> DeadLocals::DeadIn(const OfThread& thread) const {
  const vm::Function& function = object_.functions[thread.function];
  const size_t count = function.instructions.size();
  std::vector<LocalEffect> effects;
  std::vector<std::vector<size_t>> before(count);
  std::vector<size_t> open;
  Slots known;
  for (size_t position = 0; position < count; ++position) {
    const CardSteps::Outputs& outputs = rows_.OutputsOf(thread.function, position);
    const vm::Instruction& instruction = function.instructions[position];
    effects.push_back(
        LocalEffectOf(instruction, thread.unsure[position] ? CardSteps::Outputs() : outputs));
    known |= effects.back().read | effects.back().written;
    for (const size_t next : FollowersOf(function, position)) before[next].push_back(position);
    open.push_back(position);
  }
  std::vector<Slots> live;
  live.reserve(count + 1);
  for (const LocalEffect& effect : effects) live.push_back(effect.read);
  while (!open.empty()) {
    const size_t position = open.back();
    open.pop_back();
    for (const size_t previous : before[position]) {
      const Slots more = live[previous] | (live[position] & ~effects[previous].written);
      if (more == live[previous]) continue;
      live[previous] = more;
      open.push_back(previous);
    }
  }
  live.emplace_back();
  for (Slots& slots : live) slots = known & ~slots & ~thread.named;
  return live;
}

void DeadLocals::LookAt(const Row& row, size_t place) {
  OfThread& thread = threads_[place];
  const uint32_t position = rows_.ThreadOf(row, place).state.pc;
  if (position >= thread.unsure.size() || thread.unsure[position]) return;
  if (rows_.OutputsOf(thread.function, position).slots.empty()) return;
  if (rows_.WritesOutputs(row, place)) return;
  thread.unsure[position] = true;
  grown_ = true;
}

void DeadLocals::Forget(size_t place, Row* row) {
  if (shares_pages_) return;
  OfThread& thread = threads_[place];
  const uint32_t number = CardRows::ThreadNumber(*row, place);
  if (number >= thread.forgotten.size()) thread.forgotten.resize(size_t{number} + 1, kUnknown);
  uint32_t& forgotten = thread.forgotten[number];
  if (forgotten == kUnknown) forgotten = WithoutDead(thread, number);
  rows_.SetThread(place, forgotten, row);
}

uint32_t DeadLocals::WithoutDead(const OfThread& thread, uint32_t number) const {
  const CardRows::Thread& all = rows_.ThreadWith(number);
  const bool runs = all.state.run == vm::ThreadRun::kRunning;
  // What it waits for may be a local. A thread that has failed is shown as it is.
  if (all.state.waiting || (!runs && all.state.run != vm::ThreadRun::kStopped)) return number;
  const size_t position = runs ? all.state.pc : thread.dead.size() - 1;
  const Slots& dead = thread.dead[std::min(position, thread.dead.size() - 1)];
  std::vector<int64_t> page = all.page;
  for (size_t slot = 0; slot < page.size(); ++slot) {
    if (dead[slot]) page[slot] = 0;
  }
  while (!page.empty() && page.back() == 0) page.pop_back();
  return rows_.NumberOfThread(all.state, std::move(page));
}

}  // namespace oncard::explore
