// Programs with threads for the explorer's tests: compiled from text, bound as in comments.
#pragma once

#include <cstdint>
#include <string>

#include "explore/models/card_model.h"
#include "explore/models/problem.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// The problem of a source with //@ comments; an error is reported and aborts the test program.
Problem ProblemOf(const std::string& source);

/// A card whose functions t0, t1, ... are bound as for comments; `keys` are further lines of the
/// scenario.
CardModel CardOf(const std::string& source, const std::string& keys);

/// The findings for a source with //@ comments.
Findings FindingsOf(const std::string& source, const ExploreOptions& options);
/// The same for a scenario with further lines, as for CardOf().
Findings FindingsOf(const std::string& source, const std::string& keys,
                    const ExploreOptions& options);

/// A scenario as for CardOf(), with what it asks.
struct LoadedScenario {
  vm::Object object;
  runtime::Scenario scenario;
  std::vector<Requirement> requirements;
};
LoadedScenario LoadedOf(const std::string& source, const std::string& keys);

/// The same where it may be refused.
Result<Findings> TryFindingsOf(const std::string& source, const std::string& keys,
                               const ExploreOptions& options);

/// `threads` threads that each increment `x` `times` times, in three statements; x is 0 at first.
std::string Increments(int threads, int times);

/// A thread t0 whose line 6 cannot be reached while x is not 5, as its condition in line 5 holds.
std::string NeverFive();

/// Peterson's lock around an increment, with loops that wait. With `broken`, each thread gives the
/// turn to itself, so that both can enter.
std::string Peterson(bool broken);

/// Two or three threads with a few statements on three globals, without loops.
std::string RandomThreads(uint64_t seed);

/// Two threads that wait forever for each other's flag.
std::string MutualWait();

}  // namespace oncard::explore
