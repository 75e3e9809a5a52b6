#include "explore/models/equal_threads.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace oncard::explore {
namespace {

/// How a thread has ended: the last cells of Model::ThreadCells().
using ThreadResult = std::array<int64_t, 2>;

/// A group of equal threads, and how they have ended, in the order of the current exchange.
struct EndedGroup {
  const std::vector<int>* threads = nullptr;
  std::vector<ThreadResult> results;
};

}  // namespace

EqualThreads::EqualThreads(const Model& model) {
  group_of_.assign(static_cast<size_t>(model.thread_count()), kNone);
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    if (GroupOf(thread) != kNone) continue;
    std::vector<int> group = {thread};
    for (int other = thread + 1; other < model.thread_count(); ++other) {
      if (group_of_[static_cast<size_t>(other)] == kNone && model.Alike(thread, other)) {
        group.push_back(other);
      }
    }
    if (group.size() == 1) continue;
    for (const int member : group) {
      group_of_[static_cast<size_t>(member)] = static_cast<int>(groups_.size());
    }
    groups_.push_back(std::move(group));
  }
}

void EqualThreads::Include(const Model& model, StatementCoverage* coverage) const {
  for (const std::vector<int>& group : groups_) {
    const auto function = static_cast<size_t>(model.setup(group.front()).function);
    const size_t statements = model.image().object.functions[function].instructions.size();
    for (size_t position = 0; position < statements; ++position) {
      uint8_t noted = 0;
      for (const int member : group) {
        noted |= coverage->At(static_cast<size_t>(model.setup(member).function), position);
      }
      for (const int member : group) {
        coverage->Note(static_cast<size_t>(model.setup(member).function), position, noted);
      }
    }
  }
}

StateKey ExchangeableKey(std::span<const int64_t> cells, int group) {
  StateKey key;
  uint32_t place = 0;
  for (const int64_t value : cells) AddToKey(place++, value, &key);
  // Scrambled again, so that no sum is also that of an exchange of single cells.
  const auto in = static_cast<uint32_t>(group);
  return {MixPlace(key.high, in, static_cast<int64_t>(key.low)),
          MixPlace(key.low, in, static_cast<int64_t>(key.high))};
}

void ForEachExchange(const EqualThreads& threads, const Model& end, Model* scratch,
                     const std::function<void(const Model& exchanged)>& visit) {
  std::vector<EndedGroup> groups;
  for (const std::vector<int>& group : threads.groups()) {
    EndedGroup ended = {&group, {}};
    for (const int member : group) {
      const auto last = end.ThreadCells(member).last<2>();
      ended.results.push_back({last[0], last[1]});
    }
    std::ranges::sort(ended.results);
    groups.push_back(std::move(ended));
  }
  for (uint32_t cell = 0; cell < end.global_count(); ++cell) {
    scratch->SetGlobal(cell, end.Global(cell));
  }
  for (int thread = 0; thread < end.thread_count(); ++thread) {
    scratch->SetThreadCells(thread, end.ThreadCells(thread));
  }
  std::vector<int64_t> cells;
  for (;;) {
    for (const EndedGroup& group : groups) {
      for (size_t i = 0; i < group.results.size(); ++i) {
        const int member = (*group.threads)[i];
        const auto own = end.ThreadCells(member);
        cells.assign(own.begin(), own.end());
        std::ranges::copy(group.results[i], cells.end() - 2);
        scratch->SetThreadCells(member, cells);
      }
    }
    visit(*scratch);
    // The groups count on like the digits of a number.
    const auto next = std::ranges::find_if(groups, [](EndedGroup& group) {
      return std::next_permutation(group.results.begin(), group.results.end());
    });
    if (next == groups.end()) return;
  }
}

}  // namespace oncard::explore
