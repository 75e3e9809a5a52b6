// A second machine for motion programs, slow and easy to read: it uses the Object directly,
// executes one statement at a time with plain switches, and chooses threads by the definition of
// the round robin. It shares nothing with the machine except the Object and the command numbers, so
// that the two only agree if both are correct.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "vm/machine.h"
#include "vm/object.h"
#include "vm/schedule.h"

namespace oncard::vm {

class ReferenceMachine {
 public:
  enum class Run : uint8_t { kUnbound, kStopped, kRunning, kPaused, kFaulted };

  struct Thread {
    Run run = Run::kUnbound;
    bool started = false;
    size_t page = 0;
    size_t function = 0;
    size_t pc = 0;
    int error = 0;
    int64_t result = 0;
    int64_t fault_value = 0;
    int64_t fault_limit = 0;
    int64_t wake_cycle = 0;
    bool waiting = false;
    int64_t* wait_slot = nullptr;
    int32_t wait_value = 0;
    int64_t executed = 0;
  };

  /// `quantum` is the number of statements per turn.
  ReferenceMachine(const Object& object, int64_t quantum) : object_(object), quantum_(quantum) {}
  ReferenceMachine(const ReferenceMachine&) = delete;
  ReferenceMachine& operator=(const ReferenceMachine&) = delete;

  /// `function` counts from 0.
  void Bind(size_t thread, size_t function, size_t page);
  void Start(size_t thread);
  void BeginCycle(int64_t cycle) { cycle_ = cycle; }
  /// Executes up to `budget` statements; returns how many.
  int64_t Execute(int64_t budget);

  /// Describes the difference between the machine and this one; empty if there is none.
  std::string Difference(const Machine& machine) const;

  std::array<std::array<int64_t, 1024>, 32> pages{};
  std::array<int64_t, 1024> globals{};
  std::array<Thread, 32> threads{};
  /// What has been executed.
  std::vector<ScheduleSegment> segments;

 private:
  // The slot of an operand; nullptr after a fault at its index.
  int64_t* Place(Thread& thread, const Operand& operand);
  bool CanGoOn(const Thread& thread) const;
  bool Awake(const Thread& thread) const;
  // The thread that the round robin chooses, or -1.
  int Choose();
  void Step(Thread& thread);
  // Finishes threads that have nothing left to execute when they wake up.
  void FinishAwakened();
  void Finish(Thread& thread);
  void FaultAt(Thread& thread, int code, int64_t value, int64_t limit);

  // Each executes one statement; true if the thread continues with the next one.
  bool StepUnary(Thread& thread, const Instruction& instruction);
  bool StepBinary(Thread& thread, const Instruction& instruction);
  bool StepReturn(Thread& thread, const Instruction& instruction);
  bool StepCommand(Thread& thread, const Instruction& instruction);

  // The value of a source operand, an int or a raw double; false after a fault.
  bool Load(Thread& thread, const Operand& operand, DataType type, int64_t* value);
  int64_t WrapDouble(__int128 raw) const;

  const Object& object_;
  int64_t quantum_;
  int64_t cycle_ = 0;
  int64_t executed_ = 0;
  size_t next_ = 0;        // first candidate of the next turn
  int64_t turn_left_ = 0;  // statements left of the turn of next_, 0 = none begun
};

}  // namespace oncard::vm
