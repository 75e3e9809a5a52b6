// The fast implementation of the one-statement round robin. In round r every thread executes its
// r-th statement, in thread order. A statement that accesses nothing shared can be executed early
// unnoticed, so each thread runs ahead over its private statements and stops before its next shared
// one; a calendar of rounds says which thread is due when. Shared statements are executed exactly
// in the order of the rounds. Afterwards every thread has executed exactly the statements that the
// plain interleaving would have executed.
//
// Where shared statements are frequent, the rounds are executed as they are, until the first
// statement that the rotation does not execute.
//
// This relies on a property of the command set: a command called from a program never changes
// another thread's state.
// Tested by tests/vm/run_ahead_test.cc, which compares it with the plain interleaving after every
// statement.
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

#include "vm/handlers.h"
#include "vm/interpreter.h"
#include "vm/machine.h"
#include "vm/rotation.h"

namespace oncard::vm {
namespace {

// Rounds planned at once: enough to make entering the interpreter worthwhile for a private loop,
// few enough for the calendar to stay in the cache.
constexpr int64_t kWindow = 1024;

// Where threads stop before nearly every statement, running ahead is slower than changing the
// thread after each one (rotation.h). So a window with fewer statements than these for each stop is
// followed by windows that begin with a rotation; then the statements are counted again.
constexpr int64_t kStatementsPerStopMin = 4;
constexpr int kRotatedWindows = 63;

// The positions (bits) that are due in each round. Rounds are removed in ascending order; meanwhile
// a position may be entered for any later round.
class Calendar {
 public:
  void Enter(int64_t round, int position) {
    due_[static_cast<size_t>(round)] |= uint32_t{1} << position;
    occupied_[static_cast<size_t>(round / 64)] |= uint64_t{1} << (round % 64);
  }

  // The first round at or after `from` in which a position is due, or -1.
  int64_t Next(int64_t from) const {
    if (from >= kWindow) return -1;
    size_t word = static_cast<size_t>(from / 64);
    uint64_t rest = occupied_[word] & (~uint64_t{0} << (from % 64));
    while (rest == 0) {
      if (++word == occupied_.size()) return -1;
      rest = occupied_[word];
    }
    return static_cast<int64_t>(word) * 64 + std::countr_zero(rest);
  }

  uint32_t TakeOut(int64_t round) {
    occupied_[static_cast<size_t>(round / 64)] &= ~(uint64_t{1} << (round % 64));
    return std::exchange(due_[static_cast<size_t>(round)], 0);
  }

 private:
  std::array<uint32_t, kWindow> due_{};
  std::array<uint64_t, kWindow / 64> occupied_{};
};

// For a recording: which positions (bits) execute a statement in which rounds of a window.
class Attendance {
 public:
  // The position executes one in each round from `from` to before `to`.
  void Enter(int position, int64_t from, int64_t to) {
    if (from == to) return;
    Change(from, position);
    Change(to, position);
  }

  // Calls `visit(positions, rounds)` for rounds one after the other that are alike, and forgets
  // them.
  template <typename Visit>
  void TakeOut(const Visit& visit) {
    uint32_t positions = 0;
    int64_t begin = 0;
    for (size_t word = 0; word < occupied_.size(); ++word) {
      for (uint64_t rest = std::exchange(occupied_[word], 0); rest != 0; rest &= rest - 1) {
        const auto round = static_cast<int64_t>(word) * 64 + std::countr_zero(rest);
        if (positions != 0 && round > begin) visit(positions, round - begin);
        positions ^= std::exchange(changes_[static_cast<size_t>(round)], 0);
        begin = round;
      }
    }
  }

 private:
  void Change(int64_t round, int position) {
    changes_[static_cast<size_t>(round)] ^= uint32_t{1} << position;
    occupied_[static_cast<size_t>(round / 64)] |= uint64_t{1} << (round % 64);
  }

  std::array<uint32_t, kWindow + 1> changes_{};  // positions that begin or end with a round
  std::array<uint64_t, kWindow / 64 + 1> occupied_{};
};

}  // namespace

int64_t Machine::ExecuteRounds(uint32_t members, int64_t rounds) {
  struct Member {
    int64_t executed = 0;
    bool alive = true;
  };
  std::array<Member, kThreadCount> order;
  std::array<Frame, kThreadCount + 1> frames;  // with the room that a rotation needs
  int count = 0;
  const int first = state_->scheduler.next_thread;
  for (int i = 0; i < kThreadCount; ++i) {
    const int thread = (first + i) % kThreadCount;
    if ((members >> thread & 1) == 0) continue;
    ThreadState& state = ThreadAt(thread);
    if (state.breakpoint_line != 0) return 0;
    state.wake_cycle = 0;
    frames[static_cast<size_t>(count++)] = MakeFrame(thread);
  }

  Calendar calendar;
  std::optional<Attendance> attendance;
  if (recording_ != nullptr) attendance.emplace();
  // Positions that wait and have nothing left to execute: they finish as soon as the value is
  // reached, without a turn of their own.
  uint32_t ending = 0;
  const auto frame_at = [&](int position) -> Frame& {
    return frames[static_cast<size_t>(position)];
  };
  const auto all_alive = [&] {
    return std::all_of(order.begin(), order.begin() + count,
                       [](const Member& member) { return member.alive; });
  };
  const auto any_waits = [&] {
    return std::any_of(frames.begin(), frames.begin() + count,
                       [&](const Frame& frame) { return ThreadAt(frame.thread).waiting; });
  };
  int64_t total = 0;
  int last_thread = -1;
  int windows_to_rotate = 0;
  while (rounds > 0) {
    const int64_t window = std::min(rounds, kWindow);
    int64_t last_round = -1;
    int last_position = -1;
    int64_t stops = 0;
    const int64_t total_before = total;

    const auto enter = [&](int64_t round, int position) {
      if (round < window) calendar.Enter(round, position);
    };
    const auto wait = [&](int64_t round, int position) {
      if (frame_at(position).pc->op == kEnd) {
        ending |= uint32_t{1} << position;
      } else {
        enter(round, position);
      }
    };
    // Runs a thread from `round` on, and enters it in the calendar for the round in which it must
    // stop.
    const auto run = [&](int position, int64_t round, Reach reach) {
      Member& member = order[static_cast<size_t>(position)];
      Frame& frame = frame_at(position);
      Exit exit = Interpret(frame, window - round, reach);
      const int64_t executed = window - round - frame.left;
      const int64_t next = round + executed;
      member.executed += executed;
      total += executed;
      if (attendance) attendance->Enter(position, round, next);
      if (executed > 0 &&
          (next - 1 > last_round || (next - 1 == last_round && position > last_position))) {
        last_round = next - 1;
        last_position = position;
      }
      if (exit == Exit::kBudget && frame.pc->op == kEnd) {
        exit = Interpret(frame, 0, Reach::kAll);
      }
      const bool waits = exit == Exit::kBlocked && ThreadAt(frame.thread).waiting;
      if (waits) {
        wait(next, position);
      } else if (exit == Exit::kShared) {
        ++stops;
        enter(next, position);
      } else if (exit != Exit::kBudget) {
        member.alive = false;
        Settle(frame, exit, member.executed);
      }
    };

    const auto finish = [&] {
      for (uint32_t rest = ending; rest != 0; rest &= rest - 1) {
        const int position = std::countr_zero(rest);
        ThreadState& state = ThreadAt(frame_at(position).thread);
        if (!CanContinue(state)) continue;
        ending &= ~(uint32_t{1} << position);
        state.waiting = false;
        run(position, 0, Reach::kAll);
      }
    };

    // The rounds before this one, and in it the statements of the positions before this one, are
    // executed by a rotation.
    RotationEnd rotated;
    if (windows_to_rotate > 0 && !any_waits()) {
      rotated = Rotate({frames.data(), static_cast<size_t>(count) + 1}, window);
      last_round = rotated.position > 0 ? rotated.rounds : rotated.rounds - 1;
      last_position = static_cast<int>(rotated.position > 0 ? rotated.position : count) - 1;
    }
    for (int position = 0; position < count; ++position) {
      Member& member = order[static_cast<size_t>(position)];
      if (!member.alive) continue;
      const int64_t round = rotated.rounds + (position < rotated.position ? 1 : 0);
      member.executed += round;
      total += round;
      if (attendance) attendance->Enter(position, 0, round);
      if (ThreadAt(frame_at(position).thread).waiting) {
        wait(round, position);
      } else {
        run(position, round, Reach::kPrivateOnly);
      }
    }
    for (int64_t round = calendar.Next(0); round >= 0; round = calendar.Next(round + 1)) {
      for (uint32_t rest = calendar.TakeOut(round); rest != 0; rest &= rest - 1) {
        const int position = std::countr_zero(rest);
        ThreadState& state = ThreadAt(frame_at(position).thread);
        if (state.waiting && !CanContinue(state)) {
          enter(round + 1, position);
          continue;
        }
        state.waiting = false;
        run(position, round, Reach::kOneThenPrivate);
        finish();
      }
    }
    if (attendance) {
      attendance->TakeOut([&](uint32_t positions, int64_t how_many) {
        const int begins = frame_at(std::countr_zero(positions)).thread;
        RecordedRounds alike = {0, static_cast<uint8_t>(begins), how_many};
        for (uint32_t rest = positions; rest != 0; rest &= rest - 1) {
          alike.threads |= uint32_t{1} << frame_at(std::countr_zero(rest)).thread;
        }
        recording_->AddRounds(alike);
      });
    }
    if (last_position < 0) break;
    last_thread = frame_at(last_position).thread;
    rounds -= window;
    // The caller begins again with those that are left, so that they can rotate.
    if (!all_alive()) break;
    if (windows_to_rotate > 0) {
      --windows_to_rotate;
    } else if (total - total_before < stops * kStatementsPerStopMin) {
      windows_to_rotate = kRotatedWindows;
    }
  }

  for (int position = 0; position < count; ++position) {
    Member& member = order[static_cast<size_t>(position)];
    if (member.alive) Settle(frame_at(position), Exit::kBudget, member.executed);
  }
  if (last_thread >= 0) state_->scheduler.next_thread = (last_thread + 1) % kThreadCount;
  return total;
}

}  // namespace oncard::vm
