#include "runtime/observe/trace.h"
#include "base/milliseconds.h"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <bitset>
#include <cmath>
#include <optional>
#include <utility>

namespace oncard::runtime {
namespace {

// Identifier codes of a VCD consist of the printable characters ! to ~.
constexpr int kVcdFirst = '!';
constexpr int kVcdCount = '~' - '!' + 1;

// An encoder counts whole pulses, so even for an axis that follows exactly the error is up to half
// a pulse.
constexpr double kErrorWorthShowing = 1;

// Values of parts of the card that a trace contains by default.
struct DefaultValue {
  std::string_view part;
  std::string_view value;
  double threshold = 0;
};

constexpr DefaultValue kDefaultValues[] = {
    {"axis", "prfPos"},     {"axis", "prfVel"},
    {"axis", "prfAcc"},     {"axis", "error", kErrorWorthShowing},
    {"axis", "alarm"},      {"axis", "followingError"},
    {"axis", "posLimit"},   {"axis", "negLimit"},
    {"axis", "smoothStop"}, {"axis", "abruptStop"},
    {"axis", "inPosition"}, {"dac", ""},
    {"crd", "x"},           {"crd", "y"},
    {"crd", "z"},           {"crd", "vel"},
    {kHsioPart, ""},
};

std::string VcdCode(size_t index) {
  std::string code;
  do {
    code += static_cast<char>(kVcdFirst + static_cast<int>(index % kVcdCount));
    index /= kVcdCount;
  } while (index != 0);
  return code;
}

void AppendVcdChange(double value, NumberForm form, const std::string& code, std::string* text) {
  switch (form) {
    case NumberForm::kFlag:
      *text += value != 0 ? '1' : '0';
      break;
    case NumberForm::kReal:
    case NumberForm::kFixedPoint:
      *text += 'r';
      AppendNumber(value, form, text);
      *text += ' ';
      break;
    case NumberForm::kWhole:
      *text += 'b';
      *text += std::bitset<32>(static_cast<uint32_t>(static_cast<int64_t>(value))).to_string();
      *text += ' ';
      break;
  }
  *text += code;
  *text += '\n';
}

std::string VcdType(NumberForm form) {
  switch (form) {
    case NumberForm::kFlag:
      return "wire 1";
    case NumberForm::kReal:
    case NumberForm::kFixedPoint:
      return "real 64";
    case NumberForm::kWhole:
      break;
  }
  return "wire 32";
}

// Names of a program only contain letters, digits, dots and brackets; a mark may contain anything.
std::string JsonString(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + '"';
}

int64_t TimeOf(const Controller& controller) { return controller.clock().UsOf(controller.cycle()); }

}  // namespace

std::vector<TraceColumn> DefaultColumns(const Controller& controller) {
  std::vector<TraceColumn> columns;
  const auto add = [&](const std::string& name, double threshold) {
    auto found = ResolveQuantity(name, controller);
    if (!found.ok()) return;  // hidden by a global variable
    for (Quantity& quantity : found.value()) {
      const double shown = quantity.Shown(threshold);
      columns.push_back({std::move(quantity), true, shown});
    }
  };
  for (const DefaultValue& row : kDefaultValues) {
    const MotionPart& part = *FindMotionPart(row.part);
    const int count = static_cast<int>(part.count(controller.motion()));
    for (int i = 0; i < count; ++i) {
      add(MotionValueName(part, part.first + i, row.value), row.threshold);
    }
  }
  for (const std::string_view word : WordNames()) add(std::string(word), 0);
  return columns;
}

Trace::Trace(std::vector<TraceColumn> columns) {
  for (TraceColumn& column : columns) {
    const bool known = std::any_of(
        columns_.begin(), columns_.end(),
        [&](const TraceColumn& earlier) { return earlier.quantity.name == column.quantity.name; });
    if (!known) columns_.push_back(std::move(column));
  }
  rows_ = RowLog(columns_.size());
  sample_.resize(columns_.size());
}

void Trace::Sample(const Controller& controller) {
  const int64_t time_us = TimeOf(controller);
  if (!rows_.empty() && time_us > sampled_us_) AddOutputEdges(controller, time_us);
  sampled_us_ = time_us;
  cycle_us_ = std::max(cycle_us_, controller.clock().cycle_us());
  per_cycle_ = controller.family().cycle_ns != 0;
  ReadColumns(controller);
  SampleThreads(controller, time_us);
  if (rows_.empty()) {
    for (const TraceColumn& column : columns_) {
      forms_.push_back(FormOfQuantity(column.quantity, controller));
    }
  } else if (rows_.last().values == sample_) {
    return;
  }
  rows_.Add(time_us, sample_);
}

void Trace::ReadColumns(const Controller& controller) {
  const gtcalls::CardView card = controller.view();
  for (size_t i = 0; i < columns_.size(); ++i) {
    const Quantity& quantity = columns_[i].quantity;
    // Nearly all columns are values of the motion core.
    sample_[i] = quantity.kind == QuantityKind::kMotion
                     ? quantity.Shown(quantity.value->read(card, quantity.index))
                     : ReadQuantity(quantity, controller);
  }
}

void Trace::AddOutputEdges(const Controller& controller, int64_t time_us) {
  struct Change {
    int64_t at_us;
    size_t column;
    double level;
  };
  std::vector<Change> changes;
  const MotionValue* output = FindMotionPart(kHsioPart)->values.data();
  for (const motion::HsioEdge& edge : controller.motion().state().compare.edges()) {
    const auto at_us =
        static_cast<int64_t>(std::round(controller.clock().FromCoreUs(edge.instant)));
    if (at_us >= time_us) continue;  // it is part of the sample
    for (size_t i = 0; i < columns_.size(); ++i) {
      const Quantity& quantity = columns_[i].quantity;
      if (quantity.value != output || quantity.index != edge.channel) continue;
      changes.push_back({at_us, i, edge.level ? 1.0 : 0.0});
    }
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.at_us < b.at_us; });
  for (const Change& change : changes) {
    if (rows_.last().time_us < change.at_us) rows_.Repeat(change.at_us, true);
    rows_.SetLast(change.column, change.level);
  }
}

void Trace::SampleThreads(const Controller& controller, int64_t time_us) {
  const vm::Machine& machine = controller.machine();
  for (int thread = 0; thread < vm::kThreadCount; ++thread) {
    const vm::ThreadState& state = machine.thread(thread);
    const bool runs = state.run == vm::ThreadRun::kRunning;
    if (runs == running_[static_cast<size_t>(thread)]) continue;
    running_.flip(static_cast<size_t>(thread));
    if (runs) {
      const std::string& function = machine.image()->object.functions[state.function].name;
      open_.push_back({thread, function, time_us, time_us});
    } else {
      const auto open = std::ranges::find(open_, thread, &TraceSpan::thread);
      open->end_us = time_us;
      spans_.push_back(std::move(*open));
      open_.erase(open);
    }
  }
}

void Trace::Finish(const Controller& controller) {
  Sample(controller);
  const TraceRow& last = rows_.last();
  if (last.time_us != sampled_us_) rows_.Repeat(sampled_us_, last.inside_cycle);
  for (TraceSpan& span : open_) {
    span.end_us = sampled_us_;
    spans_.push_back(std::move(span));
  }
  open_.clear();
  running_.reset();
  DropUnchanged();
}

void Trace::Mark(const Controller& controller, std::string text) {
  marks_.push_back({TimeOf(controller), {text, text}});
}

void Trace::DropUnchanged() {
  std::vector<size_t> kept;
  for (size_t i = 0; i < columns_.size(); ++i) {
    const double first = rows_.front().values[i];
    const RowLog::Range range = rows_.RangeOf(i);
    const double change = std::max(range.greatest - first, first - range.least);
    if (columns_[i].only_if_changed && !(change > columns_[i].threshold)) continue;
    if (kept.size() != i) {
      columns_[kept.size()] = std::move(columns_[i]);
      forms_[kept.size()] = forms_[i];
    }
    kept.push_back(i);
  }
  columns_.resize(kept.size());
  forms_.resize(kept.size());
  sample_.resize(kept.size());
  rows_.Keep(kept);
}

void Trace::WriteCsv(const TextSink& sink) const {
  TextBuffer text(sink);
  text += "time_ms";
  for (const TraceColumn& column : columns_) text += ',' + column.quantity.Title();
  text += "\n";
  RowLog::Reader reader(rows_);
  // Most values equal those of the row before, to the bit: their texts are used again.
  std::vector<double> before(columns_.size());
  std::vector<std::string> cells(columns_.size());
  std::string line;
  while (reader.Next()) {
    const TraceRow& row = reader.row();
    line = FormatMs(row.time_us);
    for (size_t i = 0; i < cells.size(); ++i) {
      const double value = row.values[i];
      if (cells[i].empty() ||
          std::bit_cast<uint64_t>(value) != std::bit_cast<uint64_t>(before[i])) {
        cells[i] = ',';
        AppendNumber(value, forms_[i], &cells[i]);
        before[i] = value;
      }
      line += cells[i];
    }
    line += '\n';
    text += line;
  }
}

void Trace::WriteVcd(const TextSink& sink) const {
  TextBuffer text(sink);
  text += "$timescale 1 us $end\n$scope module oncard $end\n";
  std::string scope;
  for (size_t i = 0; i < columns_.size() && i < forms_.size(); ++i) {
    const std::string& name = columns_[i].quantity.name;
    const size_t dot = name.find('.');
    const std::string part = dot == std::string::npos ? "" : name.substr(0, dot);
    if (part != scope) {
      if (!scope.empty()) text += "$upscope $end\n";
      if (!part.empty()) text += fmt::format("$scope module {} $end\n", part);
      scope = part;
    }
    text += fmt::format("$var {} {} {} $end\n", VcdType(forms_[i]), VcdCode(i),
                        part.empty() ? name : name.substr(dot + 1));
    if (columns_[i].quantity.axis_unit.named()) {
      text += fmt::format("$comment {} $end\n", columns_[i].quantity.Title());
    }
  }
  if (!scope.empty()) text += "$upscope $end\n";
  text += "$upscope $end\n$enddefinitions $end\n";
  std::vector<std::string> codes;
  for (size_t i = 0; i < columns_.size(); ++i) codes.push_back(VcdCode(i));
  RowLog::Reader reader(rows_);
  std::vector<double> before;  // empty in the first row
  std::string change;
  while (reader.Next()) {
    const TraceRow& row = reader.row();
    text += fmt::format("#{}\n", row.time_us);
    for (size_t i = 0; i < row.values.size(); ++i) {
      if (!before.empty() && before[i] == row.values[i]) continue;
      change.clear();
      AppendVcdChange(row.values[i], forms_[i], codes[i], &change);
      text += change;
    }
    before = row.values;
  }
}

void Trace::WriteJson(const TextSink& sink) const {
  TextBuffer text(sink);
  const auto add = [&text](std::string_view event) {
    text += ",\n";
    text += event;
  };
  // Threads first, by number, then the marks' own row.
  text += "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n";
  text += R"({"name":"process_name","ph":"M","pid":1,"tid":0,"args":{"name":"oncard"}})";
  std::vector<int> named;
  for (const TraceSpan& span : spans_) {
    if (std::find(named.begin(), named.end(), span.thread) == named.end()) {
      named.push_back(span.thread);
      add(fmt::format(
          R"({{"name":"thread_name","ph":"M","pid":1,"tid":{},"args":{{"name":"thread {}"}}}})",
          span.thread, span.thread));
    }
    add(fmt::format(R"({{"name":{},"cat":"thread","ph":"X","pid":1,"tid":{},"ts":{},"dur":{}}})",
                    JsonString(span.function), span.thread, span.begin_us,
                    span.end_us - span.begin_us));
  }
  for (const TraceMark& mark : marks_) {
    add(fmt::format(R"({{"name":{},"cat":"{}","ph":"i","s":"p","pid":1,"tid":{},"ts":{}}})",
                    JsonString(mark.text.en), mark.by_card ? "card" : "host", vm::kThreadCount,
                    mark.time_us));
  }
  for (size_t i = 0; i < columns_.size(); ++i) {
    RowLog::Reader reader(rows_, {i});
    std::optional<double> before;
    std::string event =
        fmt::format(R"({{"name":"{}","ph":"C","pid":1,"ts":)", columns_[i].quantity.Title());
    const size_t head = event.size();
    while (reader.Next()) {
      const double value = reader.row().values.front();
      if (before != value) {
        event.resize(head);
        event += fmt::to_string(reader.row().time_us);
        event += R"(,"args":{"value":)";
        AppendNumber(value, forms_[i], &event);
        event += "}}";
        add(event);
      }
      before = value;
    }
  }
  text += "\n]}\n";
}

}  // namespace oncard::runtime
