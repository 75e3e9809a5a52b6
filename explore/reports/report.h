// What an exploration has found, for people and for programs.
//
// Texts end in a newline and depend on nothing but their arguments.
// Tested by tests/explore/report_test.cc and tests/tools/explore_command_test.cc.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "explore/models/ends.h"
#include "explore/reports/trail.h"
#include "explore/search/explorer.h"
#include "runtime/sim/refused_commands.h"
#include "vm/schedule.h"

namespace oncard::explore {

/// All that a report is made of.
struct Findings {
  Subject subject;
  Exploration exploration;
  Trail trail;  ///< of the failure
  /// The program's text, of which lines are shown; empty: line numbers alone.
  std::string source;
  /// Commands that threads were refused in some schedule that was looked at.
  std::vector<runtime::RefusedCommand> refused = {};
  // Where nothing is asked of results:
  End start = {};                      ///< the values before the first statement
  std::optional<End> serial_end = {};  ///< of the threads one after the other, if they end
};

/// How much of a failing run is shown, and in how many columns.
struct ReportOptions {
  bool full = false;  ///< every statement, loops one by one
  int width = 0;      ///< of the terminal; 0: as wide as it must be
};

/// The verdict with what it speaks of (claim.h) and its counts; a failure with the values that are
/// wrong, the step that is to blame, and a table with one column per thread (step_table.h): source
/// lines, what each statement read and wrote, with a card the instants, and after which statement
/// no good end was possible any more.
std::string TextReport(const Findings& findings, Language language,
                       const ReportOptions& options = {});

/// A JSON object: `verdict`, `engine`, what it speaks of (claim.h), the counts of both engines that
/// ran (`executions`, `blocked`, `redundant`, `traces`, `bad_traces`; `states`, `transitions`,
/// `bad_states`; `final_globals`, `final_full`, `finals_pb0` ...; `races`), and of a failure
/// `min_preemptions_to_bad` and `min_steps_to_bad` when they are exact, and its `schedule` of at
/// most 10 000 segments.
std::string JsonReport(const Findings& findings);

/// One HTML page that needs no other file: the verdict, what it speaks of, the counts, and a
/// failure as a table with a column per thread.
std::string HtmlReport(const Findings& findings, Language language,
                       const ReportOptions& options = {});

/// The failure as trace events for chrome://tracing and ui.perfetto.dev: a row per thread, a bar
/// per statement, as long as one another. Without a failure there are no events.
std::string ChromeReport(const Findings& findings);

/// The failure's statements as a schedule that `oncard replay` runs; without checkpoints and
/// scenario. A livelock's cycle is taken once.
vm::Schedule ScheduleOf(const Subject& subject, const Failure& failure);

}  // namespace oncard::explore
