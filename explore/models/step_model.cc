#include "explore/models/step_model.h"

namespace oncard::explore {

bool StepModel::Begin() {
  for (int thread = 0; thread < thread_count(); ++thread) {
    const auto begun = known_.Begin(thread);
    if (!begun || statements_ + begun->statements >= statement_limit_) return false;
    statements_ += begun->statements;
    begun_.push_back(begun->statements);
    now_[Index(thread)] = begun->next;
    if (known_.Runs(begun->next)) runnable_ |= 1u << thread;
  }
  return true;
}

std::vector<uint8_t> StepModel::StatementThreads() const {
  std::vector<uint8_t> threads;
  const auto add = [&](size_t thread, uint32_t statements) {
    threads.insert(threads.end(), statements, static_cast<uint8_t>(thread));
  };
  for (size_t thread = 0; thread < begun_.size(); ++thread) add(thread, begun_[thread]);
  for (const Taken& taken : path_) add(taken.thread, taken.statements);
  return threads;
}

uint32_t StepModel::StateNumber() {
  state_.assign(now_.begin(), now_.end());
  return NumberWithGlobals();
}

uint32_t StepModel::StateNumber(const std::vector<uint32_t>& names) {
  state_.clear();
  for (const uint32_t state : now_) state_.push_back(names[state]);
  return NumberWithGlobals();
}

uint32_t StepModel::NumberWithGlobals() {
  // Globals that no known step writes have their first values.
  for (const uint32_t cell : known_.written()) state_.push_back(globals_[cell]);
  return numbers_.NumberOf(state_);
}

}  // namespace oncard::explore
