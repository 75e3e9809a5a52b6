#include "explore/trail.h"

#include <algorithm>
#include <utility>

#include "explore/statement_access.h"

namespace oncard::explore {
namespace {

/// What a statement of a thread changed among the globals and the variables of its page.
std::string Written(const CardModel& model, int thread, const vm::MachineState& before) {
  const vm::MachineState& after = model.controller().machine().state();
  const ThreadSetup& setup = model.setup(thread);
  const vm::Object& object = model.image()->object;
  for (uint32_t id = 0; id < vm::kSlotCount; ++id) {
    if (before.globals[id] == after.globals[id]) continue;
    return DescribeSlot(object.globals, id, after.globals[id]);
  }
  const auto page = static_cast<size_t>(setup.page);
  for (uint32_t id = 0; id < vm::kSlotCount; ++id) {
    if (before.pages[page][id] == after.pages[page][id]) continue;
    const auto function = static_cast<size_t>(setup.function);
    return DescribeSlot(object.functions[function].variables, id, after.pages[page][id]);
  }
  return {};
}

/// A statement of a schedule and what it touched.
struct Touch {
  int thread = 0;
  StatementAccess access;
};

/// The same, of a program without a card.
StatementAccess GeneralAccess(const AccessSet& access) {
  StatementAccess general;
  for (uint32_t i = 0; i < access.read_count; ++i) {
    general.push_back({gtcalls::Resource::kVariable, access.reads[i], false});
  }
  if (access.write != AccessSet::kNone) {
    general.push_back({gtcalls::Resource::kVariable, access.write, true});
  }
  return general;
}

bool Writes(const StatementAccess& access, const Touched& touched) {
  return std::ranges::any_of(access, [&](const Touched& each) {
    return each.write && each.resource == touched.resource &&
           (each.number == touched.number || each.number == Touched::kAll);
  });
}

/// A statement with the nearest one of another thread that depends on it: a later one, which the
/// other order would have taken first, or else an earlier one.
std::optional<RacingPair> PairOf(const std::vector<Touch>& touches, int64_t last_escape,
                                 const vm::Object& object) {
  const auto statement = static_cast<size_t>(last_escape);
  if (last_escape < 0 || statement >= touches.size()) return std::nullopt;
  const Touch& fatal = touches[statement];
  const auto pair_with = [&](size_t other) -> std::optional<RacingPair> {
    if (touches[other].thread == fatal.thread) return std::nullopt;
    const Touched* both = FindDependence(fatal.access, touches[other].access);
    if (both == nullptr) return std::nullopt;
    const auto [first, second] = std::minmax(statement, other);
    return RacingPair{NameOf(*both, object),
                      {first, Writes(touches[first].access, *both)},
                      {second, Writes(touches[second].access, *both)}};
  };
  for (size_t i = statement + 1; i < touches.size(); ++i) {
    if (auto pair = pair_with(i)) return pair;
  }
  for (size_t i = statement; i-- > 0;) {
    if (auto pair = pair_with(i)) return pair;
  }
  return std::nullopt;
}

}  // namespace

Subject SubjectOf(const Problem& problem) {
  Subject subject;
  for (int i = 0; i < problem.model.thread_count(); ++i) {
    subject.threads.push_back(problem.model.setup(i));
  }
  subject.image = problem.model.shared_image();
  for (const BoundRequirement& bound : problem.requirements) {
    subject.requirements.push_back({bound.scope, bound.property.text()});
  }
  return subject;
}

Subject SubjectOf(const CardModel& model) {
  return {model.setups(), model.image(), model.Requirements()};
}

Trail Follow(const Problem& problem, const Failure& failure) {
  Trail trail;
  Model model = problem.model;
  std::vector<Touch> touches;
  const auto follow = [&](const std::vector<uint8_t>& threads, std::vector<TrailStep>* steps) {
    for (const uint8_t thread : threads) {
      TrailStep step = {.thread = thread, .line = model.Line(thread)};
      step.read = model.NextReads(thread);
      const AccessSet access = model.NextAccess(thread);
      touches.push_back({thread, GeneralAccess(access)});
      model.Step(thread);
      step.written = model.LastWrite();
      // Also the value that was there.
      const uint32_t written = access.write;
      if (step.written.empty() && written != AccessSet::kNone) {
        step.written = model.DescribeShared(written);
      }
      steps->push_back(std::move(step));
    }
  };
  follow(failure.steps, &trail.steps);
  trail.pair = PairOf(touches, failure.last_escape, problem.model.image().object);
  follow(failure.cycle, &trail.cycle);
  return trail;
}

Trail Follow(CardModel* model, const Failure& failure) {
  Trail trail;
  std::vector<Touch> touches;
  CardModel::State state = model->Start();
  for (const uint8_t thread : failure.steps) {
    model->Load(state);
    touches.push_back({thread, NextAccess(model->controller(), model->setup(thread).thread)});
    const vm::MachineState before = model->controller().machine().state();
    const int line = model->controller().machine().Line(model->setup(thread).thread);
    const double at_ms = model->controller().NowMs();
    state = model->Step(state, thread);
    trail.steps.push_back({.thread = thread,
                           .line = line,
                           .written = Written(*model, thread, before),
                           .at_ms = at_ms});
  }
  trail.pair = PairOf(touches, failure.last_escape, model->image()->object);
  return trail;
}

}  // namespace oncard::explore
