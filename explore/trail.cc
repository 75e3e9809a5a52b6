#include "explore/trail.h"

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
  const auto follow = [&](const std::vector<uint8_t>& threads, std::vector<TrailStep>* steps) {
    for (const uint8_t thread : threads) {
      const int line = model.Line(thread);
      model.Step(thread);
      steps->push_back({.thread = thread, .line = line, .written = model.LastWrite()});
    }
  };
  follow(failure.steps, &trail.steps);
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
