#include "explore/engines/short_traces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "explore/engines/progress.h"
#include "explore/engines/trace_plans.h"
#include "explore/models/step_model.h"

namespace oncard::explore {
namespace {

/// A set of events, by their positions in the execution.
using Events = uint64_t;
constexpr size_t kEventMax = 64;

constexpr Events EventsOf(size_t event) { return Events{1} << event; }
/// Those before a position that is less than kEventMax.
constexpr Events EventsBefore(size_t event) { return EventsOf(event) - 1; }
constexpr size_t LastOf(Events events) {
  return 63 - static_cast<size_t>(std::countl_zero(events));
}
constexpr size_t FirstOf(Events events) { return static_cast<size_t>(std::countr_zero(events)); }

/// One word: a processor waits where parts are written and then read together.
class ShortStep {
 public:
  ShortStep() = default;
  ShortStep(int thread, uint8_t access)
      : bits_(static_cast<uint32_t>(thread) | uint32_t{access} << kAccessShift) {}

  uint8_t thread() const { return static_cast<uint8_t>(bits_); }
  /// StepModel::NextAccess().
  uint8_t access() const { return static_cast<uint8_t>(bits_ >> kAccessShift); }
  /// It is in the sleep set because another unit of the search begins with it.
  bool elsewhere() const { return (bits_ & kElsewhere) != 0; }
  void SetElsewhere(bool elsewhere) {
    bits_ = (bits_ & ~kElsewhere) | (elsewhere ? kElsewhere : 0u);
  }

 private:
  static constexpr int kAccessShift = 8;
  static constexpr uint32_t kElsewhere = 1u << 16;

  uint32_t bits_ = 0;
};

int ThreadOf(const ShortStep& step) { return step.thread(); }

/// A step that has been executed.
struct ShortEvent {
  ShortStep step;
  Events races = 0;  ///< those that it races with and whose reversal is not settled yet
  uint64_t name = 0;
  uint64_t trace = 0;  ///< the sum of the names up to this one
};

/// A sleep set: steps of different threads, in the order in which they were added.
class ShortSleep {
 public:
  const ShortStep* begin() const { return steps_.data(); }
  const ShortStep* end() const { return steps_.data() + size_; }
  void Clear() { size_ = 0; }
  /// Only the plans of a damaged search file can have more steps than there are threads; those are
  /// ignored.
  void Add(const ShortStep& step) {
    if (size_ < steps_.size()) steps_[size_++] = step;
  }

 private:
  uint32_t size_ = 0;
  std::array<ShortStep, kThreadMax> steps_;
};

/// Data of the search about the state before an event.
struct ShortFrame {
  ShortSleep sleep;           ///< steps that need not be tried here
  PlanIndex plans = kNoPlan;  ///< what is still to be tried; the current one first
};

/// The program, as PlanPool::Restore() executes plans.
class ShortPlanRun {
 public:
  explicit ShortPlanRun(StepModel* program) : program_(*program) {}
  ShortStep NextStep(int thread) const { return {thread, program_.NextAccess(thread)}; }
  bool Take(int thread) { return program_.Step(thread); }
  size_t depth() const { return program_.depth(); }
  void UndoTo(size_t depth) {
    while (program_.depth() > depth) program_.Undo();
  }

 private:
  StepModel& program_;
};

class ShortSearch : public TraceEnd {
 public:
  ShortSearch(const Model& model, const DporLimits& limits, const FinalVisitor& visit,
              DporResult* result, TraceNames* names)
      : program_(model, limits.depth),
        limits_(limits),
        visit_(visit),
        result_(*result),
        names_(*names),
        may_wait_(model.HasLoops()) {}

  std::optional<TraceHandover> Run(TraceUnit* unit) {
    if (!program_.Begin() || !TakePrefix(*unit)) return TraceHandover{};
    if (unit->frames.empty()) {
      Descend();
    } else {
      if (!Restore(unit->frames)) return TraceHandover{};
      ReverseRaces();
    }
    Explore();
    if (stuck_) return TraceHandover{true, Save(true)};
    unit->frames = result_.complete ? std::vector<SavedFrame>{} : Save(false);
    return std::nullopt;
  }

  const Model& State() override { return program_.AsModel(); }
  uint32_t StateNumber() override { return program_.StateNumber(); }
  int64_t Statements() const override { return program_.statements(); }
  std::vector<uint8_t> Threads() const override { return program_.StatementThreads(); }

 private:
  ShortStep NextStep(int thread) const { return {thread, program_.NextAccess(thread)}; }
  // --- Parts of a search -------------------------------------------------------------------------

  /// Executes the steps before the unit; no alternatives to them are tried. False if that is not
  /// possible.
  bool TakePrefix(const TraceUnit& unit) {
    for (const uint8_t thread : unit.prefix) {
      frames_[count_].plans = pool_.Take(NextStep(thread));
      if (!Execute()) return false;
    }
    first_ = count_;
    for (const uint8_t thread : unit.sleep) {
      ShortStep step = NextStep(thread);
      step.SetElsewhere(true);
      frames_[count_].sleep.Add(step);
    }
    return true;
  }

  /// `stuck`: with the state in which a step could not be executed.
  std::vector<SavedFrame> Save(bool stuck) const {
    std::vector<SavedFrame> frames;
    for (size_t i = first_; i < count_ + (stuck ? 1 : 0); ++i) {
      SavedFrame frame;
      for (const ShortStep& step : frames_[i].sleep) frame.sleep.push_back(step.thread());
      frame.plans = pool_.Save(frames_[i].plans);
      for (Events left = i < count_ ? events_[i].races : 0; left != 0;) {
        const size_t earlier = LastOf(left);
        frame.races.push_back(static_cast<uint32_t>(earlier));
        left &= EventsBefore(earlier);
      }
      frames.push_back(std::move(frame));
    }
    return frames;
  }

  /// Executes the path of an interrupted search again. False if that is not possible.
  bool Restore(const std::vector<SavedFrame>& saved) {
    ShortPlanRun run(&program_);
    for (const SavedFrame& frame : saved) {
      ShortSleep sleep;
      for (const uint8_t thread : frame.sleep) {
        ShortStep step = NextStep(thread);
        step.SetElsewhere(SleepsElsewhere(frames_[count_], thread));
        sleep.Add(step);
      }
      frames_[count_].sleep = sleep;
      if (!pool_.Restore(frame.plans, &run, &frames_[count_].plans) || !Execute()) return false;
      // Keeps only the races that are not settled yet.
      Events unsettled = 0;
      for (const uint32_t earlier : frame.races) {
        if (earlier < kEventMax) unsettled |= EventsOf(earlier);
      }
      events_[count_ - 1].races &= unsettled;
      if (events_[count_ - 1].races == 0) unsettled_ &= EventsBefore(count_ - 1);
    }
    return true;
  }
  static bool SleepsElsewhere(const ShortFrame& frame, int thread) {
    return std::ranges::any_of(frame.sleep, [&](const ShortStep& asleep) {
      return asleep.thread() == thread && asleep.elsewhere();
    });
  }

  // --- The search --------------------------------------------------------------------------------

  /// Continues the search after the end of an execution.
  void Explore() {
    while (!stopped_ && !stuck_ && count_ > first_) {
      Leave();
      if (frames_[count_].plans != kNoPlan) Descend();
    }
    result_.complete = !stuck_ && (!stopped_ || count_ == first_);
  }

  /// Executes steps from the current state until the execution ends.
  void Descend() {
    while (program_.runnable() != 0) {
      if (frames_[count_].plans == kNoPlan && !PlanFirst(&frames_[count_])) {
        ++result_.blocked;
        stopped_ = IsTold(limits_.stop);
        ReverseRaces();
        return;
      }
      if (!Execute()) {
        stuck_ = true;
        return;
      }
    }
    Finish();
  }

  /// Plans a step of any thread that is not in the sleep set.
  bool PlanFirst(ShortFrame* frame) {
    uint32_t awake = program_.runnable();
    for (const ShortStep& asleep : frame->sleep) awake &= ~(1u << asleep.thread());
    if (awake == 0) return false;
    frame->plans = pool_.Take(NextStep(std::countr_zero(awake)));
    return true;
  }

  /// Executes the first step of the first plan. False, without a change, if that is not possible.
  bool Execute() {
    const ShortFrame& frame = frames_[count_];
    auto& plan = pool_[frame.plans];
    const ShortStep step = plan.step;
    if (count_ == kEventMax || !program_.Step(step.thread())) return false;
    if (may_wait_ && program_.Repeats(step.thread(), step.access())) {
      // The general search knows what threads wait for.
      program_.Undo();
      return false;
    }
    while (access_count_ < program_.access_count()) AddAccess();
    ShortFrame& next = frames_[count_ + 1];
    next.plans = plan.first_child;
    plan.first_child = kNoPlan;
    const uint64_t dependent = program_.Dependent(step.access());
    next.sleep.Clear();
    for (const ShortStep& asleep : frame.sleep) {
      if (asleep.thread() != step.thread() && (dependent >> asleep.access() & 1) == 0) {
        next.sleep.Add(asleep);
      }
    }
    AppendEvent(step, dependent);
    return true;
  }

  /// Notes the events that depend on an access that has become known.
  void AddAccess() {
    const auto access = static_cast<uint8_t>(access_count_++);
    for (size_t i = 0; i < count_; ++i) {
      if ((program_.Dependent(events_[i].step.access()) >> access & 1) != 0) {
        dependent_on_[access] |= EventsOf(i);
      }
    }
  }

  /// Adds an event. Determines which events happen before it, and with which of them it races:
  /// those of other threads that immediately precede it in the happens-before order.
  void AppendEvent(const ShortStep& step, uint64_t dependent) {
    const Events own = of_thread_[step.thread()];
    Events before = 0;
    Events races = 0;
    uint64_t names = 0;
    for (Events left = own | dependent_on_[step.access()]; left != 0;) {
      const size_t earlier = LastOf(left);
      before |= before_[earlier] | EventsOf(earlier);
      races |= EventsOf(earlier);
      names += events_[earlier].name;
      left &= ~before;
    }
    races &= ~own;
    ShortEvent& event = events_[count_];
    event.step = step;
    event.races = races;
    event.name = NameEvent(step.thread(), names);
    event.trace = event.name + (count_ == 0 ? 0 : events_[count_ - 1].trace);
    before_[count_] = before;
    const Events bit = EventsOf(count_);
    if (races != 0) unsettled_ |= bit;
    of_thread_[step.thread()] |= bit;
    for (uint64_t left = dependent; left != 0; left &= left - 1) {
      dependent_on_[static_cast<size_t>(std::countr_zero(left))] |= bit;
    }
    ++count_;
  }

  /// Undoes the last event: its step goes to the sleep set and its plan is completed.
  void Leave() {
    const ShortStep step = events_[--count_].step;
    const Events rest = EventsBefore(count_);
    unsettled_ &= rest;
    of_thread_[step.thread()] &= rest;
    for (uint64_t left = program_.Dependent(step.access()); left != 0; left &= left - 1) {
      dependent_on_[static_cast<size_t>(std::countr_zero(left))] &= rest;
    }
    program_.Undo();
    ShortFrame& frame = frames_[count_];
    frame.sleep.Add(step);
    const PlanIndex done = frame.plans;
    frame.plans = pool_[done].next_sibling;
    pool_.Release(done);
  }

  void Finish() {
    ++result_.executions;
    if (limits_.count_redundant) names_.Add(count_ == 0 ? 0 : events_[count_ - 1].trace);
    stopped_ = !visit_(this) || IsTold(limits_.stop) || result_.executions >= limits_.executions;
    ReverseRaces();
  }

  /// Plans the reversals of the races of an execution.
  void ReverseRaces() {
    for (Events left = unsettled_; left != 0; left &= left - 1) {
      const size_t later = FirstOf(left);
      for (Events races = events_[later].races; races != 0;) {
        const size_t earlier = LastOf(races);
        races &= ~EventsOf(earlier);
        if (Reverse(earlier, later)) events_[later].races &= ~EventsOf(earlier);
      }
      if (events_[later].races == 0) unsettled_ &= ~EventsOf(later);
    }
  }

  /// The later events that an event does not happen before.
  Events ConcurrentWith(size_t event) const {
    Events after = 0;
    for (size_t i = count_; --i > event;) after = after << 1 | (before_[i] >> event & 1);
    const Events later = (count_ == kEventMax ? ~Events{0} : EventsBefore(count_)) &
                         ~EventsBefore(event) & ~EventsOf(event);
    return later & ~(event + 1 == kEventMax ? Events{0} : after << (event + 1));
  }

  /// Plans an execution in which the two events of a race have the reverse order, unless one is
  /// planned or has been executed. True if this holds for all executions that have the same steps
  /// up to and including the later event.
  bool Reverse(size_t earlier, size_t later) {
    if (earlier < first_) return true;  // another unit begins with the reversal
    // The steps after the later event cannot depend on it here, so their order does not matter.
    const Events rest = ConcurrentWith(earlier) | EventsOf(later);
    ShortFrame& frame = frames_[earlier];
    for (const ShortStep& asleep : frame.sleep) {
      const Events own = rest & of_thread_[asleep.thread()];
      if (!CanBegin(asleep, own, rest)) continue;
      // Another unit begins with this step, and this unit does not know what it finds. So sequences
      // after which the step leaves the sleep set must be tried, even if they could also come after
      // it.
      if (own == 0 && asleep.elsewhere()) continue;
      return own != 0 && FirstOf(own) <= later;
    }
    Insert(rest, &frame.plans);
    return true;
  }

  /// True if a step can come first in a sequence of events, either because it is one of them, of
  /// which those of its thread are `own`, or because it is independent of all.
  bool CanBegin(const ShortStep& step, Events own, Events rest) const {
    const Events first = own & (~own + 1);
    return (rest & dependent_on_[step.access()] & (first - 1)) == 0;
  }

  /// Adds a sequence of events to the plans unless one of them leads to it.
  void Insert(Events rest, PlanIndex* plans) {
    PlanIndex* level = plans;  // pool_ does not grow while it is used
    PlanIndex parent = kNoPlan;
    while (true) {
      PlanIndex child = *level;
      PlanIndex last = kNoPlan;
      Events own = 0;
      for (; child != kNoPlan; child = pool_[child].next_sibling) {
        const ShortStep& step = pool_[child].step;
        own = rest & of_thread_[step.thread()];
        if (CanBegin(step, own, rest)) break;
        last = child;
      }
      if (child == kNoPlan) {
        // The planned sequence that ends here is a prefix of this one.
        if (last == kNoPlan && parent != kNoPlan) return;
        AppendChain(rest, plans, parent, last);
        return;
      }
      rest &= ~(own & (~own + 1));
      parent = child;
      level = &pool_[child].first_child;
    }
  }

  /// Adds events as a chain after the sibling `last`, or as the first child of `parent`.
  void AppendChain(Events rest, PlanIndex* plans, PlanIndex parent, PlanIndex last) {
    PlanIndex first = kNoPlan;
    while (rest != 0) {
      const size_t event = LastOf(rest);
      rest &= ~EventsOf(event);
      const PlanIndex node = pool_.Take(events_[event].step);
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

  StepModel program_;
  const DporLimits& limits_;
  const FinalVisitor& visit_;
  DporResult& result_;
  TraceNames& names_;
  bool may_wait_;  ///< a thread can jump back
  bool stopped_ = false;
  bool stuck_ = false;  ///< a step could not be executed
  size_t first_ = 0;    ///< the unit's first event; those before it are its prefix
  PlanPool<ShortStep> pool_;
  size_t count_ = 0;  ///< number of events
  std::array<ShortEvent, kEventMax> events_;
  /// For each event those that happen before it.
  std::array<Events, kEventMax> before_{};
  std::array<ShortFrame, kEventMax + 1> frames_;
  std::array<Events, kThreadMax> of_thread_{};
  /// For each access the events that depend on a step with it.
  std::array<Events, ThreadStates::kAccessMax> dependent_on_{};
  size_t access_count_ = 0;  ///< accesses in dependent_on_
  Events unsettled_ = 0;     ///< events with races
};

}  // namespace

std::optional<TraceHandover> ExploreShortTraces(const Model& model, const DporLimits& limits,
                                                const FinalVisitor& visit, TraceUnit* unit,
                                                DporResult* result, TraceNames* names) {
  if (model.depth() != 0 || !model.AccessesAreLocal()) return TraceHandover{};
  return ShortSearch(model, limits, visit, result, names).Run(unit);
}

}  // namespace oncard::explore
