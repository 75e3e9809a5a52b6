#include "runtime/scenario/run/scenario_start.h"

#include <fmt/format.h>

#include "base/nearest.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/run/reaction_conditions.h"
#include "runtime/scenario/run/scenario_card.h"

namespace oncard::runtime {

Result<int> FunctionIndex(const std::string& name, const vm::Image& image) {
  const int index = vm::FindFunction(image, name);
  if (index >= 0) return index;
  std::vector<std::string_view> names;
  for (const vm::Function& function : image.object.functions) names.push_back(function.name);
  const std::string_view near = NearestName(name, names);
  if (near.empty()) {
    return MakeError(1, "the program has no function '{0}': it has {1}",
                     "程序中没有函数“{0}”：只有 {1}", name, fmt::to_string(fmt::join(names, ", ")));
  }
  return MakeError(1, "the program has no function '{0}'; did you mean '{1}'?",
                   "程序中没有函数“{0}”；是否为“{1}”？", name, near);
}

namespace {

/// The threads of the scenario, or the default thread if it names none.
Result<std::vector<ThreadStart>> ThreadsOf(const Scenario& scenario, const vm::Image& image) {
  if (!scenario.threads.empty()) return scenario.threads;
  if (image.object.functions.empty()) {
    return MakeError(1, "the program has no function to run", "程序中没有可运行的函数");
  }
  ThreadStart start;
  start.function = vm::FindFunction(image, "main") >= 0 ? "main" : image.object.functions[0].name;
  return std::vector{std::move(start)};
}

/// Binds the threads and returns those that could be bound.
std::vector<ThreadStart> BindThreads(const std::vector<ThreadStart>& starts, vm::Machine* machine,
                                     ScenarioErrors* errors) {
  std::vector<ThreadStart> bound;
  for (const ThreadStart& start : starts) {
    const auto function = FunctionIndex(start.function, *machine->image());
    if (!function.ok()) {
      errors->Add(start.function_place, function.error().message);
    } else if (machine->Bind(start.thread, function.value() + 1, start.page) != vm::kOk) {
      errors->Add(
          start.page_place,
          MakeMessage("thread {0} cannot have page {1}: another thread has it",
                      "线程 {0} 不能使用数据页 {1}：已被其它线程占用", start.thread, start.page));
    } else {
      bound.push_back(start);
      continue;
    }
    errors->MissThread();
  }
  return bound;
}

void SetValue(const InitialValue& initial, const std::string& name, Controller* controller,
              ScenarioErrors* errors) {
  if (!errors->CanJudge(initial.name)) return;
  const auto set = SetVariable(initial, name, controller);
  if (!set.ok()) errors->Add(initial.place, set.error().message);
}

void SetValues(const Scenario& scenario, const std::vector<ThreadStart>& starts,
               Controller* controller, ScenarioErrors* errors) {
  for (const InitialValue& initial : scenario.globals) {
    SetValue(initial, initial.name, controller, errors);
  }
  for (const ThreadStart& start : starts) {
    for (const InitialValue& initial : start.values) {
      SetValue(initial, fmt::format("page{}.{}", start.page, initial.name), controller, errors);
    }
  }
}

void RunThreads(const std::vector<ThreadStart>& starts, Controller* controller,
                ScenarioErrors* errors) {
  vm::Machine& machine = controller->machine();
  for (const ThreadStart& start : starts) {
    const int64_t period = controller->clock().CyclesIn(start.period_ms * 1000);
    const int16_t code = period == 0 ? machine.Run(start.thread)
                                     : machine.RunPeriodic(start.thread, period,
                                                           static_cast<int16_t>(start.priority));
    if (code != vm::kOk) {
      errors->Add(start.function_place,
                  MakeMessage("thread {0} cannot be started: code {1}",
                              "线程 {0} 无法启动：返回值 {1}", start.thread, code));
    }
  }
}

}  // namespace

Result<void> StartScenario(const Scenario& scenario, vm::Object object, Controller* controller,
                           ScenarioErrors* errors) {
  if (auto loaded = controller->Load(std::move(object)); !loaded.ok()) return loaded.error();
  ApplyWorld(scenario, controller);
  vm::Machine& machine = controller->machine();
  const auto starts = ThreadsOf(scenario, *machine.image());
  if (!starts.ok()) return starts.error();
  const std::vector<ThreadStart> bound = BindThreads(starts.value(), &machine, errors);
  SetValues(scenario, bound, controller, errors);
  RunThreads(bound, controller, errors);
  CheckReactions(scenario, *controller, 0, {}, errors);
  return {};
}

Result<void> StartScenario(const Scenario& scenario, vm::Object object, Controller* controller) {
  ScenarioErrors errors;
  if (auto started = StartScenario(scenario, std::move(object), controller, &errors);
      !started.ok()) {
    return started;
  }
  if (auto failure = errors.Failure()) return *std::move(failure);
  return {};
}

Result<vm::Policy> FollowSchedule(std::shared_ptr<const vm::Schedule> schedule,
                                  const vm::Image& image) {
  if (schedule->program_hash != image.hash) {
    return MakeError(1,
                     "the schedule was recorded with another program: its hash is {0:016x}, "
                     "this one's {1:016x}",
                     "该调度是用另一个程序录制的：其散列值为 {0:016x}，此程序为 {1:016x}",
                     schedule->program_hash, image.hash);
  }
  vm::Policy policy;
  policy.kind = vm::PolicyKind::kReplay;
  policy.schedule = std::move(schedule);
  return policy;
}

Result<std::vector<Quantity>> SetVariable(const InitialValue& initial, const std::string& name,
                                          Controller* controller) {
  auto slots = ResolveQuantity(name, *controller);
  if (!slots.ok()) return slots;
  for (const Quantity& slot : slots.value()) {
    if (slot.kind != QuantityKind::kVariable) {
      return MakeError(1, "'{0}' is not a variable of the program", "“{0}”不是程序的变量", name);
    }
  }
  if (initial.values.size() > slots.value().size()) {
    return MakeError(1, "'{0}' takes {1} values, not {2}", "“{0}”可放 {1} 个值，而不是 {2} 个",
                     name, slots.value().size(), initial.values.size());
  }
  if (initial.last && slots.value().size() > 1) {
    return MakeError(1, "'{0}' is an array: choose for one of its elements, such as '{1}'",
                     "“{0}”是数组：应为其中一个元素作选择，如“{1}”", name,
                     slots.value().front().name);
  }
  const auto write = [&](const Quantity& slot, double value) -> Result<void> {
    if (controller->machine().Write(slot.slot, value)) return {};
    return MakeError(1, "{0} does not fit '{1}'", "{0} 超出“{1}”的范围", value, slot.name);
  };
  if (initial.last) {
    const auto last = write(slots.value().front(), static_cast<double>(*initial.last));
    if (!last.ok()) return last.error();
  }
  for (size_t i = 0; i < initial.values.size(); ++i) {
    const auto written = write(slots.value()[i], initial.values[i]);
    if (!written.ok()) return written.error();
  }
  return slots;
}

}  // namespace oncard::runtime
