#include "explore/search/kept_search.h"

#include <utility>

namespace oncard::explore {
namespace {

/// Sets the options to the part of the search that is left.
void SetRest(const SearchFile& file, ExploreOptions* options) {
  if (file.engine == EngineKind::kDpor) {
    options->begun = &file.traces;
    return;
  }
  const auto [first, runs] = RunsOfPart(file.runs, {file.held.front(), file.parts});
  options->first_run = first + runs - file.runs_cut;
  options->runs = file.runs_cut;
}

void TakeOver(Exploration* found, SearchFile* file) {
  if (file->engine == EngineKind::kDpor) {
    file->traces = std::move(found->search);
  } else {
    file->runs_cut -= found->samples->runs;
    MergeInto(&file->samples, *found->samples);
  }
}

}  // namespace

Result<Exploration> GoOn(const Problem& problem, const ExploreOptions& options,
                         const SearchKeeper& keep, SearchFile* file) {
  ExploreOptions rest = WithOptionsOf(*file, options);
  for (;;) {
    SetRest(*file, &rest);
    const int64_t before = file->traces.executions;
    auto explored = Explore(problem, rest);
    if (!explored.ok()) return explored.error();
    Exploration& found = explored.value();
    TakeOver(&found, file);
    rest.execution_limit -= file->traces.executions - before;
    const bool paused = options.progress != nullptr && options.progress->TakePause();
    const bool goes_on = paused && !file->done() && rest.execution_limit > 0;
    if (!goes_on || !keep(*file)) {
      Exploration concluded = Conclude(problem, *file, std::move(found.failure));
      if (concluded.verdict == Verdict::kIncomplete) concluded.why = std::move(found.why);
      return concluded;
    }
    options.progress->estimates = false;
  }
}

}  // namespace oncard::explore
