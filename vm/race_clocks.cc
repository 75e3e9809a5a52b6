#include "vm/race_clocks.h"

#include <algorithm>

namespace oncard::vm {

RaceClocks::RaceClocks(size_t threads) : clocks_(threads, Clock(threads, 0)) {
  for (size_t thread = 0; thread < threads; ++thread) clocks_[thread][thread] = 1;
}

RaceClocks::Cell& RaceClocks::CellAt(uint32_t cell) {
  if (cells_.size() <= cell) cells_.resize(size_t{cell} + 1);
  Cell& found = cells_[cell];
  if (found.reads.empty()) {
    found.reads.resize(clocks_.size());
    found.writes.resize(clocks_.size());
  }
  return found;
}

RaceClocks::Clock& RaceClocks::ReleasedAt(uint32_t cell) {
  if (released_.size() <= cell) released_.resize(size_t{cell} + 1);
  released_[cell].resize(clocks_.size());
  return released_[cell];
}

void RaceClocks::Acquire(int thread, uint32_t cell) {
  Clock& own = clocks_[static_cast<size_t>(thread)];
  const Clock& released = ReleasedAt(cell);
  for (size_t t = 0; t < own.size(); ++t) own[t] = std::max(own[t], released[t]);
}

void RaceClocks::Release(int thread, uint32_t cell) {
  Clock& own = clocks_[static_cast<size_t>(thread)];
  Clock& released = ReleasedAt(cell);
  for (size_t t = 0; t < own.size(); ++t) released[t] = std::max(released[t], own[t]);
  ++own[static_cast<size_t>(thread)];
}

std::optional<RacingAccess> RaceClocks::Unordered(const std::vector<Access>& accesses, bool writes,
                                                  int thread) const {
  const Clock& own = clocks_[static_cast<size_t>(thread)];
  for (size_t other = 0; other < own.size(); ++other) {
    const Access& access = accesses[other];
    if (static_cast<int>(other) == thread || access.clock <= own[other]) continue;
    return RacingAccess{static_cast<int>(other), access.position, writes};
  }
  return std::nullopt;
}

std::optional<RacingAccess> RaceClocks::Read(int thread, int position, uint32_t cell) {
  const auto own = static_cast<size_t>(thread);
  Cell& touched = CellAt(cell);
  touched.reads[own] = {clocks_[own][own], position};
  return Unordered(touched.writes, true, thread);
}

std::optional<RacingAccess> RaceClocks::Write(int thread, int position, uint32_t cell) {
  const auto own = static_cast<size_t>(thread);
  Cell& touched = CellAt(cell);
  touched.writes[own] = {clocks_[own][own], position};
  if (auto write = Unordered(touched.writes, true, thread)) return write;
  return Unordered(touched.reads, false, thread);
}

}  // namespace oncard::vm
