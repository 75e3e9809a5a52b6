#include "vm/race_history.h"

#include <algorithm>
#include <tuple>

namespace oncard::vm {

RaceHistory::RaceHistory(size_t threads, size_t sync_cells)
    : all_threads_((uint64_t{1} << threads) - 1), words_((PlaceOf(sync_cells) + 63) / 64) {}

void RaceHistory::Acquire(int thread, size_t sync_cell) {
  for (size_t i = accesses_.size(); i-- > 0;) {
    if (!Knows(i, PlaceOf(sync_cell))) continue;
    Tell(i, static_cast<size_t>(thread));
    // Nothing can race any more with what all threads know of.
    if ((knowers_[i * words_] & all_threads_) == all_threads_) Remove(i);
  }
}

void RaceHistory::Release(int thread, size_t sync_cell) {
  for (size_t i = 0; i < accesses_.size(); ++i) {
    if (Knows(i, static_cast<size_t>(thread))) Tell(i, PlaceOf(sync_cell));
  }
}

std::optional<RacingAccess> RaceHistory::Read(int thread, int position, uint32_t cell) {
  auto race = Unordered(thread, cell, true);
  Add({cell, thread, false, position});
  return race;
}

std::optional<RacingAccess> RaceHistory::Write(int thread, int position, uint32_t cell) {
  auto race = Unordered(thread, cell, true);
  if (!race) race = Unordered(thread, cell, false);
  // Who does not know of an access before this one does not know of this one either.
  for (size_t i = accesses_.size(); i-- > 0;) {
    if (accesses_[i].cell == cell) Remove(i);
  }
  Add({cell, thread, true, position});
  return race;
}

void RaceHistory::Remove(size_t access) {
  const auto at = static_cast<std::ptrdiff_t>(access);
  const auto words = static_cast<std::ptrdiff_t>(words_);
  accesses_.erase(accesses_.begin() + at);
  knowers_.erase(knowers_.begin() + at * words, knowers_.begin() + (at + 1) * words);
}

void RaceHistory::Add(const Access& access) {
  if (all_threads_ == 1) return;
  const auto order = [](const Access& of) { return std::tie(of.cell, of.thread, of.writes); };
  const auto place = std::ranges::lower_bound(accesses_, order(access), {}, order);
  const auto at = place - accesses_.begin();
  const auto words = static_cast<std::ptrdiff_t>(words_);
  if (place != accesses_.end() && order(*place) == order(access)) {
    *place = access;
    std::fill_n(knowers_.begin() + at * words, words, uint64_t{0});
  } else {
    accesses_.insert(place, access);
    knowers_.insert(knowers_.begin() + at * words, words_, 0);
  }
  Tell(static_cast<size_t>(at), static_cast<size_t>(access.thread));
}

std::optional<RacingAccess> RaceHistory::Unordered(int thread, uint32_t cell, bool writes) const {
  for (size_t i = 0; i < accesses_.size(); ++i) {
    const Access& access = accesses_[i];
    if (access.cell != cell || access.thread == thread || access.writes != writes) continue;
    if (!Knows(i, static_cast<size_t>(thread))) {
      return RacingAccess{access.thread, access.position, writes};
    }
  }
  return std::nullopt;
}

}  // namespace oncard::vm
