// The statements of a run as a table with one column per thread: the values that each read and
// wrote, with passes of loops combined and, with a card, the positions of its axes. For failures
// and for any other run.
//
// Deterministic. Tested by tests/explore/step_table_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "explore/reports/statement_texts.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

/// Which statements a table shows.
enum class Detail : uint8_t {
  kBrief,  ///< those that access shared variables or the card, and named ones; passes of loops
           ///< combined
  kFlow,   ///< the same, and those that compute what they write or command
  kLoops,  ///< all; passes of loops combined
  kFull    ///< all, including every pass of loops
};

/// The data of a table. Everything that it points to must outlive it.
struct StepView {
  const Subject& subject;
  const std::vector<TrailStep>& steps;
  const ProgramText& source;  ///< without a text: only line numbers
  Detail detail = Detail::kBrief;
  bool with_card = false;                 ///< the instants are meaningful
  const runtime::Trace* trace = nullptr;  ///< trace of the run, for the curves of its axes
  std::vector<size_t> named = {};         ///< steps that are always shown
  std::span<const HostStep> host = {};    ///< what the host does between the steps
  int64_t last_escape = -1;               ///< the step after which every continuation fails; marked
  bool with_gaps = false;                 ///< what is left out has rows of its own
};

/// A value that a statement read.
struct ValueRead {
  std::string name;
  std::string value;
  bool shared = false;  ///< of a global variable
};

/// A value that a statement wrote, or what passes of a loop made of it together.
struct ValueWritten {
  std::string name;
  std::string before;
  std::string after;
  bool shared = false;  ///< of a global variable
};

/// A line of a table.
struct StepRow {
  enum class Kind : uint8_t { kStep, kTime, kHost, kRepeat, kGap };
  Kind kind = Kind::kStep;
  size_t step = 0;   ///< kStep: its index; kRepeat, kGap: the index of the first step left out
  size_t last = 0;   ///< kRepeat, kGap: the index of the last step left out
  int thread = 0;    ///< column; kRepeat: -1 if threads take turns in the loop
  double at_ms = 0;  ///< kTime, kHost
  int line = 0;      ///< kStep
  /// kStep: its text; kHost: `host: GT_RunThread(0)`; kRepeat: `lines 15–19 × 48 more`.
  std::string statement;
  std::vector<ValueRead> reads;
  std::vector<ValueWritten> writes;
  bool escape = false;
};

struct StepRows {
  std::vector<StepRow> rows;
  size_t left_out = 0;  ///< statements that access nothing shared
};

StepRows RowsOf(const StepView& view, Language language);

/// `thread 0 add`.
std::string ThreadHead(const Subject& subject, size_t thread, Language language);

/// For a terminal with a width; 0: unlimited. Cells that are too wide are wrapped; if there are too
/// many threads, they share one column. Ends in a newline.
std::string TextTable(const StepView& view, int width, Language language);

/// A <table>, beside the curves of the axes.
std::string HtmlTable(const StepView& view, Language language);

}  // namespace oncard::explore
