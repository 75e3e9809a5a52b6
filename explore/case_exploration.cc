#include "explore/case_exploration.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "explore/models/card_steps.h"
#include "explore/search/case_counts.h"

namespace oncard::explore {
namespace {

class CaseExploration {
 public:
  CaseExploration(const runtime::Choices& choices, const ExploreOptions& options)
      : choices_(choices), options_(options), cases_(choices.cases()) {
    search_.choices = choices.Describe();
    search_.cases = cases_;
    covered_.resize(static_cast<size_t>(cases_));
  }

  Result<Findings> Explore(const runtime::Scenario& scenario, const CaseExplorer& explore) {
    if (auto enough = CheckRuns(options_, cases_); !enough.ok()) return enough.error();
    ShowProgress();
    for (; search_.searched < cases_ && GoesOn(); ++search_.searched) {
      if (options_.progress != nullptr) options_.progress->cases_done = search_.searched;
      auto chosen =
          std::make_shared<const runtime::Scenario>(choices_.CaseOf(scenario, search_.searched));
      auto next = explore(*chosen, OptionsOfCase());
      if (!next.ok()) return next;
      Join(std::move(next).value(), std::move(chosen));
    }
    Conclude();
    return std::move(*all_);
  }

 private:
  /// An estimate of one case says nothing of the whole.
  void ShowProgress() {
    if (options_.progress == nullptr) return;
    options_.progress->estimates = false;
    options_.progress->cases = cases_;
  }

  bool GoesOn() const {
    if (!all_) return true;
    const Exploration& exploration = all_->exploration;
    if (exploration.failure && !options_.all) return false;
    if (options_.progress != nullptr && IsTold(&options_.progress->stop)) return false;
    return ExecutionsUsed(exploration) < options_.execution_limit &&
           StatesUsed(exploration) < int64_t{options_.state_limit};
  }

  /// What is left of the limits, and the share of a case in the random runs.
  ExploreOptions OptionsOfCase() const {
    ExploreOptions options = options_;
    options.cases = cases_;
    options.known_steps = known_steps_;
    if (all_) {
      options.states_before = StatesUsed(all_->exploration);
      options.state_limit -= static_cast<uint32_t>(options.states_before);
      // A limit that is not below its default lets traces be counted without executing each.
      if (options.execution_limit < ExploreOptions{}.execution_limit) {
        options.execution_limit -= ExecutionsUsed(all_->exploration);
      }
    }
    if (IsRandom(options.engine)) {
      const auto [first, runs] = RunsOfShare(options.runs, search_.searched, cases_);
      options.first_run += first;
      options.runs = runs;
    }
    return options;
  }

  void Join(Findings next, std::shared_ptr<const runtime::Scenario> chosen) {
    untested_.Add(next.untested);
    covered_[static_cast<size_t>(search_.searched)] =
        next.exploration.verdict != Verdict::kIncomplete;
    const bool stops = !stopped_ && next.exploration.verdict == Verdict::kIncomplete;
    WayOut way;
    std::optional<Reached> reached;
    if (stops) {
      stopped_ = true;
      way = NameCase(choices_.DescribeCase(search_.searched), next.way_out);
      reached = next.exploration.reached;
    }
    const bool fails = next.exploration.failure.has_value();
    auto other = std::make_unique<Findings>(std::move(next));
    // What is shown is the case of the failure, otherwise the first one.
    const bool is_shown = all_ == nullptr || (fails && search_.scenario == nullptr);
    if (is_shown) all_.swap(other);
    if (fails && is_shown) {
      search_.failing = choices_.DescribeCase(search_.searched);
      search_.scenario = std::move(chosen);
    }
    if (stops) {
      all_->way_out = std::move(way);
      all_->exploration.reached = std::move(reached);
    }
    if (other == nullptr) return;
    AddCase(std::move(other->exploration), &all_->exploration);
    JoinFound(std::move(other->refused), &all_->refused);
    JoinFound(std::move(other->card), &all_->card);
  }

  /// The verdict of all cases, and why it is no proof.
  void Conclude() {
    Exploration& exploration = all_->exploration;
    if (!exploration.failure && search_.searched < cases_) {
      exploration.verdict = Verdict::kIncomplete;
    }
    if (exploration.verdict == Verdict::kIncomplete) {
      const Message why = WhyIncomplete(options_, DescribeLimits(options_));
      exploration.why =
          MakeMessage("{0}; {1} of {2} cases were begun", "{3}；共 {2} 种情形，已开始 {1} 种",
                      why.en, search_.searched, cases_, why.zh);
    } else if (exploration.verdict == Verdict::kPassed) {
      exploration.why = {};
      if (exploration.bounded) exploration.why = DescribeBound(*exploration.bounded);
      if (exploration.samples) exploration.why = DescribeSamples(*exploration.samples);
      BoundByHorizon(Horizon(exploration.horizon), &exploration);
    }
    all_->knows_untested = IsGood(exploration.verdict);
    all_->untested = all_->knows_untested ? untested_.Texts() : std::vector<Message>();
    search_.covered = choices_.Covered(covered_);
    all_->cases = std::move(search_);
  }

  const runtime::Choices& choices_;
  const ExploreOptions& options_;
  const int64_t cases_;
  CaseSearch search_;
  std::unique_ptr<Findings> all_;  ///< of the cases so far
  UntestedInAll untested_;
  std::shared_ptr<KnownSteps> known_steps_ = std::make_shared<KnownSteps>();
  std::vector<bool> covered_;  ///< for each case: it was searched to its end
  bool stopped_ = false;       ///< a case is incomplete
};

}  // namespace

WayOut NameCase(const Message& chosen, WayOut way) {
  way.reached.insert(way.reached.begin(),
                     MakeMessage("in the case {0}:", "在情形 {1} 中：", chosen.en, chosen.zh));
  return way;
}

Result<void> CheckRuns(const ExploreOptions& options, int64_t cases) {
  if (!IsRandom(options.engine) || options.runs >= cases) return {};
  return MakeError(1,
                   "{0} random runs are not enough for {1} cases of the choices: ask for at "
                   "least one run for each",
                   "{0} 次随机运行不足以覆盖 {1} 种情形：每种情形至少需要一次", options.runs,
                   cases);
}

Result<Findings> ExploreCases(const runtime::Scenario& scenario, const runtime::Choices& choices,
                              const ExploreOptions& options, const CaseExplorer& explore) {
  return CaseExploration(choices, options).Explore(scenario, explore);
}

}  // namespace oncard::explore
