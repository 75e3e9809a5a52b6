#include "explore/models/dead_locals.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "explore/models/cycle_code.h"

namespace oncard::explore {
namespace {

constexpr uint32_t kUnknown = ~uint32_t{0};

LocalUse UseOf(const vm::Function& function, size_t position, const CardSteps::Outputs& outputs) {
  const vm::Instruction& instruction = function.instructions[position];
  const bool computes =
      instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
  LocalUse use;
  use.next = FollowersOf(function, position);
  for (size_t i = 0; i < instruction.operands.size(); ++i) {
    const vm::Operand& operand = instruction.operands[i];
    const bool target = computes && i + 1 == instruction.operands.size() &&
                        std::holds_alternative<vm::Variable>(operand);
    if (target) {
      AddOwnLocals(operand, &use.written);
    } else if (std::ranges::find(outputs.operands, i) == outputs.operands.end()) {
      AddNamedLocals(operand, &use.read);
    }
  }
  for (const uint16_t slot : outputs.slots) use.written.set(slot);
  return use;
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

std::vector<LocalSlots> DeadLocals::DeadIn(const OfThread& thread) const {
  const vm::Function& function = object_.functions[thread.function];
  std::vector<LocalUse> uses;
  LocalSlots known;
  for (size_t position = 0; position < function.instructions.size(); ++position) {
    const bool unsure = thread.unsure[position];
    uses.push_back(
        UseOf(function, position,
              unsure ? CardSteps::Outputs() : rows_.OutputsOf(thread.function, position)));
    known |= uses.back().read | uses.back().written;
  }
  std::vector<LocalSlots> dead = LiveLocals(uses);
  dead.emplace_back();
  for (LocalSlots& slots : dead) slots = known & ~slots & ~thread.named;
  return dead;
}

void DeadLocals::LookAt(const Row& row, size_t place) {
  OfThread& thread = threads_[place];
  const uint32_t position = rows_.PositionOf(row, place).pc;
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
  const LocalSlots& dead = thread.dead[std::min(position, thread.dead.size() - 1)];
  std::vector<int64_t> page = all.page;
  for (size_t slot = 0; slot < page.size(); ++slot) {
    if (dead[slot]) page[slot] = 0;
  }
  while (!page.empty() && page.back() == 0) page.pop_back();
  return rows_.NumberOfThread(all.state, std::move(page));
}

}  // namespace oncard::explore
