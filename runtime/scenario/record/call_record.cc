#include "runtime/scenario/record/call_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_reader.h"
#include "base/json_text.h"
#include "base/utf8.h"
#include "gtcalls/card_elements.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/scenario_card.h"

namespace oncard::runtime {
namespace {

using gtcalls::Parameter;
using gtcalls::Passing;
using Json = nlohmann::ordered_json;

constexpr int64_t kFormat = 1;
constexpr std::string_view kTitle = "host calls";
/// Integers of JSON are exact up to here.
constexpr int64_t kWholeMax = int64_t{1} << 53;
constexpr int64_t kCardMax = 15;

// --- Values --------------------------------------------------------------------------------------

/// Files can contain any bytes: each becomes the character with its number.
std::string TextOfBytes(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) AppendUtf8(text, static_cast<unsigned char>(c));
  return text;
}

/// The reverse; empty if the text has characters that are no bytes.
std::optional<std::string> BytesOfText(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead < 0x80) {
      bytes += text[i];
    } else if ((lead == 0xC2 || lead == 0xC3) && i + 1 < text.size()) {
      bytes += static_cast<char>((lead << 6) | (static_cast<unsigned char>(text[++i]) & 0x3F));
    } else {
      return std::nullopt;
    }
  }
  return bytes;
}

void AppendWhole(int64_t value, std::string* line) {
  const fmt::format_int number(value);
  line->append(number.data(), number.size());
}

/// Appends a number; JSON has no infinite ones.
void AppendJsonNumber(double value, std::string* line) {
  const bool whole =
      value == std::trunc(value) && std::fabs(value) < static_cast<double>(kWholeMax);
  if (whole && !(value == 0 && std::signbit(value))) {
    AppendWhole(static_cast<int64_t>(value), line);
  } else if (std::isnan(value)) {
    *line += "\"nan\"";
  } else if (std::isinf(value)) {
    *line += value > 0 ? "\"inf\"" : "\"-inf\"";
  } else {
    *line += JsonText(value);
  }
}

std::optional<double> NumberOf(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "nan") return std::nan("");
  if (json == "inf") return HUGE_VAL;
  if (json == "-inf") return -HUGE_VAL;
  return std::nullopt;
}

/// Appends to a line `[`, what `append` makes of each element, and `]`.
template <typename Elements, typename Append>
void AppendList(const Elements& elements, const Append& append, std::string* line) {
  *line += '[';
  for (const auto& element : elements) {
    if (line->back() != '[') *line += ',';
    append(element);
  }
  *line += ']';
}

/// True for a pointer whose record has cells: the values that it refers to, or which arrays of the
/// host there are.
bool IsRead(const Parameter& parameter) {
  return parameter.passing == Passing::kInput || parameter.passing == Passing::kHostMemory;
}

void AppendArgument(const Parameter& parameter, const RecordedCall::Argument& argument,
                    std::string* line) {
  if (parameter.passing == Passing::kValue) return AppendJsonNumber(argument.value, line);
  if (argument.null) {
    *line += "null";
  } else if (parameter.passing == Passing::kText) {
    *line += JsonText(TextOfBytes(argument.text));
  } else if (!IsRead(parameter) || argument.unread) {
    *line += "true";
  } else {
    AppendList(
        argument.cells, [line](double cell) { AppendJsonNumber(cell, line); }, line);
  }
}

/// The members of a call that few calls have.
Json RareMembers(const RecordedCall& call) {
  Json json = Json::object();
  if (!call.acts) json["library"] = {call.reason.en, call.reason.zh};
  if (call.config) json["config"] = TextOfBytes(*call.config);
  if (call.program) {
    json["bin"] = TextOfBytes(call.program->bin);
    json["ini"] = TextOfBytes(call.program->ini);
    json["sources"] = Json::array();
    for (const RecordedSource& source : call.sources) {
      json["sources"].push_back(
          {{"path", TextOfBytes(source.path)}, {"text", TextOfBytes(source.text)}});
    }
  }
  return json;
}

std::string Line(const Json& json) { return JsonText(json) + '\n'; }

// --- Reading -------------------------------------------------------------------------------------

/// Fails only by `good`: what is read from then on is of no use.
class LineReader {
 public:
  explicit LineReader(const Json& json) : json_(json) {}

  bool good() const { return good_; }
  bool Has(const char* name) const { return json_.contains(name); }
  const Json& At(const char* name) {
    static const Json& none = *new const Json;
    const auto found = json_.find(name);
    if (found != json_.end()) return *found;
    good_ = false;
    return none;
  }
  int64_t Whole(const char* name, int64_t minimum, int64_t maximum) {
    const Json& value = At(name);
    const bool is = value.is_number_integer() && value >= minimum && value <= maximum;
    good_ = good_ && is;
    return is ? value.get<int64_t>() : minimum;
  }
  bool Flag(const char* name) {
    const Json& value = At(name);
    good_ = good_ && value.is_boolean();
    return value == true;
  }
  std::string Text(const char* name) {
    const Json& value = At(name);
    good_ = good_ && value.is_string();
    return value.is_string() ? value.get<std::string>() : std::string();
  }
  std::string Bytes(const char* name) {
    auto bytes = BytesOfText(Text(name));
    good_ = good_ && bytes.has_value();
    return std::move(bytes).value_or(std::string());
  }

 private:
  const Json& json_;
  bool good_ = true;
};

/// True for a number that the host can have passed as this type.
bool Fits(const Parameter& parameter, double value) {
  if (parameter.structure != nullptr || parameter.type == gtcalls::Scalar::kDouble) return true;
  return value == std::trunc(value) && std::fabs(value) < static_cast<double>(kWholeMax);
}

bool ReadCells(const Parameter& parameter, const Json& json, std::vector<double>* cells) {
  for (const Json& each : json) {
    const auto value = NumberOf(each);
    if (!value || !Fits(parameter, *value)) return false;
    cells->push_back(*value);
  }
  const size_t per_element = gtcalls::CellsPerElement(parameter);
  const bool several = parameter.count_parameter >= 0 || parameter.CountedByCard();
  return several ? cells->size() % per_element == 0 : cells->size() == per_element;
}

bool ReadArgument(const Parameter& parameter, const Json& json, RecordedCall::Argument* argument) {
  if (parameter.passing == Passing::kValue) {
    const auto value = NumberOf(json);
    if (!value || !Fits(parameter, *value)) return false;
    argument->value = *value;
    return true;
  }
  argument->null = json.is_null();
  if (argument->null) return true;
  if (parameter.passing == Passing::kText) {
    auto text = BytesOfText(json.is_string() ? json.get<std::string>() : "\xFF");
    if (!text) return false;
    argument->text = *std::move(text);
    // The host's texts end with a NUL.
    return argument->text.find('\0') == std::string::npos;
  }
  if (IsRead(parameter) && json.is_array()) {
    return ReadCells(parameter, json, &argument->cells);
  }
  argument->unread = IsRead(parameter);
  return json == true;
}

class RecordReader {
 public:
  /// A zero byte ends the record: the file of a host that was killed has more of them, and can have
  /// a part of the line that was being written after the first.
  RecordReader(std::string_view text, const std::string& path)
      : text_(text.substr(0, text.find('\0'))), path_(path) {}

  Result<std::vector<CallRecord>> Read() {
    while (!text_.empty()) {
      ++line_;
      const size_t end = text_.find('\n');
      const std::string_view line = text_.substr(0, end);
      // The file was cut while its last line was written: the record ends before it.
      const bool cut = end == std::string_view::npos && line_ > 1 && !Json::accept(line);
      if (cut) break;
      const auto read = ReadLine(line);
      if (!read.ok()) return read.error();
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    }
    if (line_ == 0) return NoRecord();
    std::vector<CallRecord> all;
    for (auto& [card, openings] : openings_) std::ranges::move(openings, std::back_inserter(all));
    if (!all.empty()) return all;
    return MakeError(1, "{0}: the host has opened no card", "{0}：主机程序没有打开任何卡", path_);
  }

 private:
  Error Damaged() const {
    return MakeError(1,
                     "{0}:{1}: this is no line of a record of host calls: the file was changed, "
                     "or cut while it was written",
                     "{0}:{1}：这不是主机调用记录的行：文件被改动，或在写入时被截断", path_, line_);
  }

  Error NoRecord() const {
    return MakeError(1, "{0}: this is no record of host calls: 'oncard exec --record' writes one",
                     "{0}：这不是主机调用记录：可用“oncard exec --record”生成", path_);
  }

  Result<void> ReadLine(std::string_view text) {
    const Json json = ReadJson(text);
    if (line_ == 1) return ReadHead(json);
    if (!json.is_object()) return Damaged();
    LineReader line(json);
    if (line.Has("open")) return ReadOpening(&line);
    if (line.Has("call")) return ReadCall(&line);
    return ReadEnd(&line);
  }

  Result<void> ReadHead(const Json& json) {
    if (!json.is_object()) return NoRecord();
    LineReader line(json);
    if (line.Text("oncard") != kTitle) return NoRecord();
    const int64_t format = line.Whole("format", 1, kWholeMax);
    if (!line.good()) return NoRecord();
    if (format == kFormat) return {};
    return MakeError(1, "{0}: this record has format {1}; this version reads {2}: record again",
                     "{0}：该记录的格式为 {1}；此版本只读格式 {2}：请重新记录", path_, format,
                     kFormat);
  }

  Result<void> ReadOpening(LineReader* line) {
    const auto card = static_cast<int>(line->Whole("open", 0, kCardMax));
    const bool bare = line->Flag("bare");
    const std::string scenario = line->Text("scenario");
    if (!line->good()) return Damaged();
    auto world = ParseScenario(scenario, path_, ScenarioUse::kText);
    if (!world.ok()) return world.error();
    // A host has met one case.
    if (const auto choices = Choices::Of(world.value());
        !choices.ok() || !choices.value().empty()) {
      return Damaged();
    }
    if (line->Has("eni") && !ReadMessage(line->At("eni"), &world.value().bus.eni_error)) {
      return Damaged();
    }
    if (line->Has("mram") && !ReadMemory(line, &world.value())) return Damaged();
    CallRecord opened;
    opened.card = card;
    opened.family = &FamilyOf(world.value());
    opened.bare = bare;
    opened.opening = static_cast<int>(openings_[card].size()) + 1;
    opened.scenario = std::move(world).value();
    openings_[card].push_back(std::move(opened));
    return {};
  }

  static bool ReadMemory(LineReader* line, Scenario* scenario) {
    const gtcalls::Family& family = FamilyOf(*scenario);
    gtcalls::FamilyState state = family.new_state();
    scenario->memory = line->Text("mram");
    return line->good() && family.restore_memory(scenario->memory, "", state).ok();
  }

  /// The opening of the card that a line belongs to; nullptr: the card is not open.
  CallRecord* Open(int64_t card) {
    auto& openings = openings_[static_cast<int>(card)];
    return openings.empty() || openings.back().end ? nullptr : &openings.back();
  }

  static int64_t LastUs(const CallRecord& record) {
    return record.calls.empty() ? 0 : record.calls.back().time_us;
  }

  Result<void> ReadCall(LineReader* line) {
    CallRecord* const record = Open(line->Whole("card", 0, kCardMax));
    if (record == nullptr) return Damaged();
    RecordedCall call;
    call.time_us = line->Whole("us", LastUs(*record), kWholeMax);
    call.code = static_cast<int16_t>(line->Whole("code", INT16_MIN, INT16_MAX));
    call.command = record->family->catalogue.Find(line->Text("call"));
    const Json& in = line->At("in");
    if (!line->good() || call.command == nullptr || !in.is_array()) return Damaged();
    const auto& parameters = call.command->parameters;
    if (in.size() != parameters.size()) return Damaged();
    call.arguments.resize(in.size());
    for (size_t i = 0; i < in.size(); ++i) {
      if (!ReadArgument(parameters[i], in[i], &call.arguments[i])) return Damaged();
    }
    call.acts = !line->Has("library");
    if (line->Has("library")) {
      if (!ReadMessage(line->At("library"), &call.reason)) return Damaged();
    }
    if (!ReadFiles(line, &call)) return Damaged();
    record->calls.push_back(std::move(call));
    return {};
  }

  /// A message in both languages.
  static bool ReadMessage(const Json& json, Message* message) {
    const bool good =
        json.is_array() && json.size() == 2 && json[0].is_string() && json[1].is_string();
    if (good) *message = {json[0].get<std::string>(), json[1].get<std::string>()};
    return good;
  }

  static bool ReadFiles(LineReader* line, RecordedCall* call) {
    if (line->Has("config")) call->config = line->Bytes("config");
    if (!line->Has("bin")) return line->good();
    call->program = {line->Bytes("bin"), line->Bytes("ini")};
    for (const Json& each : line->At("sources")) {
      if (!each.is_object()) return false;
      LineReader source(each);
      call->sources.push_back({source.Bytes("path"), source.Bytes("text")});
      if (!source.good()) return false;
    }
    return line->good();
  }

  Result<void> ReadEnd(LineReader* line) {
    CallRecord* const record = Open(line->Whole("close", 0, kCardMax));
    if (record == nullptr) return Damaged();
    CallRecord::End end;
    end.time_us = line->Whole("us", LastUs(*record), kWholeMax);
    const std::string hash = line->Text("hash");
    const char* const last = hash.data() + hash.size();
    const auto read = std::from_chars(hash.data(), last, end.hash, 16);
    if (!line->good() || read.ec != std::errc() || read.ptr != last) return Damaged();
    record->end = end;
    return {};
  }

  std::string_view text_;
  const std::string& path_;
  int64_t line_ = 0;
  std::map<int, std::vector<CallRecord>> openings_;
};

}  // namespace

// --- Writing -------------------------------------------------------------------------------------

RecordedCall RecordCall(const LoggedCall& call, bool acts) {
  RecordedCall recorded;
  recorded.time_us = call.time_us;
  recorded.command = &call.command;
  recorded.code = call.code;
  recorded.acts = acts;
  if (!acts) recorded.reason = call.reason;
  recorded.arguments.reserve(call.arguments.size());
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    const vm::CommandArgument& from = call.arguments[i];
    RecordedCall::Argument argument;
    argument.value = from.value;
    switch (call.command.parameters[i].passing) {
      case Passing::kValue:
        break;
      case Passing::kInput:
        argument.null = from.null && from.host == nullptr;
        argument.unread = from.null && !argument.null;
        argument.cells.assign(from.cells.begin(), from.cells.end());
        break;
      case Passing::kHostMemory: {
        argument.null = from.null && from.host == nullptr;
        argument.unread = from.cells.empty() && !argument.null;
        const size_t arrays = CellsPerElement(call.command.parameters[i]);
        const auto which = from.cells.first(std::min(arrays, from.cells.size()));
        argument.cells.assign(which.begin(), which.end());
        break;
      }
      case Passing::kText:
        argument.null = from.null;
        if (!from.null) argument.text = static_cast<const char*>(from.host);
        break;
      default:
        argument.null = from.host == nullptr;
    }
    recorded.arguments.push_back(std::move(argument));
  }
  return recorded;
}

std::string FormatRecordHead() { return Line({{"oncard", kTitle}, {"format", kFormat}}); }

std::string FormatRecordedOpening(int card, const Scenario& scenario, bool bare) {
  Scenario world;
  world.card = scenario.card;
  world.axis_count = scenario.axis_count;
  world.cycle_us = scenario.cycle_us;
  world.rate = scenario.rate;
  world.world = scenario.world;
  world.bus = scenario.bus;
  Json json = {{"open", card}, {"bare", bare}, {"scenario", FormatScenario(world)}};
  const Message& eni = scenario.bus.eni_error;
  if (!eni.en.empty()) json["eni"] = {eni.en, eni.zh};
  if (!scenario.memory.empty()) json["mram"] = scenario.memory;
  return Line(json);
}

// Only what few calls have becomes a document first.
void AppendRecordedCall(int card, const RecordedCall& call, std::string* text) {
  *text += R"({"card":)";
  AppendWhole(card, text);
  *text += R"(,"us":)";
  AppendWhole(call.time_us, text);
  *text += R"(,"call":")";
  *text += call.command->name;
  *text += R"(","in":)";
  const auto* parameter = call.command->parameters.data();
  AppendList(
      call.arguments,
      [&](const RecordedCall::Argument& argument) { AppendArgument(*parameter++, argument, text); },
      text);
  *text += R"(,"code":)";
  AppendWhole(call.code, text);
  if (!call.acts || call.config || call.program) {
    *text += ',';
    text->append(Line(RareMembers(call)), 1);
  } else {
    *text += "}\n";
  }
}

std::string FormatRecordedEnd(int card, const CallRecord::End& end) {
  return Line({{"close", card}, {"us", end.time_us}, {"hash", fmt::format("{:016x}", end.hash)}});
}

// --- Reading -------------------------------------------------------------------------------------

Result<std::vector<CallRecord>> ParseCallRecords(std::string_view text, const std::string& path) {
  return RecordReader(text, path).Read();
}

Result<CallRecord> ChooseCallRecord(std::vector<CallRecord> records, std::optional<int> card,
                                    int opening) {
  const int wanted = card.value_or(records.front().card);
  int openings = 0;
  for (CallRecord& record : records) {
    if (record.card != wanted) continue;
    if (record.opening == opening) return std::move(record);
    ++openings;
  }
  if (openings == 0) {
    return MakeError(1, "the host has not opened card {0}", "主机程序没有打开卡 {0}", wanted);
  }
  return MakeError(1, "the record of card {0} has openings 1 to {1}, not {2}",
                   "卡 {0} 的记录只有第 1 至 {1} 次打开，没有第 {2} 次", wanted, openings, opening);
}

}  // namespace oncard::runtime
