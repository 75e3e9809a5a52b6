// The scheduler policies. Random numbers come from SplitMix64 (Steele, Lea and Flood, OOPSLA 2014):
// one 64-bit word of state, the same sequence everywhere.
// Tested by tests/vm/scheduler_test.cc.
#include "vm/scheduler.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "base/number.h"
#include "base/random.h"
#include "vm/schedule.h"

namespace oncard::vm {
namespace {

constexpr int64_t kQuantumMax = 1'000'000'000;
constexpr int64_t kPctStepsMax = 1'000'000'000'000;

// The first runnable thread at or after `first`, wrapping around after the last one.
int FirstRunnable(uint32_t runnable, int first) {
  const uint32_t later = runnable & (~uint32_t{0} << first);
  return std::countr_zero(later != 0 ? later : runnable);
}

bool Contains(uint32_t mask, int thread) { return (mask >> thread & 1) != 0; }

Turn RoundRobinTurn(SchedulerState& state, uint32_t runnable, int64_t budget) {
  if (state.turn_left > 0 && !Contains(runnable, state.next_thread)) {
    state.next_thread = (state.next_thread + 1) % kThreadCount;
    state.turn_left = 0;
  }
  if (state.turn_left == 0) {
    state.next_thread = FirstRunnable(runnable, state.next_thread);
    state.turn_left = state.policy.quantum;
  }
  return {state.next_thread, std::min(state.turn_left, budget)};
}

Turn PriorityTurn(const SchedulerState& state, uint32_t runnable,
                  const std::array<int16_t, kThreadCount>& priorities) {
  int16_t best = INT16_MAX;
  for (uint32_t rest = runnable; rest != 0; rest &= rest - 1) {
    best = std::min(best, priorities[static_cast<size_t>(std::countr_zero(rest))]);
  }
  uint32_t urgent = 0;
  for (uint32_t rest = runnable; rest != 0; rest &= rest - 1) {
    const int thread = std::countr_zero(rest);
    if (priorities[static_cast<size_t>(thread)] == best) urgent |= uint32_t{1} << thread;
  }
  return {FirstRunnable(urgent, state.next_thread), 1};
}

Turn ReplayTurn(const SchedulerState& state, uint32_t runnable, int64_t budget) {
  const auto& segments = state.policy.schedule->segments;
  if (state.segment >= segments.size()) return {};
  const ScheduleSegment& segment = segments[state.segment];
  if (!Contains(runnable, segment.thread)) return {};
  return {segment.thread, std::min(segment.statements - state.segment_done, budget)};
}

void EndReplayTurn(SchedulerState& state, int64_t statements) {
  state.segment_done += statements;
  if (state.segment_done == state.policy.schedule->segments[state.segment].statements) {
    ++state.segment;
    state.segment_done = 0;
  }
}

void StartPct(SchedulerState& state) {
  // Priorities depth .. depth+31 in a random order; the i-th change point lowers one to i.
  for (int i = 0; i < kThreadCount; ++i) {
    state.pct_priority[static_cast<size_t>(i)] = state.policy.depth + i;
  }
  for (size_t i = kThreadCount - 1; i > 0; --i) {
    const auto other = static_cast<size_t>(RandomBelow(state.random, i + 1));
    std::swap(state.pct_priority[i], state.pct_priority[other]);
  }
  const size_t points = static_cast<size_t>(state.policy.depth - 1);
  for (size_t i = 0; i < points; ++i) {
    state.pct_points[i] = 1 + static_cast<int64_t>(RandomBelow(
                                  state.random, static_cast<uint64_t>(state.policy.steps)));
  }
  std::sort(state.pct_points.begin(), state.pct_points.begin() + static_cast<ptrdiff_t>(points));
}

void EndPctTurn(SchedulerState& state, int thread, int64_t statements) {
  for (int64_t i = 0; i < statements; ++i) {
    ++state.pct_executed;
    for (int point = 0; point < state.policy.depth - 1; ++point) {
      if (state.pct_points[static_cast<size_t>(point)] == state.pct_executed) {
        state.pct_priority[static_cast<size_t>(thread)] = point;
      }
    }
  }
}

// --- Policy names --------------------------------------------------------------------------------

std::vector<std::string_view> SplitColons(std::string_view text) {
  std::vector<std::string_view> parts;
  for (size_t colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':')) {
    parts.push_back(text.substr(0, colon));
    text.remove_prefix(colon + 1);
  }
  parts.push_back(text);
  return parts;
}

template <typename Number>
std::optional<Number> ParseNumber(std::string_view text, Number minimum, Number maximum) {
  const auto value = ReadWhole<Number>(text);
  return value && (*value < minimum || *value > maximum) ? std::nullopt : value;
}

std::optional<Policy> ParseParts(const std::vector<std::string_view>& parts) {
  Policy policy;
  const std::string_view name = parts[0];
  if (name == "rr" && parts.size() <= 2) {
    policy.kind = PolicyKind::kRoundRobin;
    if (parts.size() == 1) return policy;
    const auto quantum = ParseNumber<int64_t>(parts[1], 1, kQuantumMax);
    if (!quantum) return std::nullopt;
    policy.quantum = *quantum;
    return policy;
  }
  if (name == "priority" && parts.size() == 1) {
    policy.kind = PolicyKind::kPriority;
    return policy;
  }
  if (name == "random" && parts.size() == 2) {
    policy.kind = PolicyKind::kRandom;
    const auto seed = ParseNumber<uint64_t>(parts[1], 0, UINT64_MAX);
    if (!seed) return std::nullopt;
    policy.seed = *seed;
    return policy;
  }
  if (name == "pct" && (parts.size() == 3 || parts.size() == 4)) {
    policy.kind = PolicyKind::kPct;
    const auto seed = ParseNumber<uint64_t>(parts[1], 0, UINT64_MAX);
    const auto depth = ParseNumber<int>(parts[2], 1, kPctDepthMax);
    const auto steps = parts.size() == 4 ? ParseNumber<int64_t>(parts[3], 1, kPctStepsMax)
                                         : std::optional<int64_t>(policy.steps);
    if (!seed || !depth || !steps) return std::nullopt;
    policy.seed = *seed;
    policy.depth = *depth;
    policy.steps = *steps;
    return policy;
  }
  return std::nullopt;
}

}  // namespace

Result<Policy> ParsePolicy(std::string_view text) {
  if (auto policy = ParseParts(SplitColons(text))) return *policy;
  return MakeError(1,
                   "'{0}' is not a schedule policy; write rr, rr:N, priority, random:SEED, "
                   "pct:SEED:DEPTH or pct:SEED:DEPTH:STEPS (N up to {1}, DEPTH up to {2})",
                   "“{0}”不是调度策略；应写 rr、rr:N、priority、random:种子、"
                   "pct:种子:深度 或 pct:种子:深度:步数（N 不超过 {1}，深度不超过 {2}）",
                   text, kQuantumMax, kPctDepthMax);
}

std::string FormatPolicy(const Policy& policy) {
  switch (policy.kind) {
    case PolicyKind::kRoundRobin:
      return policy.quantum == 1 ? "rr" : fmt::format("rr:{}", policy.quantum);
    case PolicyKind::kPriority:
      return "priority";
    case PolicyKind::kRandom:
      return fmt::format("random:{}", policy.seed);
    case PolicyKind::kPct:
      return fmt::format("pct:{}:{}:{}", policy.seed, policy.depth, policy.steps);
    case PolicyKind::kReplay:
      break;
  }
  return "replay";
}

SchedulerState StartPolicy(const Policy& policy) {
  SchedulerState state;
  state.policy = policy;
  state.random = policy.seed;
  if (policy.kind == PolicyKind::kPct) StartPct(state);
  return state;
}

Turn BeginTurn(SchedulerState& state, uint32_t runnable, int64_t budget,
               const std::array<int16_t, kThreadCount>& priorities) {
  switch (state.policy.kind) {
    case PolicyKind::kRoundRobin:
      return RoundRobinTurn(state, runnable, budget);
    case PolicyKind::kPriority:
      return PriorityTurn(state, runnable, priorities);
    case PolicyKind::kRandom:
      return {RandomThread(state.random, runnable), 1};
    case PolicyKind::kPct:
      return {HighestThread(runnable, state.pct_priority), 1};
    case PolicyKind::kReplay:
      break;
  }
  return ReplayTurn(state, runnable, budget);
}

void EndTurn(SchedulerState& state, int thread, int64_t statements, bool yielded) {
  switch (state.policy.kind) {
    case PolicyKind::kRoundRobin:
      state.turn_left -= statements;
      if (state.turn_left == 0 || yielded) {
        state.next_thread = (thread + 1) % kThreadCount;
        state.turn_left = 0;
      }
      break;
    case PolicyKind::kPriority:
      state.next_thread = (thread + 1) % kThreadCount;
      break;
    case PolicyKind::kRandom:
      break;
    case PolicyKind::kPct:
      EndPctTurn(state, thread, statements);
      break;
    case PolicyKind::kReplay:
      EndReplayTurn(state, statements);
      break;
  }
}

}  // namespace oncard::vm
