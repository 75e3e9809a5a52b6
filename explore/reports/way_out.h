// What an incomplete search has reached, what it spends its states on, and what to try next.
// Depends only on the program and on what was searched, not on the clock. Tested by
// tests/explore/way_out_test.cc.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "explore/models/card_model.h"
#include "explore/models/problem.h"
#include "explore/reports/trail.h"
#include "explore/search/explorer.h"

namespace oncard::explore {

struct WayOut {
  std::vector<Message> reached;  ///< up to where every schedule was searched, and what held there
  std::vector<Message> spent;    ///< loops in which threads go round
  std::vector<Message> next;     ///< command lines, and keys of the scenario
};

/// `subject` is complete (Describe()). Executes a run in which the threads take turns.
WayOut WayOutOf(const Subject& subject, const Exploration& exploration,
                const ExploreOptions& options, const Problem& problem);
WayOut WayOutOf(const Subject& subject, const Exploration& exploration,
                const ExploreOptions& options, CardModel* model);

}  // namespace oncard::explore
