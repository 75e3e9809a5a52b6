#include "explore/search/search_check.h"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "explore/engines/waiting_loop.h"
#include "explore/engines/walk.h"

namespace oncard::explore {
namespace {

bool CanStep(uint32_t runnable, int thread) {
  return thread < kThreadMax && (runnable >> thread & 1) != 0;
}

Error NoSuchStep(const std::string& place, int thread) {
  return MakeError(1, "{0}: thread {1} of the search cannot execute a step there; explore again",
                   "{0}：搜索中的线程 {1} 在此处无法执行；请重新探索", place, thread);
}

/// Executes a unit as the search does (dpor.cc): a step is a statement that accesses shared cells
/// and the following statements of its thread that do not.
class UnitCheck {
 public:
  UnitCheck(const Problem& problem, int64_t depth)
      : model_(ModelOfTraces(problem)), depth_(depth) {}

  Result<void> Run(const TraceUnit& unit, const std::string& place) {
    model_.TrackKey(false);
    for (int thread = 0; thread < model_.thread_count(); ++thread) RunPrivate(thread);
    for (size_t i = 0; i < unit.prefix.size(); ++i) {
      const std::string here = fmt::format("{}.prefix[{}]", place, i);
      if (auto taken = Take(unit.prefix[i], here); !taken.ok()) return taken;
    }
    if (auto sleep = CheckSleep(unit.sleep, place); !sleep.ok()) return sleep;
    for (size_t i = 0; i < unit.frames.size(); ++i) {
      const std::string here = fmt::format("{}.frames[{}]", place, i);
      if (auto frame = CheckFrame(unit.frames[i], unit.prefix.size() + i, here); !frame.ok()) {
        return frame;
      }
    }
    return {};
  }

 private:
  void RunPrivate(int thread) { model_.StepPrivate(thread, depth_ - model_.depth()); }

  Result<void> Take(int thread, const std::string& place) {
    if (!CanStep(model_.runnable(), thread)) return NoSuchStep(place, thread);
    if (model_.depth() >= depth_) {
      return MakeError(1, "{0}: the run is longer than {1} statements there; explore again",
                       "{0}：此处运行已超过 {1} 条语句；请重新探索", place, depth_);
    }
    model_.Step(thread);
    RunPrivate(thread);
    return {};
  }

  Result<void> CheckSleep(const std::vector<uint8_t>& sleep, const std::string& place) const {
    for (const uint8_t thread : sleep) {
      if (!CanStep(model_.runnable(), thread)) return NoSuchStep(place + ".sleep", thread);
    }
    return {};
  }

  /// Checks the data of the state before the step with this number.
  Result<void> CheckFrame(const SavedFrame& frame, size_t number, const std::string& place) {
    if (auto sleep = CheckSleep(frame.sleep, place); !sleep.ok()) return sleep;
    if (auto plans = CheckPlans(frame.plans, place + ".plans"); !plans.ok()) return plans;
    for (const uint32_t race : frame.races) {
      if (race < number) continue;
      return MakeError(1,
                       "{0}.races: {1} is not an earlier step, those are 0 to {2}; explore again",
                       "{0}.races：{1} 不是之前的步，之前的步为 0 至 {2}；请重新探索", place, race,
                       static_cast<int64_t>(number) - 1);
    }
    return Take(frame.plans.front().thread, place + ".plans");
  }

  Result<void> CheckPlans(const std::vector<PlannedStep>& plans, const std::string& place) {
    const Error broken = MakeError(1, "{0}: this is not a list of plans; explore again",
                                   "{0}：这不是计划列表；请重新探索", place);
    if (plans.empty()) return broken;
    /// Plans after a common step: how many are still to come, and the depth before that step.
    struct Level {
      size_t left = 0;
      int64_t depth = 0;
    };
    std::vector<Level> levels;
    const auto close = [&] {
      for (; !levels.empty() && levels.back().left == 0; levels.pop_back()) {
        while (model_.depth() > levels.back().depth) model_.Undo();
      }
    };
    for (const PlannedStep& planned : plans) {
      close();
      if (!levels.empty()) --levels.back().left;
      if (!CanStep(model_.runnable(), planned.thread)) return NoSuchStep(place, planned.thread);
      if (planned.next == 0) continue;
      levels.push_back({planned.next, model_.depth()});
      if (auto taken = Take(planned.thread, place); !taken.ok()) return taken;
    }
    close();
    if (!levels.empty()) return broken;
    return {};
  }

  Model model_;
  int64_t depth_;
};

Error DoesNotFail() {
  return MakeError(1, "failing: this run does not fail; explore again",
                   "failing：该运行没有出错；请重新探索");
}

/// Checks the run with which the search is recorded as failed.
Result<void> CheckFailing(const Problem& problem, const std::vector<uint8_t>& failing,
                          bool says_bad) {
  if (failing.empty() && !says_bad) return {};
  ProgramWalk walk(problem);
  for (size_t i = 0; i < failing.size() && !walk.fault(); ++i) {
    if (!CanStep(walk.choices(), failing[i])) {
      return NoSuchStep(fmt::format("failing[{}]", i), failing[i]);
    }
    walk.Step(failing[i]);
  }
  const bool fails = walk.fault() || (!problem.may_last && !EndlessWait(walk.model()).empty());
  if (fails && says_bad) return {};
  return DoesNotFail();
}

}  // namespace

Result<void> CheckEnds(size_t values, const std::vector<End>& ends) {
  for (size_t i = 0; i < ends.size(); ++i) {
    const size_t found = ends[i].size();
    if (found == values) continue;
    return MakeError(1, "results[{0}]: {1} values, the program has {2}; explore again",
                     "results[{0}]：有 {1} 个值，而程序有 {2} 个；请重新探索", i, found, values);
  }
  return {};
}

Result<void> CheckSearch(const Problem& problem, const SearchFile& file, int64_t depth) {
  if (file.units) {
    return MakeError(1, "units: this search has none; explore again",
                     "units：该搜索没有单元；请重新探索");
  }
  for (size_t i = 0; i < file.traces.units.size(); ++i) {
    UnitCheck check(problem, depth);
    auto unit = check.Run(file.traces.units[i], fmt::format("units[{}]", i));
    if (!unit.ok()) return unit;
  }
  const bool random = file.engine != EngineKind::kDpor;
  const EndSet& ends = random ? file.samples.values : file.traces.ends;
  if (auto checked = CheckEnds(EndOf(problem.model).size(), ends.ends()); !checked.ok()) {
    return checked;
  }
  return CheckFailing(problem, random ? file.samples.failing : file.traces.failing,
                      (random ? file.samples.bad : file.traces.bad) > 0);
}

Result<void> CheckSamples(CardModel* model, const SampleCounts& samples) {
  const size_t values = EndOf(*model, model->Start()).size();
  if (auto checked = CheckEnds(values, samples.values.ends()); !checked.ok()) return checked;
  if (samples.failing.empty() && samples.bad == 0) return {};
  CardWalk walk(model, false);
  for (size_t i = 0; i < samples.failing.size() && !walk.fault(); ++i) {
    if (!CanStep(walk.choices(), samples.failing[i])) {
      return NoSuchStep(fmt::format("failing[{}]", i), samples.failing[i]);
    }
    walk.Step(samples.failing[i]);
  }
  if (walk.fault() && samples.bad > 0) return {};
  return DoesNotFail();
}

}  // namespace oncard::explore
