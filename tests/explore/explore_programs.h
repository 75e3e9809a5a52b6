// Programs of threads for the explorer's tests: compiled from text, bound as comments say.
#pragma once

#include <string>

#include "explore/models/card_model.h"
#include "explore/models/problem.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// The problem of a source with //@ comments; a failure is reported and aborts the test program.
Problem ProblemOf(const std::string& source);

/// A card whose functions t0, t1, ... are bound as comments would bind them; `keys` are further
/// lines of the scenario.
CardModel CardOf(const std::string& source, const std::string& keys);

/// What an exploration of a source with //@ comments finds.
Findings FindingsOf(const std::string& source, const ExploreOptions& options);
/// The same of a scenario with further lines, as for CardOf().
Findings FindingsOf(const std::string& source, const std::string& keys,
                    const ExploreOptions& options);

/// `threads` threads that each increment `x` `times` times in three statements, from 0 on.
std::string Increments(int threads, int times);

/// Peterson's lock around an increment, with loops that wait. With `broken`, each thread gives
/// itself the turn, and both can enter.
std::string Peterson(bool broken);

/// Two threads that wait for each other's flag, for ever.
std::string MutualWait();

}  // namespace oncard::explore
