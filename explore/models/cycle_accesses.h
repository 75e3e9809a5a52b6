// What threads can still access in the present cycle of a card, so that a search can tell which
// statements nobody else notices.
//
// Where the code leads is known before the search (cycle_code.h); what its commands access depends
// on the values of variables and is found out by looking: of each thread what its statement at a
// position has been seen to access, in whichever state. A search is exact for what was known when
// it began if it has seen nothing else in its own states; otherwise it begins again, with what it
// has seen. That this is enough: take a run of the card up to its first statement that accesses
// something unknown. The search leaves out only the order of statements that do not depend on each
// other, by what is known, so it has a run with the same statements, and sees it, too.
//
// Deterministic; not thread-safe. Tested by tests/explore/reduced_search_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/card_steps.h"
#include "explore/models/cycle_code.h"
#include "explore/models/recent_values.h"
#include "explore/models/value_table.h"
#include "runtime/observe/statement_access.h"

namespace oncard::explore {

class CycleAccesses {
 public:
  using Row = CardRows::Row;

  /// False if it is not known what threads can do to each other: a command starts, stops or
  /// replaces programs or everything, or a function is too long.
  static bool Possible(const CardModel& model);

  /// `rows` are those of the model.
  CycleAccesses(const CardModel& model, CardSteps* rows);

  /// From now on what has been seen so far is taken for all that there is.
  void Begin();
  /// True if something else has been seen since then.
  bool grown() const { return grown_; }

  /// True if a thread can execute statements in the present cycle, or could if it were woken up.
  bool Active(const Row& row, size_t place) const;
  /// The most statements that it can execute in it.
  int64_t MostOf(const Row& row, size_t place) const;
  /// Looks at the next statement of a thread that can execute it, and returns the number of what it
  /// accesses. Everything that a search executes has to be looked at.
  uint32_t LookAt(const Row& row, size_t place);
  /// True if the next statement of a thread, which has this `access`, changes nothing that a
  /// requirement on every state names, and does not depend on what other threads can still do in
  /// this cycle. Threads with their bit in `frozen` do nothing more.
  bool NobodyNotices(const Row& row, size_t place, uint32_t access, uint32_t frozen);

 private:
  /// What is accessed of the program itself, which no other command can change, and of the card.
  struct Parts {
    runtime::StatementAccess program;  ///< threads and their pages
    runtime::StatementAccess card;     ///< and globals

    void Add(const runtime::Touched& touched);
    bool DependOn(const Parts& other) const;
  };
  /// Of a position in the function of a thread.
  struct Place {
    bool asserted = false;       ///< an assert is checked before the statement
    std::vector<uint32_t> seen;  ///< numbers of accesses
    bool looked = false;         ///< `future` is known
    Parts future;
    std::vector<int8_t> meets;  ///< by number of an access: -1 unknown, 0 no, 1 yes
  };
  struct Access {
    Parts parts;
    bool visible = false;
  };

  void AddAsserts(const CardModel& model);
  void AddWaits(const CardModel& model);
  uint32_t NumberOf(const runtime::StatementAccess& accesses);
  uint32_t NextOf(const Row& row, size_t place);
  const uint32_t& FindCommand(const Row& row, size_t place);
  runtime::StatementAccess OperandsOf(const vm::Instruction& instruction, size_t place) const;
  void See(uint32_t access, Place* place);
  /// True if an access may depend on what a thread does from a position on.
  bool Meets(uint32_t access, size_t place, size_t position);

  const vm::Object& object_;
  const runtime::Controller& card_;
  CardSteps& rows_;
  std::vector<size_t> functions_;               ///< of the threads
  std::vector<CycleCode> code_;                 ///< of their functions
  std::vector<std::vector<Place>> places_;      ///< of each thread, by position
  std::vector<std::vector<uint32_t>> by_code_;  ///< of each statement without a command, its access
  Parts watched_;                               ///< what requirements on every state name
  ValueTable<Access> accesses_;
  ValueTable<uint32_t> commands_;  ///< the access of a command in a state
  RecentValues<uint32_t> recent_commands_;
  std::vector<int64_t> key_;
  bool grown_ = false;
};

}  // namespace oncard::explore
