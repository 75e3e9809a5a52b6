#include "explore/reports/race_orders.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>
#include <utility>

#include "runtime/observe/quantity.h"

namespace oncard::explore {
namespace {

/// Maximum number of statements until all threads should have ended, and how many consecutive ones
/// a thread may take: a thread that waits in a loop must let the others continue.
constexpr int64_t kStepMax = 100'000;
constexpr int64_t kTurnMax = 1000;
/// So many statements of an order are shown after the racing ones.
constexpr size_t kFollowingMax = 500;

/// The result of an order: what the racing statements read (`[y = 0]`) and write, and the end.
struct Outcome {
  std::string after;
  std::vector<std::string> names;
  std::vector<std::string> values;
  std::vector<uint8_t> schedule;
};

std::vector<vm::SlotAddress> Globals(const vm::Object& object) {
  std::vector<vm::SlotAddress> slots;
  for (const vm::Symbol& symbol : object.globals) {
    for (int i = 0; i < symbol.slots(); ++i) {
      slots.push_back({true, 0, static_cast<uint16_t>(symbol.id + i), symbol.type});
    }
  }
  return slots;
}

/// Notes the first statements.
void RunToEnd(Model* model, std::vector<uint8_t>* schedule) {
  const size_t shown = schedule->size() + kFollowingMax;
  int64_t turn = 0;
  int last = -1;
  for (int64_t i = 0; i < kStepMax && model->runnable() != 0; ++i) {
    const uint32_t runnable = model->runnable();
    if (last < 0 || (runnable >> last & 1) == 0 || ++turn >= kTurnMax) {
      const uint32_t behind = last < 0 ? runnable : runnable & (~uint32_t{1} << last);
      last = std::countr_zero(behind != 0 ? behind : runnable);
      turn = 0;
    }
    model->Step(last);
    if (schedule->size() < shown) schedule->push_back(static_cast<uint8_t>(last));
  }
}

std::string ResultText(const Model& model, int thread) {
  const auto function = static_cast<size_t>(model.setup(thread).function);
  const vm::DataType type = model.image().object.functions[function].return_type;
  const int64_t raw = model.ReturnValue(thread);
  const double value = type == vm::DataType::kDouble
                           ? vm::DoubleFromFixed(raw)
                           : static_cast<double>(static_cast<int32_t>(raw));
  return runtime::FormatNumber(value, runtime::FormOf(type));
}

/// Executes the steps and continues to the end. Empty if a thread cannot execute its statement.
std::optional<Outcome> Take(const Problem& problem, const std::vector<uint8_t>& steps,
                            const Race& race) {
  Model model = problem.model;
  const vm::Object& object = model.image().object;
  const runtime::LoggedStep global;
  vm::SlotAddress cell;
  for (const vm::SlotAddress& slot : Globals(object)) {
    if (slot.id == race.cell) cell = slot;
  }
  const auto present = [&] {
    return NameOf(global, cell, object) + " = " + ValueText(global, cell, model.Read(cell), object);
  };
  std::array<std::string, 2> reads;
  for (const uint8_t thread : steps) {
    if ((model.runnable() >> thread & 1) == 0) return std::nullopt;
    for (size_t i = 0; i < reads.size(); ++i) {
      const RacingStatement& statement = i == 0 ? race.first : race.second;
      const bool here = statement.thread == thread && statement.position == model.Position(thread);
      if (here && !statement.writes) reads[i] = '[' + present() + "] ";
    }
    model.Step(thread);
  }
  Outcome outcome;
  outcome.after = reads[0] + reads[1] + present();
  outcome.schedule = steps;
  RunToEnd(&model, &outcome.schedule);
  for (const vm::SlotAddress& slot : Globals(object)) {
    outcome.names.push_back(NameOf(global, slot, object));
    outcome.values.push_back(ValueText(global, slot, model.Read(slot), object));
  }
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    outcome.names.push_back(fmt::format("thread{}.result", model.setup(thread).thread));
    outcome.values.push_back(ResultText(model, thread));
  }
  return outcome;
}

std::string Differences(const Outcome& outcome, const Outcome& other) {
  std::string text;
  for (size_t i = 0; i < outcome.values.size(); ++i) {
    if (outcome.values[i] == other.values[i]) continue;
    if (!text.empty()) text += ", ";
    text += outcome.names[i] + " = " + outcome.values[i];
  }
  return text;
}

}  // namespace

std::vector<RaceOrder> BothOrders(const Problem& problem, const Failure& failure) {
  if (failure.fault.kind != Fault::Kind::kRace) return {};
  const Race& race = failure.fault.race;
  // The positions of the two statements in the run.
  int64_t first = -1;
  int64_t second = -1;
  Model model = problem.model;
  for (size_t i = 0; i < failure.steps.size(); ++i) {
    const uint8_t thread = failure.steps[i];
    const int position = model.Position(thread);
    const auto is = [&](const RacingStatement& statement) {
      return statement.thread == thread && statement.position == position;
    };
    if (is(race.first)) first = static_cast<int64_t>(i);
    if (is(race.second)) second = static_cast<int64_t>(i);
    model.Step(thread);
  }
  if (first < 0 || second < 0) return {};
  const auto [earlier, later] = std::minmax(first, second);
  const uint8_t held = failure.steps[static_cast<size_t>(earlier)];
  const uint8_t ahead = failure.steps[static_cast<size_t>(later)];
  const std::vector<uint8_t> as_run(failure.steps.begin(),
                                    failure.steps.begin() + static_cast<std::ptrdiff_t>(later) + 1);
  // The thread that was first waits before its statement until the other has executed its own.
  std::vector<uint8_t> other(failure.steps.begin(),
                             failure.steps.begin() + static_cast<std::ptrdiff_t>(earlier));
  for (int64_t i = earlier + 1; i <= later; ++i) {
    const uint8_t thread = failure.steps[static_cast<size_t>(i)];
    if (thread != held) other.push_back(thread);
  }
  other.push_back(held);
  const auto one = Take(problem, as_run, race);
  const auto two = Take(problem, other, race);
  if (!one || !two) return {};
  // In the other order both statements are the last ones of what was arranged.
  const size_t length = other.size();
  return {{problem.model.setup(held).thread,
           one->after,
           Differences(*one, *two),
           one->schedule,
           {static_cast<size_t>(earlier), static_cast<size_t>(later)}},
          {problem.model.setup(ahead).thread,
           two->after,
           Differences(*two, *one),
           two->schedule,
           {length - 2, length - 1}}};
}

}  // namespace oncard::explore
