#include "explore/reports/step_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/markup.h"
#include "base/trim.h"
#include "compiler/display_text.h"
#include "explore/reports/axis_curve.h"

namespace oncard::explore {
namespace {

using runtime::LoggedStep;

// --- Rows ----------------------------------------------------------------------------------------

class RowMaker {
 public:
  RowMaker(const StepView& view, Language language)
      : view_(view),
        language_(language),
        object_(view.subject.image->object),
        texts_(view.source, object_) {}

  StepRows Make() {
    if (view_.detail == Detail::kFlow) FindCarriers();
    for (size_t i = 0; i < view_.steps.size(); ++i) {
      if (Matters(i)) shown_.push_back(i);
    }
    rows_.left_out = view_.steps.size() - shown_.size();
    for (size_t i = 0; i < shown_.size();) {
      const Loop loop = view_.detail == Detail::kFull ? Loop{} : LoopAt(i);
      const size_t once = loop.times == 0 ? 1 : loop.period;
      for (size_t end = i + once; i < end; ++i) {
        AddGapUpTo(shown_[i]);
        AddHostUpTo(shown_[i]);
        AddStep(shown_[i]);
      }
      if (loop.times == 0) continue;
      AddRepeat(i, loop);
      i += loop.period * (loop.times - 1);
    }
    AddGapUpTo(view_.steps.size());
    AddHostUpTo(view_.steps.size());
    return std::move(rows_);
  }

 private:
  /// Repeated statements.
  struct Loop {
    size_t period = 0;
    size_t times = 0;  ///< 0: there is none
  };

  bool Named(size_t step) const {
    return static_cast<int64_t>(step) == view_.last_escape ||
           std::ranges::find(view_.named, step) != view_.named.end();
  }

  static bool TouchesShared(const auto& accesses) {
    return std::ranges::any_of(accesses, [](const auto& each) { return each.slot.global; });
  }

  /// True if its rows say only what is shared.
  bool Brief() const { return view_.detail == Detail::kBrief || view_.detail == Detail::kFlow; }

  bool Matters(size_t index) const {
    if (!Brief() || Named(index)) return true;
    const LoggedStep& step = view_.steps[index].log;
    return step.command || TouchesShared(step.reads) || TouchesShared(step.writes) ||
           (!carriers_.empty() && carriers_[index]);
  }

  /// From the end on: a statement carries a value if it writes a local that a later one reads in
  /// order to write a shared variable, to call a command, or to carry it on.
  void FindCarriers() {
    carriers_.resize(view_.steps.size());
    std::set<std::pair<uint8_t, uint16_t>> awaited;  // page and slot of locals
    for (size_t i = view_.steps.size(); i-- > 0;) {
      const LoggedStep& step = view_.steps[i].log;
      for (const runtime::SlotChange& write : step.writes) {
        if (!write.slot.global && awaited.erase({write.slot.page, write.slot.id}) > 0) {
          carriers_[i] = true;
        }
      }
      if (!carriers_[i] && !step.command && !TouchesShared(step.writes)) continue;
      for (const runtime::SlotValue& read : step.reads) {
        if (!read.slot.global) awaited.insert({read.slot.page, read.slot.id});
      }
    }
  }

  /// True if the host has done something since the shown step before that one.
  bool AfterHost(size_t shown) const {
    const size_t previous = shown == 0 ? 0 : shown_[shown - 1] + 1;
    const auto first = std::ranges::lower_bound(view_.host, previous, {}, &HostStep::before);
    return first != view_.host.end() && first->before <= shown_[shown];
  }

  bool Alike(size_t a, size_t b) const {
    const auto token = [&](size_t shown) {
      const LoggedStep& step = view_.steps[shown_[shown]].log;
      return std::tuple(step.thread, step.function, step.position);
    };
    return token(a) == token(b) && !Named(shown_[a]) && !Named(shown_[b]) && !AfterHost(b);
  }

  /// The loop that begins here and covers most statements; two repetitions do not count as a loop.
  Loop LoopAt(size_t begin) const {
    constexpr size_t kPeriodMax = 200;
    constexpr size_t kTimesMin = 3;
    Loop best;
    for (size_t period = 1; period <= kPeriodMax; ++period) {
      if (begin + kTimesMin * period > shown_.size()) break;
      size_t same = 0;
      while (begin + period + same < shown_.size() && Alike(begin + same, begin + period + same)) {
        ++same;
      }
      const size_t times = same / period + 1;
      if (times >= kTimesMin && period * times > best.period * best.times) best = {period, times};
    }
    return best;
  }

  /// Rows for what is left out before that step: one for each turn of a thread.
  void AddGapUpTo(size_t index) {
    while (view_.with_gaps && accounted_ < index) {
      StepRow row;
      row.kind = StepRow::Kind::kGap;
      row.step = accounted_;
      row.thread = view_.steps[accounted_].thread;
      while (accounted_ < index && view_.steps[accounted_].thread == row.thread) ++accounted_;
      row.last = accounted_ - 1;
      rows_.rows.push_back(std::move(row));
    }
  }

  void AddHostUpTo(size_t index) {
    for (; host_ < view_.host.size() && view_.host[host_].before <= index; ++host_) {
      StepRow row;
      row.kind = StepRow::Kind::kHost;
      row.at_ms = view_.host[host_].at_ms;
      row.statement = MakeMessage("host: {0}", "主机：{0}", view_.host[host_].call).In(language_);
      rows_.rows.push_back(std::move(row));
    }
  }

  void AddStep(size_t index) {
    const TrailStep& step = view_.steps[index];
    AddTime(step);
    accounted_ = index + 1;
    StepRow row;
    row.step = index;
    row.last = index;
    row.thread = step.thread;
    row.line = step.log.line;
    row.statement = texts_.Of(step.log);
    for (const runtime::SlotValue& read : step.log.reads) {
      std::string name = NameOf(step.log, read.slot, object_);
      if (name.empty() || (Brief() && !read.slot.global)) continue;
      row.reads.push_back(
          {std::move(name), ValueText(step.log, read.slot, read.raw, object_), read.slot.global});
    }
    for (const runtime::SlotChange& write : step.log.writes) AddChange(step.log, write, &row);
    row.escape = static_cast<int64_t>(index) == view_.last_escape;
    rows_.rows.push_back(std::move(row));
  }

  void AddChange(const LoggedStep& step, const runtime::SlotChange& change, StepRow* row) const {
    std::string name = NameOf(step, change.slot, object_);
    if (name.empty()) return;
    row->writes.push_back({std::move(name), ValueText(step, change.slot, change.before, object_),
                           ValueText(step, change.slot, change.after, object_),
                           change.slot.global});
  }

  void AddTime(const TrailStep& step) {
    if (!view_.with_card || (has_time_ && step.log.at_ms == at_ms_)) return;
    has_time_ = true;
    at_ms_ = step.log.at_ms;
    StepRow row;
    row.kind = StepRow::Kind::kTime;
    row.at_ms = at_ms_;
    rows_.rows.push_back(std::move(row));
  }

  /// Summarises the loop's repetitions after the first: its lines, and their total changes.
  void AddRepeat(size_t begin, const Loop& loop) {
    const size_t count = loop.period * (loop.times - 1);
    AddGapUpTo(shown_[begin]);
    StepRow row;
    row.kind = StepRow::Kind::kRepeat;
    row.step = shown_[begin];
    row.last = shown_[begin + count - 1];
    accounted_ = row.last + 1;
    row.thread = view_.steps[row.step].thread;
    int first = view_.steps[row.step].log.line;
    int last = first;
    struct Change {
      const LoggedStep* step;
      runtime::SlotChange change;
    };
    std::vector<Change> changes;
    for (size_t i = begin; i < begin + count; ++i) {
      const TrailStep& step = view_.steps[shown_[i]];
      if (step.thread != row.thread) row.thread = -1;
      first = std::min(first, step.log.line);
      last = std::max(last, step.log.line);
      for (const runtime::SlotChange& write : step.log.writes) {
        const auto same = [&](const Change& each) {
          return runtime::SameSlot(each.change.slot, write.slot);
        };
        const auto found = std::ranges::find_if(changes, same);
        if (found == changes.end()) {
          changes.push_back({&step.log, write});
        } else {
          found->change.after = write.after;
        }
      }
    }
    for (const Change& each : changes) AddChange(*each.step, each.change, &row);
    const std::string lines =
        first == last ? fmt::to_string(first) : fmt::format("{}–{}", first, last);
    row.statement = MakeMessage(first == last ? "line {0} × {1} more" : "lines {0} × {1} more",
                                "第 {0} 行，再 × {1}", lines, loop.times - 1)
                        .In(language_);
    rows_.rows.push_back(std::move(row));
  }

  const StepView& view_;
  Language language_;
  const vm::Object& object_;
  StatementTexts texts_;
  std::vector<size_t> shown_;
  std::vector<bool> carriers_;  ///< kFlow: for each step
  size_t accounted_ = 0;        ///< the first step that no row stands for
  size_t host_ = 0;             ///< the next one of the host's calls
  bool has_time_ = false;
  double at_ms_ = 0;
  StepRows rows_;
};

// --- Text ----------------------------------------------------------------------------------------

int WidthOf(std::string_view text) { return compiler::DisplayLine(text).ColumnOf(text.size()); }

/// `x = 3, a[1] = 0`.
std::string ReadText(const StepRow& row) {
  std::string text;
  for (const ValueRead& read : row.reads) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", read.name, read.value);
  }
  return text;
}

/// `x: 3 -> 4`.
std::string WrittenText(const StepRow& row) {
  std::string text;
  for (const ValueWritten& write : row.writes) {
    text += fmt::format("{}{}: {} -> {}", text.empty() ? "" : ", ", write.name, write.before,
                        write.after);
  }
  return text;
}

/// The text of a row's cell: `12  t = x;   [x = 0]   t: 3 -> 0`.
std::string CellOf(const StepRow& row, Language language) {
  const bool repeat = row.kind == StepRow::Kind::kRepeat;
  std::string text =
      repeat ? "      " + row.statement : fmt::format("{:>4}  {}", row.line, row.statement);
  if (!row.reads.empty()) text += "   [" + ReadText(row) + ']';
  if (!row.writes.empty()) text += "   " + WrittenText(row);
  if (row.escape) {
    text += MakeMessage("   <- from here on every continuation fails", "   <- 此后再无正确结局")
                .In(language);
  }
  return text;
}

/// The number of bytes of the first character.
size_t CharacterSize(std::string_view text) {
  size_t size = 1;
  while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) ++size;
  return size;
}

/// Breaks a cell into lines, between its parts if possible, otherwise between words; continuation
/// lines are indented like the statement.
class Breaker {
 public:
  explicit Breaker(int width) : width_(width) {}

  std::vector<std::string> Break(std::string_view text) {
    const size_t indent = std::min(text.find_first_not_of(' '), text.size());
    line_ = text.substr(0, indent);
    text.remove_prefix(indent);
    size_t gap = 0;
    while (!text.empty()) {
      const size_t end = std::min(text.find(kBetweenParts), text.size());
      AddPart(text.substr(0, end), gap);
      gap = kBetweenParts.size();
      text.remove_prefix(std::min(end + gap, text.size()));
    }
    lines_.push_back(std::move(line_));
    return std::move(lines_);
  }

 private:
  static constexpr std::string_view kBetweenParts = "   ";
  static constexpr std::string_view kIndent = "        ";

  bool Fits(std::string_view text, size_t gap) const {
    return WidthOf(line_) + static_cast<int>(gap) + WidthOf(text) <= width_;
  }
  bool Empty() const { return line_.find_first_not_of(' ') == std::string::npos; }
  void NewLine() { lines_.push_back(std::exchange(line_, std::string(kIndent))); }

  void AddPart(std::string_view part, size_t gap) {
    if (!Fits(part, gap) && !Empty() && WidthOf(kIndent) + WidthOf(part) <= width_) {
      NewLine();
      gap = 0;
    }
    while (!part.empty()) {
      const size_t end = std::min(part.find(' '), part.size());
      AddWord(part.substr(0, end), gap);
      part.remove_prefix(end);
      gap = std::min(part.find_first_not_of(' '), part.size());
      part.remove_prefix(gap);
    }
  }

  void AddWord(std::string_view word, size_t gap) {
    if (Empty() || Fits(word, gap)) {
      line_.append(gap, ' ');
    } else {
      NewLine();
    }
    while (!word.empty()) {
      const size_t size = CharacterSize(word);
      if (!Fits(word.substr(0, size), 0) && !Empty()) NewLine();
      line_ += word.substr(0, size);
      word.remove_prefix(size);
    }
  }

  int width_;
  std::string line_;
  std::vector<std::string> lines_;
};

std::string Padded(const std::string& text, int width) {
  return text + std::string(static_cast<size_t>(std::max(0, width - WidthOf(text))), ' ');
}

void TrimEnd(std::string* text) {
  while (text->ends_with(' ')) text->pop_back();
}

/// Width of the step numbers.
constexpr int kNumberWidth = 6;
constexpr int kGap = 2;
/// Minimum width of a column.
constexpr int kColumnMin = 24;

/// The columns' widths: those of their cells if they fit; empty if there is not enough room.
std::vector<int> Fitted(std::vector<int> widths, int width) {
  int room = width - kNumberWidth - kGap * static_cast<int>(widths.size());
  std::vector<int> order(widths.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::ranges::stable_sort(order, {},
                           [&](int column) { return widths[static_cast<size_t>(column)]; });
  auto left = static_cast<int>(order.size());
  for (const int column : order) {
    int& own = widths[static_cast<size_t>(column)];
    const int share = room / left--;
    if (own > share && share < kColumnMin) return {};
    own = std::min(own, share);
    room -= own;
  }
  return widths;
}

class TextMaker {
 public:
  TextMaker(const StepView& view, int width, Language language)
      : view_(view), width_(width), language_(language), curve_(view.trace) {}

  std::string Make() {
    const StepRows rows = RowsOf(view_, language_);
    LayOut(rows.rows);
    if (!shared_) AddHeads();
    for (const StepRow& row : rows.rows) {
      if (row.kind == StepRow::Kind::kTime) {
        text_ += fmt::format("{} ms", row.at_ms) + curve_.BarAt(row.at_ms) + '\n';
      } else if (row.kind == StepRow::Kind::kHost) {
        text_ += fmt::format("{} ms  {}\n", row.at_ms, row.statement);
      } else {
        AddRow(row);
      }
    }
    const double end = view_.steps.empty() ? 0 : view_.steps.back().log.at_ms;
    for (const double at_ms : curve_.TailAfter(end)) {
      text_ += fmt::format("{} ms", at_ms) + curve_.BarAt(at_ms) + '\n';
    }
    return std::move(text_);
  }

 private:
  size_t Column(const StepRow& row) const {
    return shared_ || row.thread < 0 ? 0 : static_cast<size_t>(row.thread);
  }
  std::string Cell(const StepRow& row) const {
    std::string cell = CellOf(row, language_);
    if (!shared_ || row.thread < 0) return cell;
    return ThreadHead(view_.subject, static_cast<size_t>(row.thread), language_) + cell;
  }

  void LayOut(const std::vector<StepRow>& rows) {
    std::vector<int> widths(view_.subject.threads.size());
    for (size_t i = 0; i < widths.size(); ++i) {
      widths[i] = WidthOf(ThreadHead(view_.subject, i, language_));
    }
    for (const StepRow& row : rows) {
      const bool has_column =
          row.kind == StepRow::Kind::kStep || row.kind == StepRow::Kind::kRepeat;
      if (!has_column || row.thread < 0) continue;
      int& own = widths[static_cast<size_t>(row.thread)];
      own = std::max(own, WidthOf(CellOf(row, language_)));
    }
    widths_ = width_ == 0 ? widths : Fitted(widths, width_);
    shared_ = widths_.empty();
    if (shared_) widths_ = {std::max(width_ - kNumberWidth - kGap, kColumnMin)};
  }

  void AddHeads() {
    std::string heads(kNumberWidth, ' ');
    for (size_t i = 0; i < widths_.size(); ++i) {
      heads += std::string(kGap, ' ') + Padded(ThreadHead(view_.subject, i, language_), widths_[i]);
    }
    TrimEnd(&heads);
    text_ += heads + '\n';
  }

  void AddRow(const StepRow& row) {
    const size_t column = Column(row);
    int before = kNumberWidth;
    for (size_t i = 0; i < column; ++i) before += widths_[i] + kGap;
    std::string number = row.kind == StepRow::Kind::kRepeat ? "..." : fmt::to_string(row.step + 1);
    number.insert(0, static_cast<size_t>(std::max(0, kNumberWidth - WidthOf(number))), ' ');
    // A row for a loop in which several threads take turns has no other cells beside it.
    int room = widths_[column];
    if (row.thread < 0) room = width_ == 0 ? WidthOf(CellOf(row, language_)) : width_ - before;
    for (const std::string& part : Breaker(std::max(room, kColumnMin)).Break(Cell(row))) {
      std::string line = Padded(std::exchange(number, ""), before + kGap) + part;
      TrimEnd(&line);
      text_ += line + '\n';
    }
  }

  const StepView& view_;
  int width_;
  Language language_;
  AxisCurve curve_;
  std::vector<int> widths_;
  bool shared_ = false;  ///< all threads share one column
  std::string text_;
};

}  // namespace

StepRows RowsOf(const StepView& view, Language language) { return RowMaker(view, language).Make(); }

std::string ThreadHead(const Subject& subject, size_t thread, Language language) {
  const ThreadSetup& setup = subject.threads[thread];
  const auto& functions = subject.image->object.functions;
  return fmt::format("{} {} {}", language == Language::kChinese ? "线程" : "thread", setup.thread,
                     functions[static_cast<size_t>(setup.function)].name);
}

std::string TextTable(const StepView& view, int width, Language language) {
  return TextMaker(view, width, language).Make();
}

std::string HtmlTable(const StepView& view, Language language) {
  const size_t threads = view.subject.threads.size();
  std::string table =
      "<div class=\"wide\">\n<table class=\"steps\">\n<thead><tr><th></th><th></th>";
  for (size_t i = 0; i < threads; ++i) {
    table += fmt::format("<th>{}</th>", EscapeMarkup(ThreadHead(view.subject, i, language)));
  }
  table += "</tr></thead>\n";
  for (const StepRow& row : RowsOf(view, language).rows) {
    if (row.kind == StepRow::Kind::kTime || row.kind == StepRow::Kind::kHost) {
      table +=
          fmt::format("<tr class=\"time\"><td colspan=\"{}\">{} ms{}{}</td></tr>\n", threads + 2,
                      row.at_ms, row.statement.empty() ? "" : "   ", EscapeMarkup(row.statement));
      continue;
    }
    const bool repeat = row.kind == StepRow::Kind::kRepeat;
    table += repeat ? "<tr><td class=\"number\">...</td><td></td>"
                    : fmt::format("<tr><td class=\"number\">{}</td><td class=\"line\">{}</td>",
                                  row.step + 1, row.line);
    for (int column = 0; column < row.thread; ++column) table += "<td></td>";
    table += row.thread < 0 ? fmt::format("<td class=\"repeat\" colspan=\"{}\">", threads)
                            : fmt::format("<td class=\"{}{}\">", repeat ? "repeat" : "statement",
                                          row.escape ? " escape" : "");
    table += EscapeMarkup(row.statement);
    if (!row.reads.empty()) {
      table += fmt::format("   <span class=\"read\">[{}]</span>", EscapeMarkup(ReadText(row)));
    }
    if (!row.writes.empty()) {
      table += fmt::format("   <span class=\"written\">{}</span>", EscapeMarkup(WrittenText(row)));
    }
    table += "</td></tr>\n";
  }
  table += "</table>\n</div>\n";
  const std::string picture = AxisCurve(view.trace).Svg();
  if (picture.empty()) return table;
  return "<div class=\"beside\">\n" + table + picture + "</div>\n";
}

}  // namespace oncard::explore
