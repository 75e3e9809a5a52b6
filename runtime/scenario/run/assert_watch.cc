#include "runtime/scenario/run/assert_watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "runtime/sim/program.h"

namespace oncard::runtime {
namespace {

/// A name of an assert's condition as its source has it.
std::string WrittenName(const vm::Assert& assert, const std::string& name) {
  for (const auto& [lowered, written] : assert.names) {
    const std::string_view rest =
        std::string_view(name).substr(std::min(lowered.size(), name.size()));
    if (name.starts_with(lowered) && (rest.empty() || rest[0] == '.')) {
      return fmt::format("{}{}", written, rest);
    }
  }
  return name;
}

/// The values of what a condition names, by the names that its source uses.
Message ValuesIn(const vm::Assert& assert, const CardCondition& condition,
                 const Controller& controller) {
  const auto& names = condition.condition().names();
  return condition.DescribeValues(controller,
                                  [&](size_t name) { return WrittenName(assert, names[name]); });
}

}  // namespace

std::vector<Requirement> AssertsOf(const vm::Object& object, const std::string& program_path) {
  std::vector<Requirement> asserts;
  for (const vm::Function& function : object.functions) {
    for (const vm::Assert& each : function.asserts) {
      Requirement& requirement = asserts.emplace_back();
      requirement.scope = Scope::kAssert;
      requirement.text = each.condition;
      requirement.written = each.written;
      requirement.at = SourcePlace(program_path, function, each.position);
    }
  }
  return asserts;
}

bool HasAsserts(const vm::Object& object) {
  return std::ranges::any_of(
      object.functions, [](const vm::Function& function) { return !function.asserts.empty(); });
}

Message Describe(const FailedAssert& failed, const Requirement& requirement) {
  const Message& values = failed.values;
  Message text = MakeMessage("does not hold at {0} in thread {1}", "在 {0} 处（线程 {1}）不成立",
                             requirement.at, failed.thread);
  if (values.en.empty()) return text;
  return {fmt::format("{}: {}", text.en, values.en), fmt::format("{}：{}", text.zh, values.zh)};
}

Message DescribeUntestedAssert(const Requirement& requirement) {
  return MakeMessage("'{0}' was never tested: no thread executed {1}",
                     "“{0}”从未检查：没有线程执行 {1}", requirement.Title(), requirement.at);
}

void AssertWatch::Begin(const Controller& controller, ScenarioErrors* errors) {
  image_ = controller.machine().shared_image();
  const std::vector<vm::Function>& functions = image_->object.functions;
  asserts_ = AssertsOf(image_->object, program_path_);
  reached_.assign(asserts_.size(), false);
  first_.clear();
  bound_ = {};
  size_t first = 0;
  for (const vm::Function& function : functions) {
    first_.push_back(first);
    first += function.asserts.size();
  }
  if (empty()) return;
  std::vector<std::optional<Message>> wrong(asserts_.size());
  for (size_t i = 0; i < asserts_.size(); ++i) {
    const auto condition = ParseCondition(asserts_[i].text);
    if (!condition.ok()) wrong[i] = condition.error().message;
  }
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const vm::ThreadState& thread = controller.machine().thread(number);
    if (thread.run == vm::ThreadRun::kUnbound) continue;
    const std::vector<vm::Assert>& own = functions[thread.function].asserts;
    for (size_t i = 0; i < own.size(); ++i) {
      std::optional<Message>& why = wrong[first_[thread.function] + i];
      if (why) continue;
      const auto bound = CardCondition::ReadInThread(own[i].condition, number, controller);
      if (!bound.ok()) why = bound.error().message;
    }
  }
  for (size_t i = 0; i < asserts_.size(); ++i) {
    if (!wrong[i]) continue;
    errors->AddText({}, fmt::format("{}: {}", asserts_[i].at, asserts_[i].Title()), *wrong[i]);
  }
  Remember(controller);
}

const AssertWatch::Bound& AssertWatch::BoundOf(const Controller& controller, int thread) {
  const vm::ThreadState& state = controller.machine().thread(thread);
  std::optional<Bound>& bound = bound_[static_cast<size_t>(thread)];
  if (bound && bound->function == state.function && bound->page == state.page) return *bound;
  bound = Bound{state.function, state.page};
  for (const vm::Assert& each : image_->object.functions[state.function].asserts) {
    std::optional<CardCondition>& condition = bound->conditions.emplace_back();
    auto read = CardCondition::ReadInThread(each.condition, thread, controller);
    if (read.ok()) condition = std::move(read).value();
  }
  return *bound;
}

AssertWatch::Ahead AssertWatch::Look(const Controller& controller, int thread) {
  const vm::ThreadState& state = controller.machine().thread(thread);
  Ahead ahead = {state.executed};
  const bool runs = state.run == vm::ThreadRun::kRunning;
  if (!runs || controller.machine().image() != image_.get()) return ahead;
  const std::vector<vm::Assert>& own = image_->object.functions[state.function].asserts;
  for (size_t i = 0; i < own.size(); ++i) {
    if (own[i].position != state.pc) continue;
    const size_t number = first_[state.function] + i;
    if (ahead.end == 0) ahead.begin = number;
    ahead.end = number + 1;
    const std::optional<CardCondition>& condition = BoundOf(controller, thread).conditions[i];
    if (ahead.failed || !condition || condition->Holds(controller)) continue;
    ahead.failed = {number, thread, ValuesIn(own[i], *condition, controller)};
  }
  return ahead;
}

void AssertWatch::NoteReached(const Ahead& ahead) {
  for (size_t i = ahead.begin; i < ahead.end; ++i) reached_[i] = true;
}

void AssertWatch::Include(const AssertWatch& other) {
  for (size_t i = 0; i < reached_.size(); ++i) reached_[i] = reached_[i] || other.reached_[i];
}

std::optional<FailedAssert> AssertWatch::BeforeStatement(const Controller& controller, int thread) {
  if (empty()) return std::nullopt;
  Ahead ahead = Look(controller, thread);
  NoteReached(ahead);
  return std::move(ahead.failed);
}

std::vector<FailedAssert> AssertWatch::AfterStatements(const Controller& controller) {
  std::vector<FailedAssert> failed;
  if (empty()) return failed;
  for (int thread = 0; thread < vm::kThreadCount; ++thread) {
    Ahead& before = ahead_[static_cast<size_t>(thread)];
    if (controller.machine().thread(thread).executed != before.executed + 1) continue;
    NoteReached(before);
    if (before.failed) failed.push_back(*std::move(before.failed));
  }
  Remember(controller);
  return failed;
}

void AssertWatch::Remember(const Controller& controller) {
  if (empty()) return;
  for (int thread = 0; thread < vm::kThreadCount; ++thread) {
    ahead_[static_cast<size_t>(thread)] = Look(controller, thread);
  }
}

std::vector<Message> AssertWatch::DescribeUntested() const {
  std::vector<Message> texts;
  for (size_t i = 0; i < asserts_.size(); ++i) {
    if (!reached_[i]) texts.push_back(DescribeUntestedAssert(asserts_[i]));
  }
  return texts;
}

}  // namespace oncard::runtime
