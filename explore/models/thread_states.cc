#include "explore/models/thread_states.h"

#include <algorithm>
#include <span>

namespace oncard::explore {
namespace {

/// Maximum number of different values of all states together.
constexpr size_t kValueMax = size_t{1} << 23;

}  // namespace

ThreadStates::ThreadStates(const Model& model, int64_t statements, size_t state_max)
    : start_(model), scratch_(model), statements_(statements), state_max_(state_max) {
  for (Model* each : {&start_, &scratch_}) {
    each->TrackKey(false);
    each->ForgetSteps();
  }
  for (uint32_t cell = 0; cell < model.global_count(); ++cell) {
    globals_.push_back(model.Global(cell));
  }
  state_nodes_ = static_cast<uint32_t>(model.thread_count());
}

std::optional<ThreadStates::Step> ThreadStates::Begin(int thread) {
  scratch_ = start_;
  const auto statements = FinishStep(thread);
  if (!statements) return std::nullopt;
  const uint32_t state = StateInScratch(thread);
  if (state == kNone) return std::nullopt;
  return Step{.next = state, .statements = static_cast<uint32_t>(*statements)};
}

std::optional<int64_t> ThreadStates::FinishStep(int thread) {
  if (statements_ == kSingleStatements) return 0;
  const int64_t statements = scratch_.StepPrivate(thread, statements_);
  if (statements >= statements_) return std::nullopt;
  scratch_.ForgetDeadLocals(thread);
  return statements;
}

std::span<const int64_t> ThreadStates::CellsOf(uint32_t state) const {
  const size_t count = start_.ThreadCells(states_[state].thread).size();
  return std::span(cells_).subspan(states_[state].cells, count);
}

StateKey ThreadStates::KeyOf(uint32_t state) const {
  uint32_t cell = start_.FirstThreadCell(states_[state].thread);
  StateKey key;
  for (const int64_t value : CellsOf(state)) AddToKey(cell++, value, &key);
  return key;
}

uint32_t ThreadStates::StateInScratch(int thread) {
  const std::span<const int64_t> cells = scratch_.ThreadCells(thread);
  auto node = static_cast<uint32_t>(thread);
  for (const int64_t value : cells) {
    uint32_t next = state_numbers_.Find(node, value);
    if (next == kNone) {
      next = state_nodes_++;
      state_numbers_.Add(node, value, next);
    }
    node = next;
  }
  const uint32_t known = state_numbers_.Find(node, 0);
  if (known != kNone) return known;
  if (states_.size() == state_max_ || state_numbers_.size() > kValueMax) return kNone;
  State state = {.thread = static_cast<uint8_t>(thread),
                 .runs = scratch_.Running(thread),
                 .failed = Fails(scratch_.End(thread)),
                 .cells = static_cast<uint32_t>(cells_.size())};
  if (state.runs) {
    const AccessSet access = scratch_.NextAccess(thread);
    const auto number = NumberOf(access);
    if (!number) return kNone;
    state.access = *number;
    if (access.read_count > 0) {
      state.read = access.read_count == 1 ? access.reads[0] : kReadsSeveral;
      state.steps = step_nodes_++;
    }
  }
  cells_.insert(cells_.end(), cells.begin(), cells.end());
  states_.push_back(state);
  const auto number = static_cast<uint32_t>(states_.size() - 1);
  state_numbers_.Add(node, 0, number);
  return number;
}

std::optional<uint8_t> ThreadStates::NumberOf(const AccessSet& access) {
  const auto known =
      std::ranges::find_if(accesses_, [&](const AccessSet& other) { return other.SameAs(access); });
  if (known != accesses_.end()) return static_cast<uint8_t>(known - accesses_.begin());
  if (accesses_.size() == kAccessMax) return std::nullopt;
  const size_t number = accesses_.size();
  accesses_.push_back(access);
  dependent_.push_back(0);
  const uint32_t written = access.write;
  if (written != AccessSet::kNone && std::ranges::find(written_, written) == written_.end()) {
    written_.push_back(written);
  }
  for (size_t other = 0; other <= number; ++other) {
    if (!access.DependsOn(accesses_[other])) continue;
    dependent_[number] |= uint64_t{1} << other;
    dependent_[other] |= uint64_t{1} << number;
  }
  return static_cast<uint8_t>(number);
}

const ThreadStates::Step* ThreadStates::AddStep(uint32_t state,
                                                const std::vector<int64_t>& globals) {
  const State from = states_[state];
  if (steps_.size() == state_max_) return nullptr;
  const AccessSet access = accesses_[from.access];
  for (uint32_t i = 0; i < access.read_count; ++i) {
    scratch_.SetGlobal(access.reads[i], globals[access.reads[i]]);
  }
  const size_t count = scratch_.ThreadCells(from.thread).size();
  scratch_.SetThreadCells(from.thread, std::span(cells_).subspan(from.cells, count));
  scratch_.Step(from.thread);
  Step step;
  // A statement that fails does so before it writes.
  if (access.write != AccessSet::kNone && !Fails(scratch_.End(from.thread))) {
    step.cell = access.write;
    step.value = scratch_.Global(access.write);
  }
  if (const auto more = FinishStep(from.thread)) {
    step.statements = 1 + static_cast<uint32_t>(*more);
    step.next = StateInScratch(from.thread);
  }
  scratch_.ForgetSteps();
  if (step.next == kNone) return nullptr;
  const auto number = static_cast<uint32_t>(steps_.size());
  steps_.push_back(step);
  if (access.read_count == 0) states_[state].steps = number;
  uint32_t node = from.steps;
  for (uint32_t i = 0; i < access.read_count; ++i) {
    const int64_t value = globals[access.reads[i]];
    const bool last = i + 1 == access.read_count;
    uint32_t next = step_numbers_.Find(node, value);
    if (next == kNone) {
      next = last ? number : step_nodes_++;
      step_numbers_.Add(node, value, next);
    }
    node = next;
  }
  return &steps_.back();
}

void ThreadStates::Load(const std::vector<uint32_t>& states, const std::vector<int64_t>& globals,
                        Model* model) const {
  for (const uint32_t number : states) {
    const State& state = states_[number];
    const size_t count = model->ThreadCells(state.thread).size();
    model->SetThreadCells(state.thread, std::span(cells_).subspan(state.cells, count));
  }
  for (const uint32_t cell : written_) model->SetGlobal(cell, globals[cell]);
}

}  // namespace oncard::explore
