// The statements of a run as a table with a column per thread: what each read and wrote, loops
// drawn together, and, with a card, where its axes are. For failures and for any other run.
//
// Deterministic. Tested by tests/explore/step_table_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

/// Which statements a table shows.
enum class Detail : uint8_t {
  kBrief,  ///< those that touch what threads share, and those that are named; loops drawn together
  kLoops,  ///< all; loops drawn together
  kFull    ///< all, one by one
};

/// What a table is made of. All that it points to outlives it.
struct StepView {
  const Subject& subject;
  const std::vector<TrailStep>& steps;
  std::string_view source;  ///< the program's text; empty: line numbers alone
  Detail detail = Detail::kBrief;
  bool with_card = false;                 ///< the instants mean something
  const runtime::Trace* trace = nullptr;  ///< of the run, for the curves of its axes
  std::vector<size_t> named = {};         ///< steps that are shown in any case
  int64_t last_escape = -1;               ///< marked: from here on every end is bad
};

/// A line of a table.
struct StepRow {
  enum class Kind : uint8_t { kStep, kTime, kRepeat };
  Kind kind = Kind::kStep;
  size_t step = 0;        ///< kStep: its index; kRepeat: that of the first one left out
  int thread = 0;         ///< column; of kRepeat -1 when threads take turns in the loop
  double at_ms = 0;       ///< kTime
  int line = 0;           ///< kStep
  std::string statement;  ///< kStep: its text; kRepeat: `lines 15–19 × 48 more`
  std::string read;       ///< `x = 3, a[1] = 0`
  std::string written;    ///< `x: 3 -> 4`
  bool escape = false;
};

struct StepRows {
  std::vector<StepRow> rows;
  size_t left_out = 0;  ///< statements that touch nothing shared
};

StepRows RowsOf(const StepView& view, Language language);

/// `thread 0 add`.
std::string ThreadHead(const Subject& subject, size_t thread, Language language);

/// For a terminal of a width; 0: as wide as it must be. Cells that are too wide are broken; with
/// too many threads for it, they share one column. Ends in a newline.
std::string TextTable(const StepView& view, int width, Language language);

/// A <table>, beside the curves of the axes.
std::string HtmlTable(const StepView& view, Language language);

/// The text of a step's statement: the part of its line that is it, when each statement of the line
/// is one instruction, or else the whole line; empty without a source.
class StatementTexts {
 public:
  StatementTexts(std::string_view source, const vm::Object& object);
  std::string Of(const runtime::LoggedStep& step) const;

 private:
  const vm::Object& object_;
  std::vector<std::string> lines_;  ///< element n: line n + 1, without the blanks around it
};

}  // namespace oncard::explore
