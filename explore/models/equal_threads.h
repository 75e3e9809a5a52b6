// Threads of a program that can be exchanged: they execute the same statements from the same values
// of their locals. A state in which some of them have changed places goes on as the state before
// the exchange does, with the same threads exchanged.
//
// Deterministic; not thread-safe. Tested by tests/explore/equal_threads_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "explore/models/model.h"
#include "explore/models/state_key.h"
#include "explore/models/statement_coverage.h"

namespace oncard::explore {

/// The equal threads of a program in groups, each thread in at most one.
class EqualThreads {
 public:
  static constexpr int kNone = -1;

  /// No thread is equal to another one.
  EqualThreads() = default;
  /// Those of a model before its first step (Model::Alike()).
  explicit EqualThreads(const Model& model);

  bool empty() const { return groups_.empty(); }
  const std::vector<std::vector<int>>& groups() const { return groups_; }
  /// The group of a thread; kNone if it has no equal.
  int GroupOf(int thread) const { return empty() ? kNone : group_of_[static_cast<size_t>(thread)]; }

  /// Notes what a thread has executed for all that are equal to it: another schedule executes it in
  /// these.
  void Include(const Model& model, StatementCoverage* coverage) const;

 private:
  std::vector<std::vector<int>> groups_;
  std::vector<int> group_of_;
};

/// A key of the values of a thread's cells (Model::ThreadCells()) that is the same for all threads
/// of its group. Those of a state are added up, so that their order does not matter.
StateKey ExchangeableKey(std::span<const int64_t> cells, int group);

/// Calls `visit` with the end of a run after each exchange of equal threads, once for each
/// different set of return values, with the end itself among them. `scratch` is a model of the
/// program.
void ForEachExchange(const EqualThreads& threads, const Model& end, Model* scratch,
                     const std::function<void(const Model& exchanged)>& visit);

}  // namespace oncard::explore
