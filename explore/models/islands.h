// Islands: threads that share nothing with the others but time. Instead of all states of a card
// with all its threads, those of each island are searched, on a card of its own.
//
// What the other threads do to an island is to take statements of a cycle. So an island may be left
// with any part of a cycle's budget once each of its threads that can run has executed a statement
// in it (CardModel::EndCycle), which the card guarantees (card_model.h). Each run of the whole
// program, looked at from one island, is then a run of the island alone:
//
// - The others execute some statements between its own. What these leave of the budget is never
//   more than in the island, so that a thread which has to be served there has to be served here.
// - A cycle ends when the budget is used up or nobody can run. All threads that could run at its
//   start have been served by then, as the budget is no smaller than their number and no thread
//   begins to run within a cycle: this is why no thread may wait for a variable.
// - The run goes on when the threads of the island have ended, up to the end of the last island.
//
// The reverse is not true: an island has runs that the others cannot cause. So it proves that
// nothing fails, but what fails in it may not happen. Each failure of the whole program is one of
// an island:
//
// - A fault of a thread, and a thread that does not end before `limit_ms`: in its island.
// - A requirement: in the island that sets what it names. One that names things of several islands
//   joins them, unless it is a conjunction (under `never` a disjunction), which is checked in
//   parts.
// - An assert names things that its thread reads.
// - A global to which threads only add, and which requirements name only at the end of a run, joins
//   nobody (added_globals.h). Each island shows what it can add to it; what is required must hold
//   for every sum.
// - A deadlock: there is none, as nobody waits for a variable.
// - A race: two threads that access one variable, or set one axis or output, are of one island.
//
// Which threads share something is found out by looking (lasting_access.h): first in a run of the
// whole program, then in all runs of the islands. As long as the threads of one access something
// that those of another one set, both are joined and searched again.
// Deterministic; not thread-safe. Tested by tests/explore/islands_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "explore/models/card_model.h"
#include "runtime/conditions/card_condition.h"
#include "runtime/observe/lasting_access.h"
#include "runtime/scenario/file/expectation.h"
#include "runtime/scenario/file/requirement.h"

namespace oncard::explore {

struct Island {
  uint32_t threads = 0;  ///< bit n: thread n of the whole model
  runtime::StatementAccess accesses;
};

/// Of each global that sums are asked of, in the order of Islands::summed(): what the threads of an
/// island add to it in one of its runs, or its value at the end of a run of all. Modulo 2^32, as
/// ints wrap.
using GlobalSums = std::vector<uint32_t>;

/// An island on a card of its own.
struct IslandCard {
  CardModel model;
  /// The requirements of the whole model that those of the island are, or are parts of.
  std::vector<size_t> origins;
  /// What is required of it can change after its threads have ended.
  bool lasts = false;
};

class Islands {
 public:
  /// Those of a model, as a run of it shows them. Empty if there is only one, or if what is said
  /// above does not hold: a thread waits for a variable or is periodic, a host or the surroundings
  /// react, there is a bus, an axis operates a switch of another one, a cycle has fewer statements
  /// than there are threads, or a run may last for ever without `until_ms`.
  static std::optional<Islands> Of(const CardModel& whole);

  const std::vector<Island>& all() const { return islands_; }
  /// Adds what runs of an island have accessed. True if islands were joined; their order is then
  /// another one.
  bool Add(size_t island, const runtime::StatementAccess& accesses);
  /// The slots of the globals to which threads only add, and of which requirements ask at the end.
  const std::vector<uint16_t>& summed() const { return summed_; }
  /// Whether these requirements hold with the values.
  bool HoldsWith(const GlobalSums& values) const;
  /// Empty if the island cannot stand alone: a requirement names what it does not have.
  std::optional<IslandCard> Build(size_t island, const CardModel& whole) const;

 private:
  /// A requirement, or a part of a conjunction, that one island is to fulfil.
  struct Part {
    size_t origin = 0;
    std::optional<runtime::Expectation> expectation = {};  ///< otherwise it is the requirement
    Requirement requirement = {};
    runtime::StatementAccess reads = {};
    /// What a requirement without an instant says of the end of a run.
    std::optional<runtime::CardCondition> at_end = {};
    int thread = 0;      ///< of the island that is to fulfil it
    bool lasts = false;  ///< it names more than variables and threads, or a time
  };

  bool ReadParts(const CardModel& whole);
  bool ReadPart(Part part, const CardModel& whole);
  bool AddAsserts(const CardModel& whole);
  /// Finds the globals that join nobody, and keeps what is asked of them apart.
  void FindSums(const CardModel& whole);
  /// Gives each part to the island that is to fulfil it.
  void AssignParts();
  void AddAccesses(const runtime::StatementAccess& accesses, size_t island);
  /// Notes what the threads access in a run.
  void Watch(CardModel* model);
  size_t IslandOf(int thread) const;
  /// Joins islands as long as one accesses what another one sets.
  bool Join();

  std::vector<Island> islands_;
  std::vector<Part> parts_;
  std::vector<uint16_t> only_added_;  ///< the globals that join nobody, by their slots
  std::vector<uint16_t> summed_;      ///< of these, what requirements name
  std::vector<runtime::CardCondition> asked_of_sums_;
};

}  // namespace oncard::explore
