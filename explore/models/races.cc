#include "explore/models/races.h"

#include <algorithm>
#include <bit>

namespace oncard::explore {
namespace {

bool Synchronises(const SyncCells& sync, uint32_t cell) { return cell < sync.size() && sync[cell]; }

}  // namespace

std::vector<Race> FindRaces(const Model& model, const SyncCells& sync) {
  std::vector<Race> races;
  for (uint32_t left = model.runnable(); left != 0; left &= left - 1) {
    const int a = std::countr_zero(left);
    if (model.NextIsPrivate(a)) continue;
    const AccessSet of_a = model.NextAccess(a);
    for (uint32_t others = left & (left - 1); others != 0; others &= others - 1) {
      const int b = std::countr_zero(others);
      if (model.NextIsPrivate(b)) continue;
      const AccessSet of_b = model.NextAccess(b);
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

// --- Of one run ----------------------------------------------------------------------------------

RaceDetector::RaceDetector(const Model& model, const SyncCells& sync)
    : sync_(sync),
      threads_(static_cast<size_t>(model.thread_count())),
      clocks_(threads_, Clock(threads_, 0)) {
  for (size_t thread = 0; thread < threads_; ++thread) clocks_[thread][thread] = 1;
}

RaceDetector::Cell& RaceDetector::CellAt(uint32_t cell) {
  if (cells_.size() <= cell) cells_.resize(size_t{cell} + 1);
  Cell& found = cells_[cell];
  if (found.reads.empty()) {
    found.reads.resize(threads_);
    found.writes.resize(threads_);
  }
  return found;
}

RaceDetector::Clock& RaceDetector::SyncAt(uint32_t cell) {
  if (sync_clocks_.size() <= cell) sync_clocks_.resize(size_t{cell} + 1);
  sync_clocks_[cell].resize(threads_);
  return sync_clocks_[cell];
}

Race RaceDetector::Unordered(const std::vector<Access>& accesses, bool writes, uint32_t cell,
                             const RacingStatement& present) const {
  const Clock& clock = clocks_[static_cast<size_t>(present.thread)];
  for (size_t other = 0; other < threads_; ++other) {
    const Access& access = accesses[other];
    if (static_cast<int>(other) == present.thread || access.clock <= clock[other]) continue;
    return {cell, {static_cast<int>(other), access.position, writes}, present};
  }
  return {};
}

Race RaceDetector::BeforeStep(const Model& model, int thread) {
  if (model.NextIsPrivate(thread)) return {};
  const AccessSet access = model.NextAccess(thread);
  const auto own = static_cast<size_t>(thread);
  const int position = model.Position(thread);
  Clock& clock = clocks_[own];
  Race found;
  for (uint32_t i = 0; i < access.read_count; ++i) {
    if (!Synchronises(sync_, access.reads[i])) continue;
    const Clock& released = SyncAt(access.reads[i]);
    for (size_t t = 0; t < threads_; ++t) clock[t] = std::max(clock[t], released[t]);
  }
  for (uint32_t i = 0; i < access.read_count; ++i) {
    const uint32_t cell = access.reads[i];
    if (Synchronises(sync_, cell)) continue;
    Cell& touched = CellAt(cell);
    if (!found) found = Unordered(touched.writes, true, cell, {thread, position, false});
    touched.reads[own] = {clock[own], position};
  }
  if (access.write == AccessSet::kNone) return found;
  if (Synchronises(sync_, access.write)) {
    Clock& released = SyncAt(access.write);
    for (size_t t = 0; t < threads_; ++t) released[t] = std::max(released[t], clock[t]);
    ++clock[own];
    return found;
  }
  Cell& touched = CellAt(access.write);
  const RacingStatement present = {thread, position, true};
  if (!found) found = Unordered(touched.writes, true, access.write, present);
  if (!found) found = Unordered(touched.reads, false, access.write, present);
  touched.writes[own] = {clock[own], position};
  return found;
}

StateKey RaceDetector::Key() const {
  StateKey key;
  uint32_t place = 0;
  const auto add = [&](int64_t value) { AddToKey(place++, value, &key); };
  const auto add_clocks = [&](const std::vector<Clock>& clocks) {
    for (const Clock& clock : clocks) {
      add(static_cast<int64_t>(clock.size()));
      for (const uint32_t time : clock) add(time);
    }
  };
  add_clocks(clocks_);
  add_clocks(sync_clocks_);
  for (const Cell& cell : cells_) {
    for (const std::vector<Access>* accesses : {&cell.reads, &cell.writes}) {
      add(static_cast<int64_t>(accesses->size()));
      for (const Access& access : *accesses) {
        add(access.clock);
        add(access.position);
      }
    }
  }
  return key;
}

}  // namespace oncard::explore
