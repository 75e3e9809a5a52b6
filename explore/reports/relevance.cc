#include "explore/reports/relevance.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "runtime/conditions/card_condition.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/file/expectation.h"

namespace oncard::explore {
namespace {

using runtime::LoggedStep;
using runtime::SlotChange;
using runtime::SlotValue;

/// Follows a run backward from its failure.
class BackwardSlice {
 public:
  BackwardSlice(const Subject& subject, const runtime::Controller& controller,
                const std::vector<TrailStep>& steps)
      : subject_(subject), controller_(controller), steps_(steps), matters_(steps.size(), false) {}

  std::vector<bool> Of(const Failure& failure) {
    switch (failure.fault.kind) {
      case Fault::Kind::kRequirement:
        BeginWith(subject_.requirements[static_cast<size_t>(failure.fault.requirement)],
                  failure.fault.thread);
        break;
      case Fault::Kind::kThread:
        BeginWithLastStepOf(failure.fault.thread);
        break;
      default:
        return std::vector<bool>(steps_.size(), true);
    }
    for (size_t i = steps_.size(); i-- > 0;) Visit(i);
    return std::move(matters_);
  }

 private:
  static int KeyOf(const vm::SlotAddress& slot) {
    return (slot.global ? 0 : (slot.page + 1) * vm::kSlotCount) + slot.id;
  }

  void BeginWith(const Requirement& requirement, int thread) {
    BeginWith(requirement.text, requirement, thread);
    if (requirement.IsResponse()) BeginWith(requirement.then, requirement, thread);
  }

  void BeginWith(const std::string& text, const Requirement& requirement, int thread) {
    auto expectation = runtime::ParseExpectation(text);
    if (!expectation.ok()) return;
    runtime::Condition condition = std::move(expectation.value().condition);
    const bool in_thread = requirement.scope == Scope::kAssert;
    const int number = subject_.threads[static_cast<size_t>(thread)].thread;
    const auto bound =
        in_thread ? runtime::CardCondition::BindInThread(std::move(condition), number, controller_)
                  : runtime::CardCondition::Bind(std::move(condition), controller_);
    if (!bound.ok()) return;
    // That it came to the statement matters, too.
    if (in_thread) BeginWithLastStepOf(thread);
    for (const runtime::Quantity& quantity : bound.value().quantities()) Need(quantity);
  }

  /// What a value that the requirement names depends on.
  void Need(const runtime::Quantity& quantity) {
    if (quantity.kind == runtime::QuantityKind::kVariable) {
      needed_.insert(KeyOf(quantity.slot));
      return;
    }
    if (!runtime::IsOfProgram(quantity.kind)) {
      card_ = true;
      return;
    }
    // The error of a thread can be what a command has returned.
    card_ = card_ || quantity.kind == runtime::QuantityKind::kThreadError;
    for (size_t i = 0; i < subject_.threads.size(); ++i) {
      if (subject_.threads[i].thread == quantity.thread) BeginWithLastStepOf(static_cast<int>(i));
    }
  }

  void BeginWithLastStepOf(int thread) {
    for (size_t i = steps_.size(); i-- > 0;) {
      if (steps_[i].thread != thread) continue;
      matters_[i] = true;
      return;
    }
  }

  void Visit(size_t index) {
    const TrailStep& step = steps_[index];
    const LoggedStep& log = step.log;
    const bool controls = log.decides && threads_.contains(step.thread);
    const bool writes = std::ranges::any_of(
        log.writes, [&](const SlotChange& write) { return needed_.contains(KeyOf(write.slot)); });
    if (!matters_[index] && !writes && !controls && !(card_ && log.command)) return;
    matters_[index] = true;
    threads_.insert(step.thread);
    for (const SlotChange& write : log.writes) {
      if (write.before != write.after) needed_.erase(KeyOf(write.slot));
    }
    for (const SlotValue& read : log.reads) needed_.insert(KeyOf(read.slot));
    card_ = card_ || (log.command && writes);
  }

  const Subject& subject_;
  const runtime::Controller& controller_;
  const std::vector<TrailStep>& steps_;
  std::vector<bool> matters_;
  std::set<int> needed_;   ///< slots whose present values matter
  std::set<int> threads_;  ///< with a later step that matters
  bool card_ = false;      ///< the state of the card matters
};

}  // namespace

std::vector<bool> StepsThatMatter(const Subject& subject, const Failure& failure,
                                  const runtime::Controller& controller,
                                  const std::vector<TrailStep>& steps) {
  return BackwardSlice(subject, controller, steps).Of(failure);
}

}  // namespace oncard::explore
