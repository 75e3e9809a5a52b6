// Search files as text: JSON, docs/search-format.md. The reader checks the type and range of every
// value. It does not check indices into the program; search_check.h does this with the program.
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "explore/search/search_file.h"
#include "explore/search/search_json.h"

namespace oncard::explore {
namespace {

using Json = SearchJson;

constexpr std::string_view kKind = "oncard search";
constexpr int kVersion = 7;

/// Maximum nesting of objects and lists in a search file.
constexpr int kNestingMax = 16;

// --- Writing -------------------------------------------------------------------------------------

void PutUnit(const TraceUnit& unit, SearchWriter* writer) {
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

void PutTraces(const TraceSearch& traces, SearchWriter* writer) {
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

void PutSamples(const SearchFile& file, SearchWriter* writer) {
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
  writer->Put("failing_case", file.failing_case);
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

std::vector<PlannedStep> PlansFrom(SearchReader& reader, const SearchValue& list) {
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

TraceUnit UnitFrom(SearchReader& reader, const SearchValue& value) {
  TraceUnit unit = {reader.Threads(reader.Member(value, "prefix")),
                    reader.Threads(reader.Member(value, "sleep"))};
  const SearchValue frames = reader.Member(value, "frames");
  if (frames.json().is_null()) return unit;  // the unit has not begun
  reader.Each(frames, [&](const SearchValue& frame) {
    unit.frames.push_back({reader.Threads(reader.Member(frame, "sleep")),
                           PlansFrom(reader, reader.Member(frame, "plans")),
                           reader.Wholes<uint32_t>(reader.Member(frame, "races"), 0,
                                                   std::numeric_limits<uint32_t>::max())});
  });
  return unit;
}

TraceSearch TracesFrom(SearchReader& reader, const SearchValue& value) {
  TraceSearch traces;
  traces.units.clear();
  reader.Each(reader.Member(value, "units"),
              [&](const SearchValue& unit) { traces.units.push_back(UnitFrom(reader, unit)); });
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

void SamplesFrom(SearchReader& reader, const SearchValue& value, SearchFile* file) {
  file->seed =
      reader.Whole<uint64_t>(reader.Member(value, "seed"), 0, std::numeric_limits<uint64_t>::max());
  file->depth = reader.Whole<int>(reader.Member(value, "depth"), 1, kPctDepthMax);
  file->runs = reader.Count(reader.Member(value, "runs_of_all"));
  const SearchValue runs_cut = reader.Member(value, "runs_cut");
  file->runs_cut = reader.Count(runs_cut);
  file->samples.seed = file->seed;
  file->samples.runs = reader.Count(reader.Member(value, "runs"));
  file->samples.bad = reader.Count(reader.Member(value, "bad"));
  file->samples.cut = reader.Count(reader.Member(value, "cut"));
  file->samples.longest = reader.Count(reader.Member(value, "longest"));
  file->samples.ends = reader.Keys(reader.Member(value, "ends"));
  file->samples.values = reader.Ends(reader.Member(value, "results"));
  file->samples.failing = reader.Threads(reader.Member(value, "failing"));
  file->failing_case = reader.Whole<int64_t>(reader.Member(value, "failing_case"), 0,
                                             runtime::Choices::kCasesMax - 1);
  if (reader.failed()) return;
  const int64_t left =
      file->held.size() > 1 ? 0 : RunsOfPart(file->runs, {file->held.front(), file->parts}).second;
  if (file->runs_cut > left) {
    reader.Fail(runs_cut, fmt::format("at most the {} runs of its part", left),
                fmt::format("不超过该部分的 {} 次运行", left));
  }
}

std::vector<int> HeldFrom(SearchReader& reader, const SearchValue& value, int parts) {
  std::vector<int> held = reader.Wholes<int>(value, 1, parts);
  const bool in_order = std::ranges::adjacent_find(held, std::greater_equal{}) == held.end();
  if (held.empty() || !in_order) {
    reader.Fail(value, "numbers of parts, in order", "按顺序排列的部分编号");
  }
  return held;
}

EngineKind EngineFrom(SearchReader& reader, const SearchValue& value, bool in_units) {
  const auto engine = EngineNamed(reader.Text(value)).value_or(EngineKind::kAuto);
  switch (engine) {
    case EngineKind::kDpor:
      return engine;
    case EngineKind::kRandom:
    case EngineKind::kPct:
    case EngineKind::kPos:
      if (!in_units) return engine;
      break;
    case EngineKind::kAuto:
    case EngineKind::kStateful:
    case EngineKind::kBounded:
      if (in_units) return engine;
      break;
    case EngineKind::kFollow:
      break;
  }
  if (in_units) {
    reader.Fail(value, "auto, dpor, stateful or bounded", "auto、dpor、stateful 或 bounded");
  } else {
    reader.Fail(value, "dpor, random, pct or pos", "dpor、random、pct 或 pos");
  }
  return EngineKind::kDpor;
}

}  // namespace

std::string FormatSearchFile(const SearchFile& file) {
  SearchWriter writer;
  writer.Open('{');
  writer.PutText("kind", kKind);
  writer.Put("version", kVersion);
  writer.PutText("input", file.input);
  writer.PutText("problem", fmt::format("{:016x}", file.problem));
  writer.PutText("races", file.races);
  writer.PutText("engine", EngineName(file.engine));
  writer.Put("parts", file.parts);
  writer.PutList("held", file.held);
  if (file.units) {
    PutUnits(*file.units, &writer);
  } else {
    const bool traced = file.engine == EngineKind::kDpor;
    writer.Next(traced ? "traces" : "samples");
    writer.Open('{');
    if (traced) {
      PutTraces(file.traces, &writer);
    } else {
      PutSamples(file, &writer);
    }
    writer.Close('}');
  }
  if (!file.remarks.empty()) PutRemarks(file.remarks, &writer);
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
  SearchReader reader;
  const SearchValue root(json, nullptr, "");
  SearchFile file;
  file.input = reader.Text(reader.Member(root, "input"));
  file.problem = reader.Key(reader.Member(root, "problem"));
  const SearchValue races = reader.Member(root, "races");
  file.races = reader.Text(races);
  if (!RaceRuleNamed(file.races)) reader.Fail(races, "any, benign or none", "any、benign 或 none");
  const SearchValue units = reader.Member(root, "units");
  const bool in_units = !units.json().is_null();
  file.engine = EngineFrom(reader, reader.Member(root, "engine"), in_units);
  file.parts = reader.Whole<int>(reader.Member(root, "parts"), 1, kPartMax);
  file.held = HeldFrom(reader, reader.Member(root, "held"), file.parts);
  if (reader.failed()) return reader.error();
  if (in_units) {
    file.units = UnitsFrom(reader, units, file.held, file.parts);
  } else if (file.engine == EngineKind::kDpor) {
    file.traces = TracesFrom(reader, reader.Member(root, "traces"));
  } else {
    SamplesFrom(reader, reader.Member(root, "samples"), &file);
  }
  const SearchValue remarks = reader.Member(root, "remarks");
  if (!remarks.json().is_null()) file.remarks = RemarksFrom(reader, remarks);
  if (reader.failed()) return reader.error();
  return file;
}

}  // namespace oncard::explore
