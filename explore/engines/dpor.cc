#include "explore/engines/dpor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "explore/engines/progress.h"
#include "explore/engines/short_traces.h"
#include "explore/engines/trace_names.h"
#include "explore/engines/trace_plans.h"
#include "explore/engines/waiting_loop.h"

namespace oncard::explore {
namespace {

/// A step of one thread, as stored in plans and sleep sets.
struct Step {
  int thread = 0;
  AccessSet access;
  /// It is in the sleep set because another unit of the search begins with it.
  bool elsewhere = false;
};

int ThreadOf(const Step& step) { return step.thread; }

/// A step that has been executed.
struct Event {
  Step step;
  int64_t statements = 0;  ///< number of statements that the model executed for it
  /// For each thread, how many of its events happen before this one or are this one.
  std::array<uint32_t, kThreadMax> clock{};
  uint32_t number = 0;  ///< its position among the events of its thread, from 1
  /// The entries that it replaced (ForLatest()), in the order in which they were changed.
  std::array<uint32_t, AccessSet::kReadMax + 2> before{};
  uint64_t name = 0;   ///< NameEvent()
  uint64_t trace = 0;  ///< the sum of the names up to this one
  bool waits = false;  ///< its thread now waits in a loop (waiting_loop.h), which this step began
  std::vector<uint32_t>
      races;  ///< earlier events that it races with and whose reversal is not settled yet
};

/// Data of the search about the state before an event.
struct Frame {
  std::vector<Step> sleep;    ///< steps that need not be tried here
  PlanIndex plans = kNoPlan;  ///< what is still to be tried; the current one first
};

/// The relation of a step to a sequence: it can be its first step (kFirst), it is independent of
/// all its steps (kIndependent), or neither (kNo).
enum class Initial : uint8_t { kNo, kFirst, kIndependent };

/// An execution that the model has executed statement by statement.
class ModelEnd : public TraceEnd {
 public:
  explicit ModelEnd(const Model& model) : model_(model) {}
  const Model& State() override { return model_; }
  uint32_t StateNumber() override { return kNoNumber; }
  int64_t Statements() const override { return model_.depth(); }
  std::vector<uint8_t> Threads() const override {
    std::vector<uint8_t> threads;
    for (int64_t i = 0; i < model_.depth(); ++i) {
      threads.push_back(static_cast<uint8_t>(model_.StepThread(i)));
    }
    return threads;
  }

 private:
  const Model& model_;
};

class Search {
 public:
  Search(Model* model, const DporLimits& limits, const FinalVisitor& visit, TraceNames* names)
      : model_(*model),
        limits_(limits),
        visit_(visit),
        names_(*names),
        may_wait_(model->HasLoops()) {}

  /// Goes on from a handover of the search of short traces, which has the result so far.
  DporResult Run(TraceUnit* unit, const TraceHandover& handover, const DporResult& result) {
    const int64_t start = model_.depth();
    result_ = result;
    threads_ = static_cast<size_t>(model_.thread_count());
    for (int thread = 0; thread < model_.thread_count(); ++thread) RunPrivate(thread);
    TakePrefix(*unit);
    if (handover.begun) {
      const std::span frames(handover.frames);
      Restore(frames.first(frames.size() - 1));
      RestoreState(frames.back());
      Descend();
    } else if (unit->frames.empty()) {
      Descend();
    } else {
      Restore(unit->frames);
      ReverseRaces();
    }
    Explore();
    const bool goes_on = !result_.complete && !result_.too_deep;
    unit->frames = goes_on ? Save() : std::vector<SavedFrame>{};
    UndoTo(start);
    return result_;
  }

  std::vector<TraceUnit> Split(size_t count) {
    const int64_t start = model_.depth();
    threads_ = static_cast<size_t>(model_.thread_count());
    for (int thread = 0; thread < model_.thread_count(); ++thread) RunPrivate(thread);
    std::deque<TraceUnit> open = {TraceUnit{}};
    std::vector<TraceUnit> whole;  // units with a single execution
    while (!open.empty() && open.size() + whole.size() < count) {
      const int64_t before = model_.depth();
      const TraceUnit unit = std::move(open.front());
      open.pop_front();
      TakePrefix(unit);
      if (Enabled() == 0) {
        whole.push_back(unit);
      } else {
        SplitInto(unit, &open);
      }
      UndoTo(before);
      Forget();
    }
    UndoTo(start);
    whole.insert(whole.end(), open.begin(), open.end());
    return whole;
  }

 private:
  /// Executes a thread's statements up to the next one that accesses shared cells.
  void RunPrivate(int thread) { model_.StepPrivate(thread, limits_.depth - model_.depth()); }

  void UndoTo(int64_t depth) {
    while (model_.depth() > depth) model_.Undo();
  }

  /// The next step of a thread.
  Step NextStep(int thread) const { return {thread, model_.NextAccess(thread)}; }
  std::vector<Step> NextSteps(const std::vector<uint8_t>& threads) const {
    std::vector<Step> steps;
    steps.reserve(threads.size());
    for (const uint8_t thread : threads) steps.push_back(NextStep(thread));
    return steps;
  }

  // --- Parts of a search -------------------------------------------------------------------------

  /// Executes the steps before the unit; no alternatives to them are tried.
  void TakePrefix(const TraceUnit& unit) {
    frames_.resize(std::max<size_t>(frames_.size(), unit.prefix.size() + 1));
    for (const uint8_t thread : unit.prefix) {
      frames_[count_].sleep.clear();
      frames_[count_].plans = pool_.Take(NextStep(thread));
      Execute();
    }
    first_ = count_;
    frames_[count_].sleep = NextSteps(unit.sleep);
    for (Step& step : frames_[count_].sleep) step.elsewhere = true;
  }

  /// Discards the steps of a unit after the model has undone their statements.
  void Forget() {
    while (count_ > 0) {
      --count_;
      pool_.Release(frames_[count_].plans);
      frames_[count_].plans = kNoPlan;
    }
    unsettled_.clear();
    latest_of_thread_ = {};
    latest_of_cell_.clear();
  }

  /// Splits a unit into units whose prefixes are one step longer.
  void SplitInto(const TraceUnit& unit, std::deque<TraceUnit>* units) const {
    std::vector<Step> sleep = frames_[count_].sleep;
    for (uint32_t left = Enabled(); left != 0; left &= left - 1) {
      const int thread = std::countr_zero(left);
      if (std::ranges::find(sleep, thread, &Step::thread) != sleep.end()) continue;
      const Step step = NextStep(thread);
      TraceUnit longer = {unit.prefix, {}};
      longer.prefix.push_back(static_cast<uint8_t>(thread));
      for (const Step& asleep : sleep) {
        if (asleep.access.DependsOn(step.access)) continue;
        longer.sleep.push_back(static_cast<uint8_t>(asleep.thread));
      }
      units->push_back(std::move(longer));
      sleep.push_back(step);
    }
  }

  std::vector<SavedFrame> Save() const {
    std::vector<SavedFrame> frames;
    for (size_t i = first_; i < count_; ++i) {
      SavedFrame frame;
      for (const Step& step : frames_[i].sleep) {
        frame.sleep.push_back(static_cast<uint8_t>(step.thread));
      }
      frame.plans = pool_.Save(frames_[i].plans);
      frame.races = events_[i].races;
      frames.push_back(std::move(frame));
    }
    return frames;
  }

  /// Executes the path of an interrupted search again.
  void Restore(std::span<const SavedFrame> saved) {
    for (const SavedFrame& frame : saved) {
      RestoreState(frame);
      Execute();
      // Keeps only the races that are not settled yet.
      std::vector<uint32_t>& races = events_[count_ - 1].races;
      if (races.empty()) continue;
      std::erase_if(races, [&](uint32_t earlier) {
        return std::ranges::find(frame.races, earlier) == frame.races.end();
      });
      if (races.empty()) unsettled_.pop_back();
    }
  }
  /// Restores what is known about the current state.
  void RestoreState(const SavedFrame& saved) {
    std::vector<Step> sleep = NextSteps(saved.sleep);
    for (Step& step : sleep) step.elsewhere = SleepsElsewhere(frames_[count_], step.thread);
    frames_[count_].sleep = std::move(sleep);
    PlanRun run(this);
    pool_.Restore(saved.plans, &run, &frames_[count_].plans);
  }
  static bool SleepsElsewhere(const Frame& frame, int thread) {
    return std::ranges::any_of(frame.sleep, [&](const Step& asleep) {
      return asleep.thread == thread && asleep.elsewhere;
    });
  }
  /// The program, as PlanPool::Restore() executes plans.
  class PlanRun {
   public:
    explicit PlanRun(Search* search) : search_(*search) {}
    Step NextStep(int thread) const { return search_.NextStep(thread); }
    bool Take(int thread) {
      search_.model_.Step(thread);
      search_.RunPrivate(thread);
      return true;
    }
    int64_t depth() const { return search_.model_.depth(); }
    void UndoTo(int64_t depth) { search_.UndoTo(depth); }

   private:
    Search& search_;
  };

  // --- The search --------------------------------------------------------------------------------

  /// Continues the search after the end of an execution.
  void Explore() {
    while (!stopped_ && count_ > first_) {
      Leave();
      if (frames_[count_].plans != kNoPlan) Descend();
    }
    const bool nothing_left = count_ == first_ && !result_.too_deep;
    result_.complete = !stopped_ || nothing_left;
  }

  /// Executes steps from the current state until the execution ends.
  void Descend() {
    while (Enabled() != 0) {
      if (model_.depth() >= limits_.depth) {
        stopped_ = true;
        result_.too_deep = true;
        return;
      }
      if (frames_[count_].plans == kNoPlan && !PlanFirst(&frames_[count_])) {
        ++result_.blocked;
        stopped_ = IsTold(limits_.stop);
        ReverseRaces();
        return;
      }
      Execute();
    }
    Finish();
  }

  /// Plans a step of any thread that is not in the sleep set.
  bool PlanFirst(Frame* frame) {
    uint32_t awake = Enabled();
    for (const Step& asleep : frame->sleep) awake &= ~(1u << asleep.thread);
    if (awake == 0) return false;
    const int thread = std::countr_zero(awake);
    frame->plans = pool_.Take({thread, model_.NextAccess(thread)});
    return true;
  }

  /// Executes the first step of the first plan.
  void Execute() {
    if (frames_.size() < count_ + 2) frames_.resize(count_ + 2);
    const Frame& frame = frames_[count_];
    Frame& next = frames_[count_ + 1];
    auto& plan = pool_[frame.plans];
    const Step step = plan.step;
    next.plans = plan.first_child;
    plan.first_child = kNoPlan;
    next.sleep.clear();
    for (const Step& asleep : frame.sleep) {
      if (asleep.thread != step.thread && !asleep.access.DependsOn(step.access)) {
        next.sleep.push_back(asleep);
      }
    }
    const int64_t before = model_.depth();
    AppendEvent(step);
    model_.Step(step.thread);
    RunPrivate(step.thread);
    Event& event = events_[count_ - 1];
    event.statements = model_.depth() - before;
    event.waits =
        may_wait_ && step.access.write == AccessSet::kNone && model_.Running(step.thread) &&
        model_.NextAccess(step.thread).SameAs(step.access) && WaitsInLoop(&model_, step.thread);
  }

  /// Bit n: thread n can execute a step. A thread that waits in a loop cannot before another one
  /// has written what it reads: until then a pass of its loop changes nothing.
  uint32_t Enabled() const {
    uint32_t enabled = model_.runnable();
    if (!may_wait_) return enabled;
    for (uint32_t left = enabled; left != 0; left &= left - 1) {
      const int thread = std::countr_zero(left);
      const uint32_t latest = latest_of_thread_[static_cast<size_t>(thread)];
      if (latest == 0 || !events_[latest - 1].waits) continue;
      if (!IsWrittenAfter(latest)) enabled &= ~(1u << thread);
    }
    return enabled;
  }

  /// True if one of the cells that an event, counted from 1, has read was written after it.
  bool IsWrittenAfter(uint32_t event) const {
    const AccessSet& access = events_[event - 1].step.access;
    for (uint32_t i = 0; i < access.read_count; ++i) {
      const size_t write = size_t{access.reads[i]} * (threads_ + 1) + threads_;
      if (write < latest_of_cell_.size() && latest_of_cell_[write] > event) return true;
    }
    return false;
  }

  /// True if the later event was enabled by the earlier one: its thread waited for this write
  /// alone.
  bool EndsWait(size_t earlier, size_t later) const {
    const uint32_t own = events_[later].before[0];  // the event before it in its thread
    if (own == 0 || !events_[own - 1].waits) return false;
    for (size_t i = own; i < later; ++i) {
      const uint32_t written = events_[i].step.access.write;
      if (i != earlier && written != AccessSet::kNone &&
          events_[later].step.access.Touches(written)) {
        return false;
      }
    }
    return true;
  }

  /// Adds an event. Determines which events happen before it, and with which of them it races:
  /// those of other threads that immediately precede it in the happens-before order.
  void AppendEvent(const Step& step) {
    if (events_.size() == count_) events_.emplace_back();
    Event& event = events_[count_];
    event.step = step;
    event.races.clear();
    std::fill_n(event.clock.begin(), threads_, 0u);
    FindPredecessors(step);
    uint64_t names = 0;
    for (size_t p = 0; p < predecessor_count_; ++p) {
      const uint32_t i = predecessors_[p];
      const Event& earlier = events_[i - 1];
      const auto thread = static_cast<size_t>(earlier.step.thread);
      if (earlier.number <= event.clock[thread])
        continue;  // ordered already by an event in between
      for (size_t t = 0; t < threads_; ++t) {
        event.clock[t] = std::max(event.clock[t], earlier.clock[t]);
      }
      names += earlier.name;
      if (earlier.step.thread != step.thread) event.races.push_back(i - 1);
    }
    event.number = ++event.clock[static_cast<size_t>(step.thread)];
    if (!event.races.empty()) unsettled_.push_back(static_cast<uint32_t>(count_));
    event.name = NameEvent(step.thread, names);
    event.trace = event.name + (count_ == 0 ? 0 : events_[count_ - 1].trace);
    ++count_;
    size_t changed = 0;
    ForLatest(step, [&](uint32_t* latest) {
      event.before[changed++] = std::exchange(*latest, static_cast<uint32_t>(count_));
    });
  }

  /// Collects the events that a step depends on and that may immediately precede it, the latest
  /// first.
  void FindPredecessors(const Step& step) {
    predecessor_count_ = 0;
    const auto add = [this](uint32_t latest) {
      if (latest == 0) return;
      size_t at = predecessor_count_++;
      for (; at > 0 && predecessors_[at - 1] < latest; --at) {
        predecessors_[at] = predecessors_[at - 1];
      }
      predecessors_[at] = latest;
    };
    add(latest_of_thread_[static_cast<size_t>(step.thread)]);
    for (uint32_t i = 0; i < step.access.read_count; ++i) {
      add(LatestOf(step.access.reads[i])[threads_]);
    }
    if (step.access.write != AccessSet::kNone) {
      const uint32_t* latest = LatestOf(step.access.write);
      for (size_t i = 0; i <= threads_; ++i) add(latest[i]);
    }
  }

  /// Calls `change` for every entry about the latest events that this step replaces, always in the
  /// same order.
  template <typename Change>
  void ForLatest(const Step& step, const Change& change) {
    change(&latest_of_thread_[static_cast<size_t>(step.thread)]);
    for (uint32_t i = 0; i < step.access.read_count; ++i) {
      change(LatestOf(step.access.reads[i]) + step.thread);
    }
    if (step.access.write != AccessSet::kNone) change(LatestOf(step.access.write) + threads_);
  }

  /// For a cell: each thread's latest event that reads it, then the latest event that writes it,
  /// counted from 1; 0 if there is none.
  uint32_t* LatestOf(uint32_t cell) {
    const size_t begin = size_t{cell} * (threads_ + 1);
    if (latest_of_cell_.size() < begin + threads_ + 1) latest_of_cell_.resize(begin + threads_ + 1);
    return &latest_of_cell_[begin];
  }

  /// Undoes the last event: its step goes to the sleep set and its plan is completed.
  void Leave() {
    const Event& event = events_[--count_];
    if (!unsettled_.empty() && unsettled_.back() == count_) unsettled_.pop_back();
    std::array<uint32_t*, AccessSet::kReadMax + 2> changed{};
    size_t changes = 0;
    ForLatest(event.step, [&](uint32_t* latest) { changed[changes++] = latest; });
    while (changes-- > 0) *changed[changes] = event.before[changes];
    for (int64_t i = 0; i < event.statements; ++i) model_.Undo();
    Frame& frame = frames_[count_];
    frame.sleep.push_back(event.step);
    const PlanIndex done = frame.plans;
    frame.plans = pool_[done].next_sibling;
    pool_.Release(done);
  }

  void Finish() {
    ++result_.executions;
    if (limits_.count_redundant) names_.Add(count_ == 0 ? 0 : events_[count_ - 1].trace);
    ModelEnd end(model_);
    stopped_ = !visit_(&end) || IsTold(limits_.stop) || result_.executions >= limits_.executions;
    ReverseRaces();
  }

  /// Plans the reversals of the races of an execution. If the search is told to end, those that are
  /// left are planned when it goes on (Restore()).
  void ReverseRaces() {
    std::erase_if(unsettled_, [this](uint32_t later) {
      std::vector<uint32_t>& races = events_[later].races;
      std::erase_if(races, [&](uint32_t earlier) {
        const bool told = IsTold(limits_.stop);
        stopped_ = stopped_ || told;
        return !told && Reverse(earlier, later);
      });
      return races.empty();
    });
  }

  bool HappensBefore(const Event& first, const Event& second) const {
    return first.number <= second.clock[static_cast<size_t>(first.step.thread)];
  }

  /// Plans an execution in which the two events of a race have the reverse order, unless one is
  /// planned or has been executed. True if this holds for all executions that have the same steps
  /// up to and including the later event.
  bool Reverse(size_t earlier, size_t later) {
    if (earlier < first_) return true;  // another unit begins with the reversal
    // The other order is a pass more of a loop, after which everything is as before it.
    if (EndsWait(earlier, later)) return true;
    rest_.clear();
    for (size_t i = earlier + 1; i < later; ++i) AppendConcurrent(earlier, i);
    rest_.push_back(&events_[later].step);
    const size_t certain = rest_.size();
    // The steps after the later event cannot depend on it here, so their order does not matter.
    for (size_t i = later + 1; i < count_; ++i) AppendConcurrent(earlier, i);
    Frame& frame = frames_[earlier];
    for (const Step& asleep : frame.sleep) {
      size_t decided = 0;
      const Initial initial = InitialOf(asleep, &decided);
      if (initial == Initial::kNo) continue;
      // Another unit begins with this step, and this unit does not know what it finds. So sequences
      // after which the step leaves the sleep set must be tried, even if they could also come after
      // it.
      if (initial == Initial::kIndependent && asleep.elsewhere) continue;
      return decided < certain;
    }
    Insert(&frame.plans);
    return true;
  }

  void AppendConcurrent(size_t earlier, size_t index) {
    if (!HappensBefore(events_[earlier], events_[index])) rest_.push_back(&events_[index].step);
  }

  /// The relation of `step`, the next step of its thread, to the sequence rest_. `decided` is the
  /// index of the element that determines it, or the size if the step is independent of all.
  Initial InitialOf(const Step& step, size_t* decided) const {
    for (size_t i = 0; i < rest_.size(); ++i) {
      *decided = i;
      if (rest_[i]->thread == step.thread) return Initial::kFirst;
      if (step.access.DependsOn(rest_[i]->access)) return Initial::kNo;
    }
    *decided = rest_.size();
    return Initial::kIndependent;
  }

  /// Adds rest_ to the plans unless one of them leads to it.
  void Insert(PlanIndex* plans) {
    PlanIndex* level = plans;  // pool_ does not grow while it is used
    PlanIndex parent = kNoPlan;
    while (true) {
      PlanIndex child = *level;
      size_t decided = 0;
      Initial initial = Initial::kNo;
      PlanIndex last = kNoPlan;
      while (child != kNoPlan) {
        initial = InitialOf(pool_[child].step, &decided);
        if (initial != Initial::kNo) break;
        last = child;
        child = pool_[child].next_sibling;
      }
      if (child == kNoPlan) {
        // The planned sequence that ends here is a prefix of this one.
        if (last == kNoPlan && parent != kNoPlan) return;
        AppendChain(plans, parent, last);
        return;
      }
      if (initial == Initial::kFirst) {
        rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(decided));
      }
      parent = child;
      level = &pool_[child].first_child;
    }
  }

  /// Adds rest_ as a chain after the sibling `last`, or as the first child of `parent`.
  void AppendChain(PlanIndex* plans, PlanIndex parent, PlanIndex last) {
    PlanIndex first = kNoPlan;
    for (size_t i = rest_.size(); i-- > 0;) {
      const PlanIndex node = pool_.Take(*rest_[i]);
      pool_[node].first_child = first;
      first = node;
    }
    if (last != kNoPlan) {
      pool_[last].next_sibling = first;
    } else if (parent != kNoPlan) {
      pool_[parent].first_child = first;
    } else {
      *plans = first;
    }
  }

  Model& model_;
  const DporLimits& limits_;
  const FinalVisitor& visit_;
  TraceNames& names_;
  bool may_wait_;  ///< a thread can jump back
  size_t threads_ = 0;
  DporResult result_;
  bool stopped_ = false;
  size_t first_ = 0;  ///< the unit's first event; those before it are its prefix
  PlanPool<Step> pool_;
  // They only grow, so that their memory is reused: events_[0..count_), frames_[0..count_].
  size_t count_ = 0;
  std::vector<Event> events_;
  std::vector<Frame> frames_;
  std::vector<const Step*> rest_;
  std::array<uint32_t, kThreadMax> latest_of_thread_{};  ///< event numbers, counted from 1
  std::vector<uint32_t> latest_of_cell_;                 ///< see LatestOf()
  /// See FindPredecessors(): of the same thread, of each cell read, of the cell written.
  std::array<uint32_t, 1 + AccessSet::kReadMax + kThreadMax + 1> predecessors_{};
  size_t predecessor_count_ = 0;
  std::vector<uint32_t> unsettled_;  ///< events with races, the latest last
};

}  // namespace

std::vector<TraceUnit> SplitTraces(Model* model, size_t count) {
  const DporLimits limits;
  TraceNames names;
  return Search(model, limits, {}, &names).Split(count);
}

DporResult ExploreUnit(Model* model, TraceUnit* unit, const DporLimits& limits,
                       const FinalVisitor& visit) {
  DporResult result;
  TraceNames names;
  std::optional<TraceHandover> handover = TraceHandover{};
  if (!limits.general) {
    handover = ExploreShortTraces(*model, limits, visit, unit, &result, &names);
  }
  if (handover) result = Search(model, limits, visit, &names).Run(unit, *handover, result);
  if (limits.count_redundant) result.redundant = names.CountRepeated();
  return result;
}

DporResult ExploreTraces(Model* model, const DporLimits& limits, const FinalVisitor& visit) {
  TraceUnit whole;
  return ExploreUnit(model, &whole, limits, visit);
}

}  // namespace oncard::explore
