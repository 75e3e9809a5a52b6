// What a scenario leaves open: the instant of an event, the level of an input, the value of a
// variable at the start. Each is a *choice*: a name with an ordered list of values. A *case* takes
// one value of every choice; it is a scenario in which nothing is left open, and runs, searches and
// sessions see such scenarios only. A scenario with choices by itself means the first case.
//
// The cases have an order, in which neighbours differ in the instant of the first event: the first
// choice changes fastest, and events come before variables. Plain values; deterministic. Tested by
// tests/runtime/choices_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/card_clock.h"

namespace oncard::runtime {

/// One of them.
struct Choice {
  enum class Kind : uint8_t {
    kInput,   ///< the cycle of an event of World::inputs
    kLevel,   ///< its level
    kFault,   ///< the cycle of a fault of World::faults
    kGlobal,  ///< the value of one of Scenario::globals
    kLocal    ///< that of a thread's variable
  };
  Kind kind = Kind::kGlobal;
  size_t index = 0;  ///< of the event, of the global, or of the thread in the scenario
  size_t local = 0;  ///< kLocal: which of the thread's values
  /// `gpi[1]`, `axis2.stall`, `n`; `page3.n` where several have this name.
  std::string name = {};
  int64_t first = 0;  ///< the smallest value, or the earliest cycle
  int64_t count = 1;  ///< of values: consecutive numbers
  /// kInput: the level of the event; empty: the next choice.
  std::optional<uint32_t> level = {};
  /// kLevel: the instant of the event; empty: the choice before it.
  std::optional<int64_t> at_us = {};
  TextPlace place = {};  ///< of its key
};

/// Which of the values of a choice have been covered.
struct CoveredChoice {
  std::string name;       ///< as of the choice
  bool instants = false;  ///< the values are instants
  double first = 0;       ///< in ms, or the smallest value
  double last = 0;
  int64_t values = 0;
  int64_t covered = 0;  ///< of them
};

/// `121 of 121 instants of gpi[1], 10 to 40 ms`, `3 of 10 values of n, 1 to 10`.
Message DescribeCovered(const CoveredChoice& choice);

class Choices {
 public:
  /// Maximum number of cases: each of them is explored.
  static constexpr int64_t kCasesMax = 1'000'000;
  /// Maximum number of choices.
  static constexpr size_t kChoicesMax = 100;

  /// The choices of a scenario. Fails if no cycle begins in the time of an event or it goes beyond
  /// the end of the run, if a variable has a choice and another value, too, and if there are more
  /// than kChoicesMax choices or kCasesMax cases. Errors have the places of their keys: of too many
  /// choices the first one that is too many, of too many cases the choice that has most values.
  static Result<Choices> Of(const Scenario& scenario);

  /// True if nothing is left open.
  bool empty() const { return choices_.empty(); }
  /// The number of cases: 1 if nothing is left open.
  int64_t cases() const { return cases_; }
  /// A case of the scenario that these are the choices of, from 0.
  Scenario CaseOf(const Scenario& scenario, int64_t number) const;
  /// The case that a seed draws: every choice takes each of its values with the same probability.
  int64_t Draw(uint64_t seed) const;

  /// What is chosen from: `gpi[1] at 10..40 ms (121 instants)`, `n in 1..10`.
  std::vector<Message> Describe() const;
  /// What is chosen in a case: `gpi[1] = 1 at 10.75 ms; n = 10`.
  Message DescribeCase(int64_t number) const;
  /// Of each choice the values that are in one of the cases; an element for each case, true for
  /// those that count.
  std::vector<CoveredChoice> Covered(const std::vector<bool>& cases) const;

 private:
  Choices(CardClock clock, std::vector<Choice> choices);

  /// The value of each choice in a case.
  std::vector<int64_t> ValuesIn(int64_t number) const;

  CardClock clock_;
  std::vector<Choice> choices_;
  int64_t cases_ = 1;
};

/// `choice: gpi[1] = 1 at 10.75 ms; n = 10`, for those who have run one case.
Message DescribeChosen(const Message& chosen);

}  // namespace oncard::runtime
