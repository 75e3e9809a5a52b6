// Reports of an exploration, for people and for programs.
//
// Texts end in a newline and depend only on their arguments. Tested by tests/explore/report_test.cc
// and tests/tools/explore_command_test.cc.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "explore/models/ends.h"
#include "explore/reports/statement_texts.h"
#include "explore/reports/trail.h"
#include "explore/reports/way_out.h"
#include "explore/search/explorer.h"
#include "runtime/observe/supervisor.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/sim/refused_commands.h"
#include "vm/schedule.h"

namespace oncard::explore {

/// A search of all cases of a scenario's choices (runtime/scenario/run/choices.h).
struct CaseSearch {
  std::vector<Message> choices;  ///< `gpi[1] at 10..40 ms (121 instants)`
  int64_t cases = 0;
  int64_t searched = 0;  ///< from the first one on, the last one perhaps in part
  bool in_order = true;  ///< false: any of them, all of which were searched to their ends
  /// Values in cases that were searched to their ends or to a failure.
  std::vector<runtime::CoveredChoice> covered;
  // Of the case that failed:
  Message failing;  ///< what was chosen
  std::shared_ptr<const runtime::Scenario> scenario;
};

/// How a search is repeated, from those who have made it.
struct Repetition {
  std::string command = {};   ///< `oncard explore lost.toml --engine=stateful`; empty: unknown
  std::string schedule = {};  ///< of a failure: the text of its schedule file; empty: unknown
  std::vector<std::string> searches = {};  ///< its files: `kept.search, 0123456789abcdef`
};

/// Everything that a report is made from. With `cases` the counts are sums over those that were
/// searched.
struct Findings {
  Subject subject;
  Exploration exploration;
  Trail trail;         ///< of the failure
  ProgramText source;  ///< whose statements are shown; without a text: only line numbers
  /// Commands that were refused in some explored schedule.
  std::vector<runtime::RefusedCommand> refused = {};
  /// What a verdict without a failure has not put to the test.
  std::vector<Message> untested = {};
  bool knows_untested = false;  ///< `untested` is all of it; otherwise the search did not note it
  WayOut way_out = {};          ///< of an incomplete search
  /// What the supervisor has found in some explored schedule.
  std::vector<runtime::CardFinding> card = {};
  std::optional<CaseSearch> cases = {};
  Repetition repetition = {};
  // Only if there are no requirements on results:
  End start = {};  ///< the values before the first statement
  std::optional<End> serial_end =
      {};  ///< the result of the threads running one after the other, if they end
};

/// How much of a failing run is shown, and how wide.
struct ReportOptions {
  bool full = false;  ///< every statement, and every pass of loops
  int width = 0;      ///< width of the terminal; 0: unlimited
};

/// The verdict with its scope (claim.h) and its counts; a failure with the wrong values, the step
/// that caused it, and a table with one column per thread (step_table.h): source lines, the values
/// that each statement read and wrote, with a card the instants, and the statement after which
/// every continuation fails.
std::string TextReport(const Findings& findings, Language language,
                       const ReportOptions& options = {});

/// A JSON object: `verdict`, `engine`, the scope (claim.h), the counts of all engines that ran
/// (`executions`, `blocked`, `redundant`, `traces`, `bad_traces`; `states`, `transitions`,
/// `bad_states`, `states_merged` if they are those of merged statements, and `states_in_groups` if
/// some are counted in several groups of schedules; `final_globals`, `final_full`, `finals_pb0`
/// ...; `races`), `coverage` (coverage_text.h), and of a failure `min_preemptions_to_bad` and
/// `min_steps_to_bad` when they are exact, and its `schedule` of at most 10 000 segments.
std::string JsonReport(const Findings& findings);

/// A self-contained HTML page that can be filed, on a screen or on A4: the verdict, what was asked,
/// a failure as a table with one column per thread, assumptions, bounds, what was executed in the
/// source, what was not put to the test, hashes, and how to repeat the search.
std::string HtmlReport(const Findings& findings, Language language,
                       const ReportOptions& options = {});

/// The failure as trace events for chrome://tracing and ui.perfetto.dev: a row per thread, and bars
/// of equal length for the statements. Without a failure there are no events.
std::string ChromeReport(const Findings& findings);

/// The failure's statements as a schedule that `oncard replay` runs; without checkpoints and
/// scenario. The cycle of a livelock is included once.
vm::Schedule ScheduleOf(const Subject& subject, const Failure& failure);

}  // namespace oncard::explore
