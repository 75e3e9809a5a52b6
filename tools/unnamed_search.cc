#include "tools/unnamed_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/files.h"
#include "base/path_bytes.h"
#include "explore/kept_exploration.h"
#include "tools/explore_search.h"

namespace oncard::tools {
namespace {

/// A name from that of the input which no file has yet.
std::string FreeName(const std::string& input) {
  const std::string name = FileNameOf(PathOf(input).stem());
  std::string path = name + ".search";
  for (int i = 2; FileExists(path); ++i) {
    path = fmt::format("{}.{}.search", name, i);
  }
  return path;
}

/// True if only ends are asked about, which is what a search of traces can answer.
bool AsksOnlyForEnds(const ExploreSubject& subject) {
  return subject.scenario.races == runtime::Scenario{}.races &&
         std::ranges::all_of(subject.requirements, [](const auto& requirement) {
           return requirement.scope == runtime::Scope::kFinal;
         });
}

}  // namespace

UnnamedSearch::UnnamedSearch(const Invocation& invocation, const std::string& input,
                             const ExploreSubject& subject, const explore::ExploreOptions& options)
    : invocation_(invocation), path_(FreeName(input)) {
  const auto by_cases =
      explore::IsKeptByCases({subject.scenario, subject.requirements, subject.object});
  if (!by_cases.ok() || by_cases.value()) {
    why_not_ = by_cases.ok() ? MakeMessage(
                                   "with a card, or with choices, only a search that is begun with "
                                   "--search or --shard is saved: oncard explore {0} --search {1}",
                                   "带控制卡或有选择时，只保存以 --search 或 --shard 开始的搜索："
                                   "oncard explore {0} --search {1}",
                                   input, path_)
                             : by_cases.error().message;
    return;
  }
  auto begun = BeginSearch(subject, input, path_, {}, options);
  if (!begun.ok()) {
    why_not_ = begun.error().message;
  } else if (begun.value().engine == explore::EngineKind::kDpor) {
    file_ = std::move(begun).value();
    searches_traces_ = options.engine == explore::EngineKind::kDpor || AsksOnlyForEnds(subject);
  }
}

int UnnamedSearch::Keep(const explore::TraceSearch& search) {
  if (!file_ || search.too_deep) return kExitOk;
  file_->traces = search;
  const int written = WriteOutput(invocation_, path_, explore::FormatSearchFile(*file_));
  if (written == kExitOk && !std::exchange(kept_, true)) {
    PrintDiagnostics(
        invocation_.Say(MakeMessage("the search is saved in {0}; to continue: oncard explore {0}\n",
                                    "搜索已保存到 {0}；继续：oncard explore {0}\n", path_)));
  }
  return written;
}

int UnnamedSearch::End(const explore::Exploration& found, bool interrupted) {
  const bool incomplete = found.verdict == explore::Verdict::kIncomplete;
  const bool left =
      found.traces && !found.traces->complete && found.verdict != explore::Verdict::kProved;
  if (file_ && left && (interrupted || (incomplete && kept_))) return Keep(found.search);
  if (interrupted && incomplete && why_not_) {
    const Message text = MakeMessage("oncard: the search could not be saved: {0}\n",
                                     "oncard: 搜索未保存：{1}\n", why_not_->en, why_not_->zh);
    PrintDiagnostics(invocation_.Say(text));
  }
  if (kept_) std::remove(path_.c_str());
  return kExitOk;
}

}  // namespace oncard::tools
