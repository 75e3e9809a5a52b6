#include "explore/dpor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "explore/key_set.h"

namespace oncard::explore {
namespace {

/// A step of one thread as plans and sleep sets remember it.
struct Step {
  int thread = 0;
  AccessSet access;
};

/// A plan: sequences of steps that share their beginnings, as a tree in a pool. Siblings are tried
/// in their order.
using PlanIndex = uint32_t;
constexpr PlanIndex kNoPlan = ~PlanIndex{0};
struct PlanNode {
  Step step;
  PlanIndex first_child = kNoPlan;
  PlanIndex next_sibling = kNoPlan;
};

class PlanPool {
 public:
  PlanNode& operator[](PlanIndex index) { return nodes_[index]; }
  PlanIndex Take(const Step& step) {
    PlanIndex index = free_;
    if (index == kNoPlan) {
      index = static_cast<PlanIndex>(nodes_.size());
      nodes_.emplace_back();
    } else {
      free_ = nodes_[index].next_sibling;
    }
    nodes_[index] = {step, kNoPlan, kNoPlan};
    return index;
  }
  /// Gives back a node without children.
  void Release(PlanIndex index) {
    nodes_[index].next_sibling = free_;
    free_ = index;
  }

 private:
  std::vector<PlanNode> nodes_;
  PlanIndex free_ = kNoPlan;
};

/// A step that has been executed.
struct Event {
  Step step;
  int64_t statements = 0;  ///< how many the model executed for it
  /// Of each thread, how many events happen before this one or are it.
  std::array<uint32_t, kThreadMax> clock{};
  uint32_t number = 0;  ///< among its thread's events, from 1
  std::vector<uint32_t>
      races;  ///< earlier events it races with, while their reversal is not settled
};

/// What the search knows of the state before an event.
struct Frame {
  std::vector<Step> sleep;    ///< what need not be tried here
  PlanIndex plans = kNoPlan;  ///< what is still to be tried, the one under way first
};

/// How a step stands to a sequence: one of its first, independent of all of it, or neither.
enum class Initial : uint8_t { kNo, kFirst, kIndependent };

class Search {
 public:
  Search(Model* model, const DporLimits& limits, const FinalVisitor& visit)
      : model_(*model), limits_(limits), visit_(visit) {}

  DporResult Run() {
    const int64_t start = model_.depth();
    threads_ = static_cast<size_t>(model_.thread_count());
    for (int thread = 0; thread < model_.thread_count(); ++thread) RunPrivate(thread);
    frames_.resize(1);
    Explore();
    while (model_.depth() > start) model_.Undo();
    return result_;
  }

 private:
  /// Executes a thread's statements up to the next that touches shared cells.
  void RunPrivate(int thread) {
    while (model_.Running(thread) && model_.depth() < limits_.depth &&
           model_.NextAccess(thread).empty()) {
      model_.Step(thread);
      ++result_.steps;
    }
  }

  void Explore() {
    Descend();
    while (!stopped_ && count_ > 0) {
      Leave();
      if (frames_[count_].plans != kNoPlan) Descend();
    }
    result_.complete = !stopped_;
  }

  /// Goes on from the present state until an execution has ended.
  void Descend() {
    while (model_.runnable() != 0) {
      if (model_.depth() >= limits_.depth) {
        stopped_ = true;
        return;
      }
      if (frames_[count_].plans == kNoPlan && !PlanFirst(&frames_[count_])) {
        ++result_.blocked;
        return;
      }
      Execute();
    }
    Finish();
  }

  /// Plans any thread that is awake.
  bool PlanFirst(Frame* frame) {
    uint32_t awake = model_.runnable();
    for (const Step& asleep : frame->sleep) awake &= ~(1u << asleep.thread);
    if (awake == 0) return false;
    const int thread = std::countr_zero(awake);
    frame->plans = pool_.Take({thread, model_.NextAccess(thread)});
    return true;
  }

  /// Takes the first plan's first step.
  void Execute() {
    if (frames_.size() < count_ + 2) frames_.resize(count_ + 2);
    const Frame& frame = frames_[count_];
    Frame& next = frames_[count_ + 1];
    PlanNode& plan = pool_[frame.plans];
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
    ++result_.steps;
    RunPrivate(step.thread);
    events_[count_ - 1].statements = model_.depth() - before;
  }

  /// Adds an event, with what happens before it and which of that it races with: the events of
  /// other threads that come before it directly.
  void AppendEvent(const Step& step) {
    if (events_.size() == count_) events_.emplace_back();
    Event& event = events_[count_];
    event.step = step;
    event.races.clear();
    std::fill_n(event.clock.begin(), threads_, 0u);
    for (size_t i = count_; i-- > 0;) {
      const Event& earlier = events_[i];
      const auto thread = static_cast<size_t>(earlier.step.thread);
      if (earlier.number <= event.clock[thread]) continue;  // something in between orders them
      const bool same_thread = earlier.step.thread == step.thread;
      if (!same_thread && !earlier.step.access.DependsOn(step.access)) continue;
      for (size_t t = 0; t < threads_; ++t) {
        event.clock[t] = std::max(event.clock[t], earlier.clock[t]);
      }
      if (!same_thread) event.races.push_back(static_cast<uint32_t>(i));
    }
    event.number = ++event.clock[static_cast<size_t>(step.thread)];
    ++count_;
  }

  /// Takes back the last event: its step goes to sleep, what was planned for it is done.
  void Leave() {
    const Event& event = events_[--count_];
    for (int64_t i = 0; i < event.statements; ++i) model_.Undo();
    Frame& frame = frames_[count_];
    frame.sleep.push_back(event.step);
    const PlanIndex done = frame.plans;
    frame.plans = pool_[done].next_sibling;
    pool_.Release(done);
  }

  void Finish() {
    ++result_.executions;
    if (limits_.count_redundant && !traces_.Insert(TraceKey())) ++result_.redundant;
    const bool told = limits_.stop != nullptr && limits_.stop->load(std::memory_order_relaxed);
    if (!visit_(model_) || told || result_.executions >= limits_.executions) {
      stopped_ = true;
      return;
    }
    for (size_t later = 1; later < count_; ++later) {
      std::vector<uint32_t>& races = events_[later].races;
      std::erase_if(races, [&](uint32_t earlier) { return Reverse(earlier, later); });
    }
  }

  /// Names the trace: for every event what happens before it, in whatever order they came.
  StateKey TraceKey() const {
    StateKey key;
    for (size_t i = 0; i < count_; ++i) {
      const Event& event = events_[i];
      StateKey name;
      for (size_t t = 0; t < threads_; ++t) {
        AddToKey(static_cast<uint32_t>(t), event.clock[t], &name);
      }
      AddToKey(static_cast<uint32_t>(event.step.thread), static_cast<int64_t>(name.low), &key);
    }
    return key;
  }

  bool HappensBefore(const Event& first, const Event& second) const {
    return first.number <= second.clock[static_cast<size_t>(first.step.thread)];
  }

  /// Plans an execution in which the two events of a race come the other way round, unless one is
  /// planned or has been seen. True when that holds for all executions that begin as this one does
  /// up to the later event.
  bool Reverse(size_t earlier, size_t later) {
    rest_.clear();
    for (size_t i = earlier + 1; i < later; ++i) AppendConcurrent(earlier, i);
    rest_.push_back(&events_[later].step);
    const size_t certain = rest_.size();
    // What follows cannot depend on the later event, so the order among them does not matter.
    for (size_t i = later + 1; i < count_; ++i) AppendConcurrent(earlier, i);
    Frame& frame = frames_[earlier];
    for (const Step& asleep : frame.sleep) {
      size_t decided = 0;
      if (InitialOf(asleep, &decided) != Initial::kNo) return decided < certain;
    }
    Insert(&frame.plans);
    return true;
  }

  void AppendConcurrent(size_t earlier, size_t index) {
    if (!HappensBefore(events_[earlier], events_[index])) rest_.push_back(&events_[index].step);
  }

  /// How `step`, the next of its thread, stands to the sequence rest_; `decided` is the element
  /// that says so, or the size when it takes all.
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
        // A planned sequence that ends here is a beginning of this one.
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
  size_t threads_ = 0;
  DporResult result_;
  bool stopped_ = false;
  PlanPool pool_;
  // Only grown, so that their memory is used again: events_[0..count_), frames_[0..count_].
  size_t count_ = 0;
  std::vector<Event> events_;
  std::vector<Frame> frames_;
  std::vector<const Step*> rest_;
  KeySet traces_;
};

}  // namespace

DporResult ExploreTraces(Model* model, const DporLimits& limits, const FinalVisitor& visit) {
  return Search(model, limits, visit).Run();
}

}  // namespace oncard::explore
