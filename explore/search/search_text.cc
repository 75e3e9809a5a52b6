// Search files as text: JSON, docs/search-format.md. The reader checks the type and range of every
// value. It does not check indices into the program; search_check.h does this with the program.
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json_text.h"
#include "base/number.h"
#include "explore/search/search_file.h"

namespace oncard::explore {
namespace {

/// Not the ordered one, which looks at all keys of an object for each that it reads.
using Json = nlohmann::json;

constexpr std::string_view kKind = "oncard search";
constexpr int kVersion = 4;

/// Maximum nesting of objects and lists in a search file.
constexpr int kNestingMax = 16;
/// Maximum of counts: large enough for any search, small enough that files can be added up.
constexpr int64_t kCountMax = 1'000'000'000'000'000;

// --- Writing -------------------------------------------------------------------------------------

/// Writes the text directly: as a document in memory, the plans of a long search would take several
/// times the space of the search, and longer than many a time limit leaves.
class TextWriter {
 public:
  std::string Take() { return std::exchange(text_, {}); }

  /// Begins a value: the next one of the list, or that with a key of the object.
  void Next() {
    if (const char last = text_.empty() ? '[' : text_.back(); last != '[' && last != '{') {
      text_ += ',';
    }
  }
  void Next(std::string_view key) {
    Next();
    fmt::format_to(std::back_inserter(text_), "\"{}\":", key);
  }
  void Open(char bracket) { text_ += bracket; }
  void Close(char bracket) { text_ += bracket; }

  void Put(std::string_view key, int64_t number) {
    Next(key);
    PutNumber(number);
  }
  void PutUnsigned(std::string_view key, uint64_t number) {
    Next(key);
    PutNumber(number);
  }
  void PutFlag(std::string_view key, bool flag) {
    Next(key);
    text_ += flag ? "true" : "false";
  }
  void PutText(std::string_view key, std::string_view text) {
    Next(key);
    text_ += JsonText(nlohmann::ordered_json(text));
  }
  template <typename Number>
  void PutList(std::string_view key, const std::vector<Number>& numbers) {
    Next(key);
    PutNumbers(numbers);
  }
  void PutPlans(std::string_view key, const std::vector<PlannedStep>& plans) {
    Next(key);
    Open('[');
    for (const PlannedStep& plan : plans) {
      Next();
      PutNumber(plan.thread);
      text_ += ',';
      PutNumber(plan.next);
    }
    Close(']');
  }
  void PutKeys(std::string_view key, const std::vector<StateKey>& keys) {
    Next(key);
    Open('[');
    for (const StateKey& state : keys) {
      Next();
      fmt::format_to(std::back_inserter(text_), "\"{:016x}{:016x}\"", state.low, state.high);
    }
    Close(']');
  }
  void PutEnds(std::string_view key, const EndSet& ends) {
    Next(key);
    Open('[');
    for (const End& end : ends.ends()) {
      Next();
      PutNumbers(end);
    }
    Close(']');
  }

 private:
  template <typename Number>
  void PutNumber(Number number) {
    if (number >= 0 && number <= 9) {
      text_ += static_cast<char>('0' + number);
      return;
    }
    const fmt::format_int digits(number);
    text_.append(digits.data(), digits.size());
  }
  template <typename Number>
  void PutNumbers(const std::vector<Number>& numbers) {
    Open('[');
    for (const Number number : numbers) {
      Next();
      PutNumber(number);
    }
    Close(']');
  }

  std::string text_;
};

void PutUnit(const TraceUnit& unit, TextWriter* writer) {
  writer->Next();
  writer->Open('{');
  writer->PutList("prefix", unit.prefix);
  writer->PutList("sleep", unit.sleep);
  if (!unit.frames.empty()) {
    writer->Next("frames");
    writer->Open('[');
    for (const SavedFrame& frame : unit.frames) {
      writer->Next();
      writer->Open('{');
      writer->PutList("sleep", frame.sleep);
      writer->PutPlans("plans", frame.plans);
      writer->PutList("races", frame.races);
      writer->Close('}');
    }
    writer->Close(']');
  }
  writer->Close('}');
}

void PutTraces(const TraceSearch& traces, TextWriter* writer) {
  writer->Next("units");
  writer->Open('[');
  for (const TraceUnit& unit : traces.units) PutUnit(unit, writer);
  writer->Close(']');
  writer->Put("executions", traces.executions);
  writer->Put("blocked", traces.blocked);
  writer->Put("redundant", traces.redundant);
  writer->Put("bad", traces.bad);
  writer->PutFlag("too_deep", traces.too_deep);
  writer->PutKeys("globals", traces.globals);
  writer->PutKeys("full", traces.full);
  writer->PutEnds("results", traces.ends);
  writer->PutList("failing", traces.failing);
}

void PutSamples(const SearchFile& file, TextWriter* writer) {
  writer->PutUnsigned("seed", file.seed);
  writer->Put("depth", file.depth);
  writer->Put("runs_of_all", file.runs);
  writer->Put("runs_cut", file.runs_cut);
  writer->Put("runs", file.samples.runs);
  writer->Put("bad", file.samples.bad);
  writer->Put("cut", file.samples.cut);
  writer->Put("longest", file.samples.longest);
  writer->PutKeys("ends", file.samples.ends);
  writer->PutEnds("results", file.samples.values);
  writer->PutList("failing", file.samples.failing);
}

/// Before the checksum, which is the last value.
constexpr std::string_view kCheck = ",\"check\":\"";

/// The checksum of everything before it, so that manual changes are noticed. It is no protection.
std::string CheckOf(std::string_view before) {
  return fmt::format("{:016x}", XXH64(before.data(), before.size(), 0));
}

/// True if the text ends in the checksum of what is before it.
bool IsUnchanged(std::string_view text) {
  const size_t at = text.rfind(kCheck);
  if (at == std::string_view::npos) return false;
  const std::string_view check = text.substr(at + kCheck.size());
  return check.substr(0, check.find('"')) == CheckOf(text.substr(0, at));
}

// --- Reading -------------------------------------------------------------------------------------

/// True if at most `limit` objects and lists are nested; the JSON reader has no such limit, and a
/// deeper value could not even be written again.
bool NestsWithin(std::string_view text, int limit) {
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > limit) return false;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return true;
}

/// A value of the file and its path.
class Value {
 public:
  Value(const Json& json, const Value* parent, std::string_view key)
      : json_(json), parent_(parent), key_(key) {}
  Value(const Json& json, const Value* parent, size_t index)
      : json_(json), parent_(parent), index_(index) {}

  const Json& json() const { return json_; }
  /// `traces.units[3].prefix`.
  std::string Place() const {
    if (parent_ == nullptr) return std::string(key_);
    const std::string before = parent_->Place();
    if (key_.empty()) return fmt::format("{}[{}]", before, index_);
    return before.empty() ? std::string(key_) : fmt::format("{}.{}", before, key_);
  }

 private:
  const Json& json_;
  const Value* parent_;
  std::string_view key_;
  size_t index_ = 0;
};

/// Reads values with their types from the file, and keeps the first one that has another type.
class TypedReader {
 public:
  bool failed() const { return failed_; }
  Error error() const { return {1, error_}; }

  Value Member(const Value& object, std::string_view key) {
    static const Json kAbsent;
    if (!object.json().is_object()) Fail(object, "an object", "对象");
    const auto found = object.json().is_object() ? object.json().find(key) : object.json().end();
    const bool there = object.json().is_object() && found != object.json().end();
    return {there ? *found : kAbsent, &object, key};
  }

  /// Whole numbers from `least` to `most`.
  template <typename Number = int64_t>
  Number Whole(const Value& value, Number least, Number most) {
    const Json& json = value.json();
    const bool small = json.is_number_integer() && !json.is_number_unsigned();
    if (small && std::in_range<Number>(json.get<int64_t>())) {
      const auto number = static_cast<Number>(json.get<int64_t>());
      if (number >= least && number <= most) return number;
    }
    if (json.is_number_unsigned() && std::in_range<Number>(json.get<uint64_t>())) {
      const auto number = static_cast<Number>(json.get<uint64_t>());
      if (number >= least && number <= most) return number;
    }
    Fail(value, fmt::format("a whole number from {} to {}", +least, +most),
         fmt::format("{} 至 {} 的整数", +least, +most));
    return least;
  }
  int64_t Count(const Value& value) { return Whole<int64_t>(value, 0, kCountMax); }

  bool Flag(const Value& value) {
    if (!value.json().is_boolean()) Fail(value, "true or false", "true 或 false");
    return value.json() == true;
  }

  std::string Text(const Value& value) {
    if (value.json().is_string()) return value.json().get<std::string>();
    Fail(value, "a text", "文本");
    return {};
  }

  uint64_t Key(const Value& value) {
    const std::string text = Text(value);
    const auto key = text.size() == 16 ? ReadWhole<uint64_t>(text, 16) : std::nullopt;
    if (!key) Fail(value, "16 hexadecimal digits", "16 位十六进制数");
    return key.value_or(0);
  }

  /// Calls `take` with each element.
  template <typename Take>
  void Each(const Value& list, const Take& take) {
    if (!list.json().is_array()) return Fail(list, "a list", "列表");
    for (size_t i = 0; i < list.json().size() && !failed_; ++i) {
      take(Value(list.json()[i], &list, i));
    }
  }

  template <typename Number>
  std::vector<Number> Wholes(const Value& list, Number least, Number most) {
    std::vector<Number> numbers;
    Each(list, [&](const Value& value) { numbers.push_back(Whole<Number>(value, least, most)); });
    return numbers;
  }
  /// Threads of the model, at most as many as there can be.
  std::vector<uint8_t> Threads(const Value& list) {
    return Wholes<uint8_t>(list, 0, kThreadMax - 1);
  }

  /// In ascending order, without duplicates.
  std::vector<StateKey> Keys(const Value& list) {
    std::vector<StateKey> keys;
    Each(list, [&](const Value& value) {
      const std::string text = Text(value);
      const auto low = ReadWhole<uint64_t>(std::string_view(text).substr(0, 16), 16);
      const auto high = text.size() == 32
                            ? ReadWhole<uint64_t>(std::string_view(text).substr(16), 16)
                            : std::nullopt;
      const StateKey key = {low.value_or(0), high.value_or(0)};
      if (!low || !high || (!keys.empty() && !(keys.back() < key))) {
        Fail(value, "32 hexadecimal digits, greater than the previous ones",
             "32 位十六进制数，且大于前一个");
      }
      keys.push_back(key);
    });
    return keys;
  }

  EndSet Ends(const Value& list) {
    EndSet ends;
    Each(list, [&](const Value& end) { ends.Add(Wholes<int64_t>(end, INT64_MIN, INT64_MAX)); });
    return ends;
  }

  /// Keeps the error: what was expected of a value.
  void Fail(const Value& value, std::string_view expected_en, std::string_view expected_zh) {
    if (failed_) return;
    failed_ = true;
    if (value.json().is_null()) {
      error_ = MakeMessage("'{0}' is missing: expected {1}", "缺少“{0}”：应为{2}", value.Place(),
                           expected_en, expected_zh);
      return;
    }
    constexpr size_t kShown = 40;
    std::string found = value.json().dump(-1, ' ', true, Json::error_handler_t::replace);
    if (found.size() > kShown) found = found.substr(0, kShown) + "...";
    error_ = MakeMessage("'{0}' is {1}: expected {2}", "“{0}”为 {1}：应为{3}", value.Place(), found,
                         expected_en, expected_zh);
  }

 private:
  bool failed_ = false;
  Message error_;
};

std::vector<PlannedStep> PlansFrom(TypedReader& reader, const Value& list) {
  const auto numbers = reader.Wholes<uint32_t>(list, 0, std::numeric_limits<uint32_t>::max());
  std::vector<PlannedStep> plans;
  if (numbers.size() % 2 != 0) reader.Fail(list, "pairs of numbers", "成对的数");
  for (size_t i = 0; i + 1 < numbers.size(); i += 2) {
    if (numbers[i] >= kThreadMax) {
      reader.Fail(list, fmt::format("threads from 0 to {}", kThreadMax - 1),
                  fmt::format("0 至 {} 的线程", kThreadMax - 1));
    }
    plans.push_back({static_cast<uint8_t>(numbers[i]), numbers[i + 1]});
  }
  return plans;
}

TraceUnit UnitFrom(TypedReader& reader, const Value& value) {
  TraceUnit unit = {reader.Threads(reader.Member(value, "prefix")),
                    reader.Threads(reader.Member(value, "sleep"))};
  const Value frames = reader.Member(value, "frames");
  if (frames.json().is_null()) return unit;  // the unit has not begun
  reader.Each(frames, [&](const Value& frame) {
    unit.frames.push_back({reader.Threads(reader.Member(frame, "sleep")),
                           PlansFrom(reader, reader.Member(frame, "plans")),
                           reader.Wholes<uint32_t>(reader.Member(frame, "races"), 0,
                                                   std::numeric_limits<uint32_t>::max())});
  });
  return unit;
}

TraceSearch TracesFrom(TypedReader& reader, const Value& value) {
  TraceSearch traces;
  traces.units.clear();
  reader.Each(reader.Member(value, "units"),
              [&](const Value& unit) { traces.units.push_back(UnitFrom(reader, unit)); });
  traces.executions = reader.Count(reader.Member(value, "executions"));
  traces.blocked = reader.Count(reader.Member(value, "blocked"));
  traces.redundant = reader.Count(reader.Member(value, "redundant"));
  traces.bad = reader.Count(reader.Member(value, "bad"));
  traces.too_deep = reader.Flag(reader.Member(value, "too_deep"));
  traces.globals = reader.Keys(reader.Member(value, "globals"));
  traces.full = reader.Keys(reader.Member(value, "full"));
  traces.ends = reader.Ends(reader.Member(value, "results"));
  traces.failing = reader.Threads(reader.Member(value, "failing"));
  return traces;
}

void SamplesFrom(TypedReader& reader, const Value& value, SearchFile* file) {
  file->seed =
      reader.Whole<uint64_t>(reader.Member(value, "seed"), 0, std::numeric_limits<uint64_t>::max());
  file->depth = reader.Whole<int>(reader.Member(value, "depth"), 1, kPctDepthMax);
  file->runs = reader.Count(reader.Member(value, "runs_of_all"));
  const Value runs_cut = reader.Member(value, "runs_cut");
  file->runs_cut = reader.Count(runs_cut);
  file->samples.seed = file->seed;
  file->samples.runs = reader.Count(reader.Member(value, "runs"));
  file->samples.bad = reader.Count(reader.Member(value, "bad"));
  file->samples.cut = reader.Count(reader.Member(value, "cut"));
  file->samples.longest = reader.Count(reader.Member(value, "longest"));
  file->samples.ends = reader.Keys(reader.Member(value, "ends"));
  file->samples.values = reader.Ends(reader.Member(value, "results"));
  file->samples.failing = reader.Threads(reader.Member(value, "failing"));
  if (reader.failed()) return;
  const int64_t left =
      file->held.size() > 1 ? 0 : RunsOfPart(file->runs, {file->held.front(), file->parts}).second;
  if (file->runs_cut > left) {
    reader.Fail(runs_cut, fmt::format("at most the {} runs of its part", left),
                fmt::format("不超过该部分的 {} 次运行", left));
  }
}

std::vector<int> HeldFrom(TypedReader& reader, const Value& value, int parts) {
  std::vector<int> held = reader.Wholes<int>(value, 1, parts);
  const bool in_order = std::ranges::adjacent_find(held, std::greater_equal{}) == held.end();
  if (held.empty() || !in_order) {
    reader.Fail(value, "numbers of parts, in order", "按顺序排列的部分编号");
  }
  return held;
}

EngineKind EngineFrom(TypedReader& reader, const Value& value) {
  const auto engine = EngineNamed(reader.Text(value)).value_or(EngineKind::kAuto);
  switch (engine) {
    case EngineKind::kDpor:
    case EngineKind::kRandom:
    case EngineKind::kPct:
    case EngineKind::kPos:
      return engine;
    case EngineKind::kAuto:
    case EngineKind::kStateful:
    case EngineKind::kBounded:
    case EngineKind::kFollow:
      break;
  }
  reader.Fail(value, "dpor, random, pct or pos", "dpor、random、pct 或 pos");
  return EngineKind::kDpor;
}

}  // namespace

std::string FormatSearchFile(const SearchFile& file) {
  TextWriter writer;
  writer.Open('{');
  writer.PutText("kind", kKind);
  writer.Put("version", kVersion);
  writer.PutText("input", file.input);
  writer.PutText("problem", fmt::format("{:016x}", file.problem));
  writer.PutText("races", file.races);
  writer.PutText("engine", EngineName(file.engine));
  writer.Put("parts", file.parts);
  writer.PutList("held", file.held);
  const bool traced = file.engine == EngineKind::kDpor;
  writer.Next(traced ? "traces" : "samples");
  writer.Open('{');
  if (traced) {
    PutTraces(file.traces, &writer);
  } else {
    PutSamples(file, &writer);
  }
  writer.Close('}');
  std::string text = writer.Take();
  const std::string check = CheckOf(text);
  return text.append(kCheck).append(check).append("\"}\n");
}

Result<SearchFile> ParseSearchFile(std::string_view text) {
  if (!NestsWithin(text, kNestingMax)) {
    return MakeError(1, "this is not a search file: it is nested more than {0} deep",
                     "这不是搜索文件：嵌套超过 {0} 层", kNestingMax);
  }
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("kind", Json()) != kKind) {
    return MakeError(1, "this is not a search file: expected one that 'oncard explore' has written",
                     "这不是搜索文件：应为“oncard explore”写出的文件");
  }
  if (json.value("version", Json()) != kVersion) {
    return MakeError(1, "the file is of another version: expected {0}", "文件版本不符：应为 {0}",
                     kVersion);
  }
  if (!IsUnchanged(text)) {
    return MakeError(1, "the file has been modified: explore again", "文件已被改动：请重新探索");
  }
  TypedReader reader;
  const Value root(json, nullptr, "");
  SearchFile file;
  file.input = reader.Text(reader.Member(root, "input"));
  file.problem = reader.Key(reader.Member(root, "problem"));
  const Value races = reader.Member(root, "races");
  file.races = reader.Text(races);
  if (!RaceRuleNamed(file.races)) reader.Fail(races, "any, benign or none", "any、benign 或 none");
  file.engine = EngineFrom(reader, reader.Member(root, "engine"));
  file.parts = reader.Whole<int>(reader.Member(root, "parts"), 1, kPartMax);
  file.held = HeldFrom(reader, reader.Member(root, "held"), file.parts);
  if (file.engine == EngineKind::kDpor) {
    file.traces = TracesFrom(reader, reader.Member(root, "traces"));
  } else {
    SamplesFrom(reader, reader.Member(root, "samples"), &file);
  }
  if (reader.failed()) return reader.error();
  return file;
}

}  // namespace oncard::explore
