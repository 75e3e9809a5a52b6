#include "explore/models/races.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include "runtime/observe/race_steps.h"

namespace oncard::explore {
namespace {

bool Synchronises(const SyncCells& sync, uint32_t cell) { return cell < sync.size() && sync[cell]; }

}  // namespace

std::vector<Race> FindRaces(const Model& model, const SyncCells& sync) {
  std::vector<Race> races;
  for (uint32_t left = model.runnable(); left != 0; left &= left - 1) {
    const int a = std::countr_zero(left);
    if (model.NextIsPrivate(a)) continue;
    const AccessSet of_a = model.NextOwnAccess(a);
    for (uint32_t others = left & (left - 1); others != 0; others &= others - 1) {
      const int b = std::countr_zero(others);
      if (model.NextIsPrivate(b)) continue;
      const AccessSet of_b = model.NextOwnAccess(b);
      const auto add = [&](uint32_t cell) {
        if (Synchronises(sync, cell)) return;
        races.push_back({cell,
                         {a, model.Position(a), of_a.write == cell},
                         {b, model.Position(b), of_b.write == cell}});
      };
      if (of_a.write != AccessSet::kNone && of_b.Touches(of_a.write)) add(of_a.write);
      if (of_b.write != AccessSet::kNone && of_b.write != of_a.write && of_a.Touches(of_b.write)) {
        add(of_b.write);
      }
    }
  }
  return races;
}

// --- With a card ---------------------------------------------------------------------------------

CardRaces::CardRaces(std::vector<bool> ordering, std::vector<int> threads)
    : awaited_(threads.size(), kNone),
      history_(threads.size(), static_cast<size_t>(std::ranges::count(ordering, true))) {
  Program program = {std::move(ordering), {}, std::move(threads)};
  size_t place = 0;
  for (const bool orders : program.ordering) program.places.push_back(orders ? place++ : place);
  program_ = std::make_shared<const Program>(std::move(program));
}

Race CardRaces::BeforeStatement(const runtime::Controller& controller, int thread) {
  const std::vector<size_t>& places = program_->places;
  const auto number = [&](int of) { return program_->threads[static_cast<size_t>(of)]; };
  if (int16_t& awaited = awaited_[static_cast<size_t>(thread)]; awaited != kNone) {
    history_.Acquire(thread, places[static_cast<size_t>(awaited)]);
    awaited = kNone;
  }
  const int position = controller.machine().thread(number(thread)).pc;
  Race found;
  for (const auto& [kind, cell] : NextRaceSteps(controller, number(thread), program_->ordering)) {
    if (kind == runtime::RaceStep::Kind::kAcquire) {
      history_.Acquire(thread, places[cell]);
      continue;
    }
    if (kind == runtime::RaceStep::Kind::kRelease) {
      history_.Release(thread, places[cell]);
      continue;
    }
    const bool writes = kind == runtime::RaceStep::Kind::kWrite;
    const auto other =
        writes ? history_.Write(thread, position, cell) : history_.Read(thread, position, cell);
    if (!other || found) continue;
    found = {cell, {other->thread, other->position, other->writes}, {thread, position, writes}};
    if (!runtime::IsSetByCommands(cell)) continue;
    for (RacingStatement* statement : {&found.first, &found.second}) {
      statement->command = CommandAt(controller, number(statement->thread), statement->position);
    }
  }
  return found;
}

void CardRaces::AfterStatement(const runtime::Controller& controller, int thread) {
  const vm::ThreadState& state =
      controller.machine().thread(program_->threads[static_cast<size_t>(thread)]);
  if (state.waiting && state.wait_slot.global) {
    awaited_[static_cast<size_t>(thread)] = static_cast<int16_t>(state.wait_slot.id);
  }
}

void CardRaces::AddTo(std::vector<int64_t>* words) const {
  words->insert(words->end(), awaited_.begin(), awaited_.end());
  history_.ForEachNumber([&](int64_t number) { words->push_back(number); });
}

// --- Of one run ----------------------------------------------------------------------------------

RaceDetector::RaceDetector(const Model& model, const SyncCells& sync)
    : sync_(sync), clocks_(static_cast<size_t>(model.thread_count())) {}

Race RaceDetector::BeforeStep(const Model& model, int thread) {
  if (model.NextIsPrivate(thread)) return {};
  const AccessSet access = model.NextOwnAccess(thread);
  const int position = model.Position(thread);
  Race found;
  const auto note = [&](uint32_t cell, bool writes) {
    const auto other =
        writes ? clocks_.Write(thread, position, cell) : clocks_.Read(thread, position, cell);
    if (!other || found) return;
    found = {cell, {other->thread, other->position, other->writes}, {thread, position, writes}};
  };
  const std::span<const uint32_t> reads(access.reads.data(), access.read_count);
  for (const uint32_t cell : reads) {
    if (Synchronises(sync_, cell)) clocks_.Acquire(thread, cell);
  }
  for (const uint32_t cell : reads) {
    if (!Synchronises(sync_, cell)) note(cell, false);
  }
  if (access.write == AccessSet::kNone) return found;
  if (Synchronises(sync_, access.write)) {
    clocks_.Release(thread, access.write);
  } else {
    note(access.write, true);
  }
  return found;
}

StateKey RaceDetector::Key() const {
  StateKey key;
  uint32_t place = 0;
  clocks_.ForEachNumber([&](int64_t number) { AddToKey(place++, number, &key); });
  return key;
}

}  // namespace oncard::explore
