#include "explore/models/cycle_accesses.h"

#include <algorithm>

#include "explore/models/word_key.h"
#include "runtime/observe/lasting_access.h"
#include "vm/operand_slots.h"

namespace oncard::explore {
namespace {

using gtcalls::Resource;
using runtime::StatementAccess;
using runtime::Touched;

/// Longer functions are not looked at: what is known of each statement grows with their length.
constexpr size_t kStatementsMax = 4096;

/// The number of a statement with a command in CycleAccesses::by_code_.
constexpr uint32_t kByCommand = ~uint32_t{0};
/// What LookAt() returns behind the last statement.
constexpr uint32_t kNothing = ~uint32_t{0};

/// True if a command leaves threads and their data pages as they are, except that its own thread
/// may wait.
bool LeavesPrograms(const gtcalls::Command* command) {
  if (command == nullptr) return false;
  if (command->Touches(Resource::kProgram) || command->Touches(Resource::kEverything)) return false;
  return !command->Touches(Resource::kThread) || command->Touches(Resource::kClock) ||
         command->Touches(Resource::kVariable);
}

bool IsCommand(const vm::Instruction& instruction) {
  return instruction.opcode == vm::Opcode::kCommand;
}

}  // namespace

void CycleAccesses::Parts::Add(const Touched& touched) {
  const bool of_program =
      touched.resource == Resource::kProgram || touched.resource == Resource::kThread;
  StatementAccess& part = of_program ? program : card;
  if (std::ranges::find(part, touched) == part.end()) part.push_back(touched);
}

bool CycleAccesses::Parts::DependOn(const Parts& other) const {
  return runtime::FindDependence(program, other.program) != nullptr ||
         runtime::FindDependence(card, other.card) != nullptr;
}

bool CycleAccesses::Possible(const CardModel& model) {
  const gtcalls::Catalogue& catalogue = model.controller().family().catalogue;
  const auto is_known = [&](const vm::Instruction& instruction) {
    return !IsCommand(instruction) || LeavesPrograms(catalogue.Find(instruction.op));
  };
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    const vm::Function& function =
        model.image()->object.functions[static_cast<size_t>(model.setup(thread).function)];
    if (function.instructions.size() > kStatementsMax) return false;
    if (!std::ranges::all_of(function.instructions, is_known)) return false;
    for (const vm::Assert& assert : function.asserts) {
      if (!model.AccessOfAssert(thread, assert)) return false;
    }
  }
  return true;
}

CycleAccesses::CycleAccesses(const CardModel& model, CardSteps* rows)
    : object_(model.image()->object),
      card_(model.controller()),
      rows_(*rows),
      functions_(rows->thread_count()),
      places_(rows->thread_count()),
      by_code_(rows->thread_count()) {
  for (const Touched& touched : model.WatchedAccess()) watched_.Add(touched);
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    functions_[rows->PlaceOf(thread)] = static_cast<size_t>(model.setup(thread).function);
  }
  for (size_t place = 0; place < functions_.size(); ++place) {
    const vm::Function& function = object_.functions[functions_[place]];
    code_.emplace_back(function, card_.family().catalogue);
    places_[place].resize(function.instructions.size() + 1);
    for (const vm::Instruction& instruction : function.instructions) {
      by_code_[place].push_back(IsCommand(instruction) ? kByCommand
                                                       : NumberOf(OperandsOf(instruction, place)));
    }
  }
  AddAsserts(model);
  AddWaits(model);
}

void CycleAccesses::AddAsserts(const CardModel& model) {
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    const size_t place = rows_.PlaceOf(thread);
    for (const vm::Assert& assert : object_.functions[functions_[place]].asserts) {
      Place& asserted = places_[place][assert.position];
      asserted.asserted = true;
      See(NumberOf(*model.AccessOfAssert(thread, assert)), &asserted);
    }
  }
}

void CycleAccesses::AddWaits(const CardModel& model) {
  const std::vector<bool> awaited =
      runtime::AwaitedGlobals(object_, model.controller().family().catalogue);
  StatementAccess reads;
  for (uint32_t slot = 0; slot < awaited.size(); ++slot) {
    if (awaited[slot]) reads.push_back({Resource::kVariable, slot});
  }
  if (reads.empty()) return;
  // A thread that waits stands behind its command, wherever that is.
  const uint32_t number = NumberOf(reads);
  for (std::vector<Place>& places : places_) {
    for (Place& place : places) See(number, &place);
  }
}

StatementAccess CycleAccesses::OperandsOf(const vm::Instruction& instruction, size_t place) const {
  const bool computes =
      instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
  const auto thread = static_cast<size_t>(rows_.NumberOnCard(place));
  StatementAccess access = {
      {Resource::kProgram, static_cast<uint32_t>(thread), true},
      {Resource::kThread, card_.machine().thread(static_cast<int>(thread)).page, true}};
  const auto add = [&](const vm::Operand& operand, bool write) {
    vm::ForEachSlot(operand, vm::Storage::kGlobal, [&](uint32_t slot) {
      access.push_back({Resource::kVariable, slot, write});
    });
    const vm::Variable* index = vm::IndexVariableOf(operand);
    if (index == nullptr || index->storage != vm::Storage::kGlobal) return;
    access.push_back({Resource::kVariable, index->id});
  };
  for (size_t i = 0; i < instruction.operands.size(); ++i) {
    add(instruction.operands[i], computes && i + 1 == instruction.operands.size());
  }
  return access;
}

uint32_t CycleAccesses::NumberOf(const StatementAccess& accesses) {
  key_.clear();
  for (const Touched& touched : accesses) {
    key_.insert(key_.end(), {static_cast<int64_t>(touched.resource), touched.number, touched.write,
                             touched.bits});
  }
  return accesses_.NumberOf(KeyOfWords(key_), [&] {
    Access access;
    Parts written;
    for (const Touched& touched : accesses) {
      access.parts.Add(touched);
      if (touched.write) written.Add(touched);
    }
    access.visible = written.DependOn(watched_);
    return access;
  });
}

void CycleAccesses::Begin() {
  grown_ = false;
  for (std::vector<Place>& places : places_) {
    for (Place& place : places) {
      place.looked = false;
      place.future = {};
      place.meets.clear();
    }
  }
}

void CycleAccesses::See(uint32_t access, Place* place) {
  if (std::ranges::find(place->seen, access) != place->seen.end()) return;
  place->seen.push_back(access);
  grown_ = true;
}

bool CycleAccesses::Active(const Row& row, size_t place) const {
  const CardRows::Position& thread = rows_.PositionOf(row, place);
  return thread.running && thread.wake_cycle <= rows_.CycleOf(row);
}

int64_t CycleAccesses::MostOf(const Row& row, size_t place) const {
  if (!Active(row, place)) return 0;
  const uint32_t position = rows_.PositionOf(row, place).pc;
  const CycleCode& code = code_[place];
  return position < by_code_[place].size() ? code.MostFrom(position) : 0;
}

uint32_t CycleAccesses::NextOf(const Row& row, size_t place) {
  const uint32_t by_code = by_code_[place][rows_.PositionOf(row, place).pc];
  if (by_code != kByCommand) return by_code;
  return recent_commands_.Of({static_cast<uint32_t>(place), CardRows::ThreadNumber(row, place),
                              rows_.GlobalsNumber(row), rows_.BodyNumber(row)},
                             [&]() -> const uint32_t& { return FindCommand(row, place); });
}

const uint32_t& CycleAccesses::FindCommand(const Row& row, size_t place) {
  const CardRows::Body& body = rows_.BodyOf(row);
  key_.assign({static_cast<int64_t>(place), CardRows::ThreadNumber(row, place),
               rows_.GlobalsNumber(row), body.apart,
               body.apart ? body.parts[runtime::BodyDivision::kRest] : rows_.BodyNumber(row)});
  return commands_.Of(KeyOfWords(key_), [&] {
    rows_.Load(row);
    return NumberOf(runtime::NextLastingAccess(card_, rows_.NumberOnCard(place)));
  });
}

uint32_t CycleAccesses::LookAt(const Row& row, size_t place) {
  const uint32_t position = rows_.PositionOf(row, place).pc;
  if (position >= by_code_[place].size()) return kNothing;
  const uint32_t access = NextOf(row, place);
  See(access, &places_[place][position]);
  return access;
}

bool CycleAccesses::Meets(uint32_t access, size_t place, size_t position) {
  Place& from = places_[place][position];
  if (from.meets.size() <= access) from.meets.resize(size_t{access} + 1, -1);
  int8_t& meets = from.meets[access];
  if (meets >= 0) return meets != 0;
  if (!from.looked) {
    const auto add = [&](const Place& reached) {
      for (const uint32_t seen : reached.seen) {
        const Parts& parts = accesses_[seen].parts;
        for (const Touched& touched : parts.program) from.future.Add(touched);
        for (const Touched& touched : parts.card) from.future.Add(touched);
      }
    };
    for (const size_t reached : code_[place].ReachedFrom(position)) add(places_[place][reached]);
    if (position + 1 == places_[place].size()) add(from);
    from.looked = true;
  }
  meets = accesses_[access].parts.DependOn(from.future) ? 1 : 0;
  return meets != 0;
}

bool CycleAccesses::NobodyNotices(const Row& row, size_t place, uint32_t access, uint32_t frozen) {
  if (access == kNothing || accesses_[access].visible) return false;
  const CardRows::Position& thread = rows_.PositionOf(row, place);
  if (thread.waiting || places_[place][thread.pc].asserted) return false;
  for (size_t other = 0; other < rows_.thread_count(); ++other) {
    const bool silent = other == place || (frozen >> other & 1) != 0 || !Active(row, other);
    if (!silent && Meets(access, other, rows_.PositionOf(row, other).pc)) return false;
  }
  return true;
}

}  // namespace oncard::explore
