#include "explore/search/search_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "base/number.h"
#include "explore/engines/shrink.h"

namespace oncard::explore {
namespace {

/// Units of a search of traces per part: with many, all parts take about the same time.
constexpr size_t kUnitsPerPart = 16;

}  // namespace

Result<SearchPart> ParsePart(std::string_view text) {
  SearchPart part;
  const size_t slash = text.find('/');
  if (slash != std::string_view::npos) {
    part.number = ReadWhole<int>(text.substr(0, slash)).value_or(0);
    part.count = ReadWhole<int>(text.substr(slash + 1)).value_or(0);
  }
  if (slash == std::string_view::npos || part.number < 1 || part.count > kPartMax ||
      part.number > part.count) {
    return MakeError(1, "'{0}' is not a part: expected I/N, the I-th of N parts, as in 1/4",
                     "“{0}”不是部分编号：应为 I/N，即 N 部分中的第 I 部分，如 1/4", text);
  }
  return part;
}

bool SearchFile::failed() const {
  if (units) return units->failing.has_value();
  return (engine == EngineKind::kDpor ? traces.bad : samples.bad) > 0;
}
bool SearchFile::done() const {
  if (units) return units->left.empty() || (units->failing && !units->all);
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
    text += fmt::format("\n{} {}", static_cast<int>(requirement.scope),
                        requirement.AsRequirement().Expression());
    if (requirement.scope == Scope::kAssert) text += " " + requirement.at;
  }
  if (problem.may_last) text += "\nmay last";
  return XXH64(text.data(), text.size(), 0);
}

TraceSearch TracesOfPart(const Problem& problem, const SearchPart& part) {
  TraceSearch search;
  if (part.count == 1) return search;
  search.units.clear();
  Model model = ModelOfTraces(problem);
  const auto count = static_cast<size_t>(part.count);
  const std::vector<TraceUnit> units = SplitTraces(&model, kUnitsPerPart * count);
  for (size_t i = static_cast<size_t>(part.number) - 1; i < units.size(); i += count) {
    search.units.push_back(units[i]);
  }
  return search;
}

std::pair<int64_t, int64_t> RunsOfPart(int64_t runs, const SearchPart& part) {
  return RunsOfShare(runs, part.number - 1, part.count);
}

void BeginRuns(const ExploreOptions& options, const SearchPart& part, SearchFile* file) {
  file->engine = options.engine;
  file->seed = options.seed;
  file->depth = options.depth;
  file->runs = options.runs;
  file->runs_cut = RunsOfPart(options.runs, part).second;
}

ExploreOptions WithOptionsOf(const SearchFile& file, ExploreOptions options) {
  options.engine = file.engine;
  options.seed = file.seed;
  options.depth = file.depth;
  return options;
}

Result<void> MergeInto(SearchFile* file, const SearchFile& other) {
  if (file->problem != other.problem) {
    return MakeError(1, "the files are of different programs or requirements",
                     "这些文件属于不同的程序或要求");
  }
  const auto kind = [](const SearchFile& each) {
    return std::tuple(each.engine, each.parts, each.seed, each.depth, each.runs);
  };
  const auto of_units = [](const SearchFile& each) {
    return each.units ? std::optional(each.units->Kind()) : std::nullopt;
  };
  if (kind(*file) != kind(other) || of_units(*file) != of_units(other)) {
    return MakeError(1,
                     "the files are of different searches: engine, parts, seed, depth, runs and "
                     "options must be the same",
                     "这些文件属于不同的搜索：引擎、部分数、种子、深度、次数和选项应相同");
  }
  if (file->runs_cut != 0 || other.runs_cut != 0) {
    return MakeError(1, "the random runs of a part are not complete: continue its file first",
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
  MergeInto(&file->remarks, other.remarks);
  if (file->units) {
    MergeInto(&*file->units, *other.units);
  } else if (file->engine == EngineKind::kDpor) {
    MergeInto(&file->traces, other.traces);
  } else {
    AddSamples(other.samples, other.failing_case, file);
  }
  return {};
}

void AddSamples(SampleCounts more, int64_t failing_case, SearchFile* file) {
  if (more.bad > 0 && (file->samples.bad == 0 || failing_case < file->failing_case)) {
    file->samples.failing.clear();
    file->failing_case = failing_case;
  } else if (failing_case > file->failing_case) {
    more.failing.clear();
  }
  MergeInto(&file->samples, more);
}

std::string MissingParts(const SearchFile& file) {
  std::string missing;
  for (int part = 1; part <= file.parts; ++part) {
    if (std::ranges::binary_search(file.held, part)) continue;
    missing += fmt::format("{}{}", missing.empty() ? "" : ", ", part);
  }
  return missing;
}

Message WhyNotProved(const SearchFile& file) {
  if (!file.done()) {
    return {"not all of its parts are complete: continue their files, then merge them again",
            "有的部分尚未完成：请先继续完成各文件，再重新合并"};
  }
  return MakeMessage("no failure in these of {0} parts: {1}; the others were not searched",
                     "共 {0} 部分，其中第 {1} 部分未出错；其余未搜索", file.parts,
                     fmt::format("{}", fmt::join(file.held, ", ")));
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
    exploration.ends = file.traces.ends.ends();
  }
  const std::vector<uint8_t>& failing = random ? file.samples.failing : file.traces.failing;
  if (random ? file.samples.bad > 0 : file.traces.bad > 0) {
    exploration.verdict = Verdict::kFailed;
    exploration.failure = known ? std::move(known) : ShrinkExecution(problem, failing);
  } else if (!file.done() || !file.whole()) {
    exploration.verdict = file.done() ? Verdict::kPassed : Verdict::kIncomplete;
    exploration.why = WhyNotProved(file);
  }
  return exploration;
}

}  // namespace oncard::explore
