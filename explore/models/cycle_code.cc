#include "explore/models/cycle_code.h"

#include <algorithm>
#include <variant>

namespace oncard::explore {
namespace {

using gtcalls::Resource;

/// True for the condition of a jump or return that always holds.
bool IsLiteral(const vm::Operand& condition) {
  return std::holds_alternative<vm::Immediate>(condition);
}

}  // namespace

std::vector<size_t> FollowersOf(const vm::Function& function, size_t position) {
  const vm::Instruction& instruction = function.instructions[position];
  const bool jumps = instruction.opcode == vm::Opcode::kJump;
  const bool always = (jumps || instruction.opcode == vm::Opcode::kReturn) &&
                      IsLiteral(instruction.operands.front());
  std::vector<size_t> followers;
  const auto add = [&](int64_t target) {
    const auto size = static_cast<int64_t>(function.instructions.size());
    if (target >= 0 && target < size) followers.push_back(static_cast<size_t>(target));
  };
  const auto at = static_cast<int64_t>(position);
  if (!always) add(at + 1);
  if (jumps) add(at + instruction.displacement);
  return followers;
}

bool Delays(const vm::Instruction& instruction, const gtcalls::Catalogue& catalogue) {
  if (instruction.opcode != vm::Opcode::kCommand) return false;
  const gtcalls::Command* command = catalogue.Find(instruction.op);
  if (command == nullptr || instruction.operands.size() != 1) return false;
  if (!command->Touches(Resource::kThread) || !command->Touches(Resource::kClock)) return false;
  // A thread with a time that is computed may go on at once.
  const auto* time = std::get_if<vm::Immediate>(&instruction.operands.front());
  return time != nullptr && time->raw >> vm::kFractionBits > 0;
}

CycleCode::CycleCode(const vm::Function& function, const gtcalls::Catalogue& catalogue) {
  const size_t count = function.instructions.size();
  std::vector<std::vector<size_t>> before(count);
  std::vector<size_t> unknown(count);  // of each statement how many of its next ones are unknown
  std::vector<size_t> known;           // statements whose next ones are all known
  for (size_t position = 0; position < count; ++position) {
    const bool delays = Delays(function.instructions[position], catalogue);
    next_.push_back(delays ? std::vector<size_t>() : FollowersOf(function, position));
    unknown[position] = next_.back().size();
    if (next_.back().empty()) known.push_back(position);
    for (const size_t next : next_.back()) before[next].push_back(position);
  }
  // What is never known is in a loop, or comes to one.
  most_.assign(count, kUnlimited);
  most_.push_back(0);
  while (!known.empty()) {
    const size_t position = known.back();
    known.pop_back();
    int64_t most = 0;
    for (const size_t next : next_[position]) most = std::max(most, most_[next]);
    most_[position] = most + 1;
    for (const size_t previous : before[position]) {
      if (--unknown[previous] == 0) known.push_back(previous);
    }
  }
}

std::vector<size_t> CycleCode::ReachedFrom(size_t position) const {
  std::vector<bool> reached(next_.size(), false);
  std::vector<size_t> open;
  const auto reach = [&](size_t statement) {
    if (reached[statement]) return;
    reached[statement] = true;
    open.push_back(statement);
  };
  if (position < next_.size()) reach(position);
  while (!open.empty()) {
    const size_t statement = open.back();
    open.pop_back();
    for (const size_t next : next_[statement]) reach(next);
  }
  std::vector<size_t> positions;
  for (size_t statement = 0; statement < reached.size(); ++statement) {
    if (reached[statement]) positions.push_back(statement);
  }
  return positions;
}

}  // namespace oncard::explore
