#include "explore/models/races.h"

#include <bit>
#include <span>

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
    : sync_(sync), clocks_(static_cast<size_t>(model.thread_count())) {}

Race RaceDetector::BeforeStep(const Model& model, int thread) {
  if (model.NextIsPrivate(thread)) return {};
  const AccessSet access = model.NextAccess(thread);
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
