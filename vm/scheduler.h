// Which thread executes the next statement. A policy is chosen per run; its whole state is a value
// in the machine's state, so that a snapshot holds it and the machine stays a pure function of
// (program, initial values, policy, inputs).
//
//   rr[:N]          round robin in thread order, N statements a turn (default 1)
//   priority        the runnable thread with the smallest priority number; equals take turns
//   random:SEED     each statement a thread drawn uniformly from the runnable ones
//   pct:SEED:D[:K]  probabilistic concurrency testing (Burckhardt et al., ASPLOS 2010): random
//                   thread priorities, lowered at D-1 random points among the first K statements
//                   (default 1000)
//   replay          the threads of a recorded schedule (schedule.h)
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "vm/limits.h"
#include "vm/thread_choice.h"

namespace oncard::vm {

struct Schedule;

enum class PolicyKind : uint8_t { kRoundRobin, kPriority, kRandom, kPct, kReplay };

/// A policy as the user names it.
struct Policy {
  PolicyKind kind = PolicyKind::kRoundRobin;
  int64_t quantum = 1;                       ///< kRoundRobin: 1..1 000 000 000
  uint64_t seed = 0;                         ///< kRandom, kPct
  int depth = 1;                             ///< kPct: D, 1..64
  int64_t steps = 1000;                      ///< kPct: K
  std::shared_ptr<const Schedule> schedule;  ///< kReplay
};

/// Reads `rr`, `rr:N`, `priority`, `random:SEED`, `pct:SEED:D` or `pct:SEED:D:K`. A `replay:FILE`
/// is not accepted here: the caller loads the file and fills in the schedule.
Result<Policy> ParsePolicy(std::string_view text);

/// The text that ParsePolicy() reads; `replay` for a replayed schedule.
std::string FormatPolicy(const Policy& policy);

/// The state of a policy in the middle of a run.
struct SchedulerState {
  Policy policy;
  int next_thread = 0;    ///< kRoundRobin, kPriority: first candidate of the next turn
  int64_t turn_left = 0;  ///< kRoundRobin: statements left of next_thread's turn, 0 = none begun
  uint64_t random = 0;    ///< kRandom, kPct: generator state
  std::array<int32_t, kThreadCount> pct_priority{};  ///< larger runs first
  std::array<int64_t, kPctDepthMax> pct_points{};    ///< statement counts of the changes
  int64_t pct_executed = 0;
  size_t segment = 0;        ///< kReplay: current segment
  int64_t segment_done = 0;  ///< kReplay: statements of it already executed
};

/// The state of a policy before the first statement.
SchedulerState StartPolicy(const Policy& policy);

/// The thread to execute next and how many statements it may execute in a row before the policy
/// must be asked again (at least 1, at most `budget`).
struct Turn {
  int thread = -1;  ///< -1: a replayed schedule is at its end, or names a thread that cannot run
  int64_t statements = 0;
};

/// Chooses among the threads whose bits are set in `runnable` (never 0), for at most `budget`
/// statements. Ends a turn whose thread cannot run any more and begins the next one.
Turn BeginTurn(SchedulerState& state, uint32_t runnable, int64_t budget,
               const std::array<int16_t, kThreadCount>& priorities);

/// Must be called after `thread` has executed `statements` of its turn; `yielded` if it cannot
/// continue now (it finished, faulted, waits or was paused).
void EndTurn(SchedulerState& state, int thread, int64_t statements, bool yielded);

}  // namespace oncard::vm
