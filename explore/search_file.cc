#include "explore/search_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "explore/shrink.h"

namespace oncard::explore {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kKind = "oncard search";
constexpr int kVersion = 1;
/// Units of a search of traces for each of its parts: with many, parts take about the same time.
constexpr size_t kUnitsPerPart = 16;

// --- Text ----------------------------------------------------------------------------------------

Json ToJson(const std::vector<PlannedStep>& plans) {
  Json json = Json::array();
  for (const PlannedStep& plan : plans) json.push_back({plan.thread, ToJson(plan.next)});
  return json;
}
std::vector<PlannedStep> PlansFrom(const Json& json) {
  std::vector<PlannedStep> plans;
  for (const Json& plan : json) {
    plans.push_back({plan.at(0).get<uint8_t>(), PlansFrom(plan.at(1))});
  }
  return plans;
}

Json ToJson(const TraceUnit& unit) {
  Json json = {{"prefix", unit.prefix}, {"sleep", unit.sleep}};
  for (const SavedFrame& frame : unit.frames) {
    json["frames"].push_back(
        {{"sleep", frame.sleep}, {"plans", ToJson(frame.plans)}, {"races", frame.races}});
  }
  return json;
}
TraceUnit UnitFrom(const Json& json) {
  TraceUnit unit = {json.at("prefix").get<std::vector<uint8_t>>(),
                    json.at("sleep").get<std::vector<uint8_t>>()};
  for (const Json& frame : json.value("frames", Json::array())) {
    unit.frames.push_back({frame.at("sleep").get<std::vector<uint8_t>>(),
                           PlansFrom(frame.at("plans")),
                           frame.at("races").get<std::vector<uint32_t>>()});
  }
  return unit;
}

Json ToJson(const std::vector<StateKey>& keys) {
  Json json = Json::array();
  for (const StateKey& key : keys) json.push_back(fmt::format("{:016x}{:016x}", key.low, key.high));
  return json;
}
uint64_t HexFrom(std::string_view digits) {
  uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value;
}
std::vector<StateKey> KeysFrom(const Json& json) {
  std::vector<StateKey> keys;
  for (const Json& key : json) {
    const auto digits = key.get<std::string>();
    keys.push_back({HexFrom(digits.substr(0, 16)), HexFrom(digits.substr(16))});
  }
  return keys;
}

Json ToJson(const TraceSearch& traces) {
  Json json = {{"units", Json::array()},
               {"executions", traces.executions},
               {"blocked", traces.blocked},
               {"redundant", traces.redundant},
               {"bad", traces.bad},
               {"too_deep", traces.too_deep},
               {"globals", ToJson(traces.globals)},
               {"full", ToJson(traces.full)},
               {"failing", traces.failing}};
  for (const TraceUnit& unit : traces.units) json["units"].push_back(ToJson(unit));
  return json;
}
TraceSearch TracesFrom(const Json& json) {
  TraceSearch traces;
  traces.units.clear();
  for (const Json& unit : json.at("units")) traces.units.push_back(UnitFrom(unit));
  traces.executions = json.at("executions");
  traces.blocked = json.at("blocked");
  traces.redundant = json.at("redundant");
  traces.bad = json.at("bad");
  traces.too_deep = json.at("too_deep");
  traces.globals = KeysFrom(json.at("globals"));
  traces.full = KeysFrom(json.at("full"));
  traces.failing = json.at("failing").get<std::vector<uint8_t>>();
  return traces;
}

Json SamplesToJson(const SearchFile& file) {
  return {{"seed", file.seed},
          {"depth", file.depth},
          {"runs_of_all", file.runs},
          {"runs_cut", file.runs_cut},
          {"runs", file.samples.runs},
          {"bad", file.samples.bad},
          {"cut", file.samples.cut},
          {"longest", file.samples.longest},
          {"ends", ToJson(file.samples.ends)},
          {"failing", file.samples.failing}};
}
void SamplesFrom(const Json& json, SearchFile* file) {
  file->seed = json.at("seed");
  file->depth = json.at("depth");
  file->runs = json.at("runs_of_all");
  file->runs_cut = json.at("runs_cut");
  file->samples.runs = json.at("runs");
  file->samples.bad = json.at("bad");
  file->samples.cut = json.at("cut");
  file->samples.longest = json.at("longest");
  file->samples.ends = KeysFrom(json.at("ends"));
  file->samples.failing = json.at("failing").get<std::vector<uint8_t>>();
}

/// Over everything before it: whoever edits a file by hand is told so.
std::string CheckOf(Json json) {
  json.erase("check");
  const std::string text = json.dump();
  return fmt::format("{:016x}", XXH64(text.data(), text.size(), 0));
}

// --- Putting together ----------------------------------------------------------------------------

/// What is said of a search that has found nothing wrong so far.
Message WhyNotProved(const SearchFile& file, bool done) {
  if (!done) {
    return {"not all of its parts are done: go on with their files, then merge them again",
            "有的部分尚未完成：请先继续完成各文件，再重新合并"};
  }
  std::string held;
  for (const int part : file.held) {
    held += fmt::format("{}{}", held.empty() ? "" : ", ", part);
  }
  return MakeMessage("nothing goes wrong in these of {0} parts: {1}; the others were not looked at",
                     "共 {0} 部分，其中第 {1} 部分未出错；其余未搜索", file.parts, held);
}

}  // namespace

Result<SearchPart> ParsePart(std::string_view text) {
  SearchPart part;
  const size_t slash = text.find('/');
  const auto number = [](std::string_view digits, int* value) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), *value);
    return error == std::errc{} && end == digits.data() + digits.size();
  };
  if (slash == std::string_view::npos || !number(text.substr(0, slash), &part.number) ||
      !number(text.substr(slash + 1), &part.count) || part.number < 1 || part.count > kPartMax ||
      part.number > part.count) {
    return MakeError(1, "'{0}' is no part: expected I/N, the I-th of N parts, as in 1/4",
                     "“{0}”不是部分编号：应为 I/N，即 N 部分中的第 I 部分，如 1/4", text);
  }
  return part;
}

bool SearchFile::done() const {
  return engine == EngineKind::kDpor ? traces.complete() : runs_cut == 0;
}
bool SearchFile::whole() const { return held.size() == static_cast<size_t>(parts); }

uint64_t HashOf(const Problem& problem) {
  std::string text =
      fmt::format("{:x} {}", problem.model.shared_image()->hash, static_cast<int>(problem.races));
  Model model = problem.model;
  model.TrackKey(true);
  text += fmt::format(" {:x} {:x}", model.key().low, model.key().high);
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    const ThreadSetup& setup = model.setup(thread);
    text += fmt::format(" {}:{}@{}", setup.thread, setup.function, setup.page);
  }
  for (const bool cell : problem.sync) text += cell ? 's' : '-';
  for (const BoundRequirement& requirement : problem.requirements) {
    text +=
        fmt::format("\n{} {}", static_cast<int>(requirement.scope), requirement.property.text());
  }
  return XXH64(text.data(), text.size(), 0);
}

TraceSearch TracesOfPart(const Problem& problem, const SearchPart& part) {
  TraceSearch search;
  if (part.count == 1) return search;
  search.units.clear();
  Model model = problem.model;
  const auto count = static_cast<size_t>(part.count);
  const std::vector<TraceUnit> units = SplitTraces(&model, kUnitsPerPart * count);
  for (size_t i = static_cast<size_t>(part.number) - 1; i < units.size(); i += count) {
    search.units.push_back(units[i]);
  }
  return search;
}

std::pair<int64_t, int64_t> RunsOfPart(int64_t runs, const SearchPart& part) {
  const int64_t each = runs / part.count;
  const int64_t more = runs % part.count;  // the first parts have one more
  const int64_t before = part.number - 1;
  return {each * before + std::min(before, more), each + (before < more ? 1 : 0)};
}

std::string FormatSearchFile(const SearchFile& file) {
  Json json = {{"kind", kKind},       {"version", kVersion},
               {"input", file.input}, {"problem", fmt::format("{:016x}", file.problem)},
               {"races", file.races}, {"engine", EngineName(file.engine)},
               {"parts", file.parts}, {"held", file.held}};
  if (file.engine == EngineKind::kDpor) {
    json["traces"] = ToJson(file.traces);
  } else {
    json["samples"] = SamplesToJson(file);
  }
  json["check"] = CheckOf(json);
  return json.dump(1) + '\n';
}

Result<SearchFile> ParseSearchFile(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("kind", Json()) != kKind) {
    return MakeError(1,
                     "this is no file of a search: expected one that 'oncard explore' has written",
                     "这不是搜索文件：应为“oncard explore”写出的文件");
  }
  if (json.value("version", Json()) != kVersion) {
    return MakeError(1, "the file is of another version: expected {0}", "文件版本不符：应为 {0}",
                     kVersion);
  }
  if (json.value("check", Json()) != CheckOf(json)) {
    return MakeError(1, "the file is not as it was written: explore anew",
                     "文件已被改动：请重新探索");
  }
  SearchFile file;
  file.input = json.at("input");
  file.problem = HexFrom(json.at("problem").get<std::string>());
  file.races = json.at("races");
  file.engine = EngineNamed(json.at("engine").get<std::string>()).value_or(EngineKind::kDpor);
  file.parts = json.at("parts");
  file.held = json.at("held").get<std::vector<int>>();
  if (file.engine == EngineKind::kDpor) {
    file.traces = TracesFrom(json.at("traces"));
  } else {
    SamplesFrom(json.at("samples"), &file);
  }
  return file;
}

Result<void> MergeInto(SearchFile* file, const SearchFile& other) {
  if (file->problem != other.problem) {
    return MakeError(1, "the files are of different programs or requirements",
                     "这些文件属于不同的程序或要求");
  }
  const auto kind = [](const SearchFile& each) {
    return std::tuple(each.engine, each.parts, each.seed, each.depth, each.runs);
  };
  if (kind(*file) != kind(other)) {
    return MakeError(1,
                     "the files are of different searches: engine, parts, seed, depth and runs "
                     "must be the same",
                     "这些文件属于不同的搜索：引擎、部分数、种子、深度和次数应相同");
  }
  if (file->runs_cut != 0 || other.runs_cut != 0) {
    return MakeError(1, "the random runs of a part are not all done: go on with its file first",
                     "有一部分的随机运行尚未完成：请先继续该文件");
  }
  std::vector<int> both;
  std::ranges::set_intersection(file->held, other.held, std::back_inserter(both));
  if (!both.empty()) {
    return MakeError(1, "part {0} is in two of the files", "第 {0} 部分出现在两个文件中",
                     both.front());
  }
  file->held.insert(file->held.end(), other.held.begin(), other.held.end());
  std::ranges::sort(file->held);
  MergeInto(&file->traces, other.traces);
  MergeInto(&file->samples, other.samples);
  return {};
}

Exploration Conclude(const Problem& problem, const SearchFile& file, std::optional<Failure> known) {
  const bool random = file.engine != EngineKind::kDpor;
  Exploration exploration;
  exploration.engine = file.engine;
  if (random) {
    exploration = ConcludeSamples(file.engine, file.samples);
  } else {
    exploration.traces = file.traces.Counts();
    exploration.traces->complete = file.done() && file.whole();
    exploration.verdict = Verdict::kProved;
  }
  const std::vector<uint8_t>& failing = random ? file.samples.failing : file.traces.failing;
  if (random ? file.samples.bad > 0 : file.traces.bad > 0) {
    exploration.verdict = Verdict::kFailed;
    exploration.failure = known ? std::move(known) : Shrink(problem, failing);
  } else if (!file.done() || !file.whole()) {
    exploration.verdict = file.done() ? Verdict::kPassed : Verdict::kIncomplete;
    exploration.why = WhyNotProved(file, file.done());
  }
  return exploration;
}

}  // namespace oncard::explore
