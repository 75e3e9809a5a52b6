#include "explore/trail.h"

#include <utility>

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
  int position = 0;
  AccessSet access;
};

Race PairOf(const Touch& one, const Touch& other) {
  if (one.thread == other.thread || !one.access.DependsOn(other.access)) return {};
  const bool writes =
      one.access.write != AccessSet::kNone && other.access.Touches(one.access.write);
  const uint32_t cell = writes ? one.access.write : other.access.write;
  return {cell,
          {one.thread, one.position, one.access.write == cell},
          {other.thread, other.position, other.access.write == cell}};
}

/// A statement with the nearest one that it depends on, the earlier ones first.
Race PairOf(const std::vector<Touch>& touches, size_t statement) {
  if (statement >= touches.size()) return {};
  for (size_t i = statement; i-- > 0;) {
    if (const Race pair = PairOf(touches[i], touches[statement])) return pair;
  }
  for (size_t i = statement + 1; i < touches.size(); ++i) {
    if (const Race pair = PairOf(touches[statement], touches[i])) return pair;
  }
  return {};
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
      touches.push_back({thread, model.Position(thread), model.NextAccess(thread)});
      model.Step(thread);
      step.written = model.LastWrite();
      // Also the value that was there.
      const uint32_t written = touches.back().access.write;
      if (step.written.empty() && written != AccessSet::kNone) {
        step.written = model.DescribeShared(written);
      }
      steps->push_back(std::move(step));
    }
  };
  follow(failure.steps, &trail.steps);
  if (failure.last_escape >= 0) {
    trail.pair = PairOf(touches, static_cast<size_t>(failure.last_escape));
  }
  follow(failure.cycle, &trail.cycle);
  return trail;
}

Trail Follow(CardModel* model, const Failure& failure) {
  Trail trail;
  CardModel::State state = model->Start();
  for (const uint8_t thread : failure.steps) {
    model->Load(state);
    const vm::MachineState before = model->controller().machine().state();
    const int line = model->controller().machine().Line(model->setup(thread).thread);
    const double at_ms = model->controller().NowMs();
    state = model->Step(state, thread);
    trail.steps.push_back({.thread = thread,
                           .line = line,
                           .written = Written(*model, thread, before),
                           .at_ms = at_ms});
  }
  return trail;
}

}  // namespace oncard::explore
