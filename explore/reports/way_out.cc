#include "explore/reports/way_out.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "explore/engines/walk.h"
#include "explore/models/card_rows.h"
#include "explore/search/case_counts.h"

namespace oncard::explore {
namespace {

/// Statements of the run in which threads take turns, and how often a loop must be repeated in it
/// to be named. At most so many loops are named.
constexpr int kLookedAt = 20'000;
constexpr int kRepeated = 10;
constexpr size_t kLoopsNamed = 3;

/// Into so many parts a search is divided by the command line that is offered.
constexpr int kPartsOffered = 8;

/// Where the threads of a run are: of each its position in its function.
class Loops {
 public:
  /// A thread went from one position to another in that cycle.
  void Step(int thread, int from, int to, int64_t cycle) {
    if (to > from) return;
    Loop& loop = loops_[{thread, to}];
    // A loop that waits comes round once in a cycle at most.
    loop.count += loop.cycle == cycle ? 1 : 0;
    loop.cycle = cycle;
  }

  /// `describe(thread, position)` of those that are repeated most.
  template <typename Describe>
  std::vector<Message> Named(const Describe& describe) const {
    std::vector<std::pair<int64_t, std::pair<int, int>>> often;
    for (const auto& [place, loop] : loops_) {
      if (loop.count >= kRepeated) often.push_back({-loop.count, place});
    }
    std::ranges::sort(often);
    if (often.size() > kLoopsNamed) often.resize(kLoopsNamed);
    std::vector<Message> named;
    named.reserve(often.size());
    for (const auto& each : often) named.push_back(describe(each.second.first, each.second.second));
    return named;
  }

 private:
  struct Loop {
    int64_t count = 0;
    int64_t cycle = -1;
  };
  std::map<std::pair<int, int>, Loop> loops_;  ///< by thread and position of the beginning
};

/// The thread after `last` that can run.
int NextInTurn(uint32_t choices, int last) {
  const uint32_t later = last < 0 ? choices : choices & ~((uint32_t{2} << last) - 1);
  return std::countr_zero(later != 0 ? later : choices);
}

std::string PlaceOf(const Subject& subject, int thread, int position) {
  const auto function = static_cast<size_t>(subject.threads[static_cast<size_t>(thread)].function);
  const auto& lines = subject.image->object.functions[function].lines;
  const auto at = static_cast<size_t>(position);
  return fmt::format("{}:{}", subject.program, at < lines.size() ? lines[at] : 0);
}

int NumberOf(const Subject& subject, int thread) {
  return subject.threads[static_cast<size_t>(thread)].thread;
}

void AddHeld(const std::vector<std::string>& held, std::vector<Message>* reached) {
  std::string all;
  for (const std::string& each : held) all += (all.empty() ? "" : "; ") + each;
  if (!all.empty()) reached->push_back({"held so far: " + all, "至此成立：" + all});
}

/// The command lines that are worth a try: all but the one that was used.
std::vector<Message> NextOf(const Subject& subject, const Exploration& exploration,
                            const ExploreOptions& options, bool merges) {
  std::vector<Message> next;
  const std::string& file = !subject.record.empty()     ? subject.record
                            : !subject.scenario.empty() ? subject.scenario
                                                        : subject.program;
  const auto add = [&](const std::string& words) {
    const std::string line = fmt::format("oncard explore {} {}", file, words);
    next.push_back({line, line});
  };
  // What is kept in a file goes on there.
  const bool limited = StatesUsed(exploration) >= int64_t{options.state_limit};
  const std::string more =
      fmt::format("--max-states={}", (options.states_before + int64_t{options.state_limit}) * 4);
  if (!options.kept.empty()) {
    const std::string line =
        fmt::format("oncard explore {}{}{}", options.kept, limited ? " " : "", limited ? more : "");
    next.push_back({line, line});
  }
  const bool of_states =
      options.engine == EngineKind::kAuto || options.engine == EngineKind::kStateful;
  if (merges && options.merge_private == false) add("--engine=stateful --merge-private");
  if (of_states && limited && options.kept.empty()) add(more);
  const bool by_cases = options.cases >= kPartsOffered;
  if (of_states && options.kept.empty() && subject.record.empty() && (subject.card || by_cases)) {
    const std::string parts = fmt::format("oncard explore {} {}--shard 1/{}", file,
                                          by_cases ? "" : "--engine=stateful ", kPartsOffered);
    next.push_back(MakeMessage("{0} and so on up to {1}/{1}, then --merge",
                               "{0} 直至 {1}/{1}，再 --merge", parts, kPartsOffered));
  }
  if (options.engine != EngineKind::kBounded) {
    add("--engine=bounded");
  } else if (options.preemption_limit > 0) {
    add(fmt::format("--engine=bounded --preemptions={}", options.preemption_limit - 1));
  }
  add("--engine=pos --runs=100000");
  return next;
}

/// Why every statement is executed in each state.
Message WhyEachStep(const CardModel& model) {
  const auto why = CardRows::WhyNot(model).value_or(
      Message{"a thread starts again and again, or a command changes what is not known of it",
              "有线程周期启动，或有指令改变了未知的内容"});
  return MakeMessage("each step is executed on the card, which is slow: {0}",
                     "每一步都在控制卡上执行，因此较慢：{1}", why.en, why.zh);
}

}  // namespace

WayOut WayOutOf(const Subject& subject, const Exploration& exploration,
                const ExploreOptions& options, const Problem& problem) {
  WayOut way;
  // What two engines have seen by the time that one gives up depends on the clock.
  if (!exploration.paired) {
    std::vector<std::string> held;
    for (const BoundRequirement& bound : problem.requirements) {
      const bool of_states = bound.scope == Scope::kAlways || bound.scope == Scope::kNever;
      if (!of_states || (bound.mattered && !bound.mattered->load())) continue;
      held.push_back(bound.AsRequirement().Title());
    }
    AddHeld(held, &way.reached);
    for (Message& untested : UntestedOf(problem)) way.reached.push_back(std::move(untested));
  }
  Loops loops;
  Model model = problem.model;
  for (int i = 0, thread = -1; i < kLookedAt && model.runnable() != 0; ++i) {
    thread = NextInTurn(model.runnable(), thread);
    const int from = model.Position(thread);
    model.Step(thread);
    if (model.Running(thread)) loops.Step(thread, from, model.Position(thread), 0);
  }
  way.spent = loops.Named([&](int thread, int position) {
    return MakeMessage("thread {0} repeats the loop at {1}", "线程 {0} 反复执行 {1} 处的循环",
                       NumberOf(subject, thread), PlaceOf(subject, thread, position));
  });
  way.next = NextOf(subject, exploration, options, !WhyNotMerged(problem));
  return way;
}

WayOut WayOutOf(const Subject& subject, const Exploration& exploration,
                const ExploreOptions& options, CardModel* model) {
  WayOut way;
  if (const auto& reached = exploration.reached) {
    std::string at;
    std::string at_zh;
    for (size_t i = 0; i < reached->lines.size(); ++i) {
      if (reached->lines[i] == 0) continue;
      const std::string place = fmt::format("{}:{}", subject.program, reached->lines[i]);
      const int number = subject.threads[i].thread;
      at += fmt::format("{}thread {} at {}", at.empty() ? "" : ", ", number, place);
      at_zh += fmt::format("{}线程 {} 在 {}", at_zh.empty() ? "" : "，", number, place);
    }
    way.reached.push_back(MakeMessage("every schedule up to {0} ms; the next state: {1}",
                                      "{0} ms 之前的所有调度；下一个状态：{2}", reached->at_ms, at,
                                      at_zh));
  }
  AddHeld(model->HeldSoFar(), &way.reached);
  for (Message& untested : model->UntestedRequirements()) {
    way.reached.push_back(std::move(untested));
  }
  Loops loops;
  CardWalk walk(model, false);
  const auto now = [&](int thread) {
    return static_cast<int>(model->controller().machine().thread(NumberOf(subject, thread)).pc);
  };
  for (int i = 0, thread = -1; i < kLookedAt && !walk.ended() && !walk.fault(); ++i) {
    thread = NextInTurn(walk.choices(), thread);
    const int from = now(thread);
    const int64_t cycle = model->controller().cycle();
    walk.Step(thread);
    loops.Step(thread, from, now(thread), cycle);
  }
  way.spent = loops.Named([&](int thread, int position) {
    return MakeMessage(
        "thread {0} polls at {1}: with GT_Delay(1) in its loop there are far fewer states",
        "线程 {0} 在 {1} 处轮询：在循环中加上 GT_Delay(1)，状态会少得多", NumberOf(subject, thread),
        PlaceOf(subject, thread, position));
  });
  if (!exploration.remembers_steps) way.spent.push_back(WhyEachStep(*model));
  way.next = NextOf(subject, exploration, options, false);
  if (subject.host == nullptr && exploration.reached && exploration.reached->until_ms > 0) {
    way.next.push_back(MakeMessage("until_ms = {0} in the scenario", "在场景中写 until_ms = {0}",
                                   exploration.reached->until_ms));
  }
  return way;
}

}  // namespace oncard::explore
