// The effects of single statements of a run: the variables that each reads and writes, and their
// values. Tested by tests/runtime/scenario_run_test.cc and tests/explore/step_table_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// A variable's slot and its value. The type of the slot is that of the variable in it.
struct SlotValue {
  vm::SlotAddress slot;
  int64_t raw = 0;
};

/// A slot that was written, possibly with the value that it had before.
struct SlotChange {
  vm::SlotAddress slot;
  int64_t before = 0;
  int64_t after = 0;
};

/// One statement.
struct LoggedStep {
  int thread = 0;        ///< number on the card
  int function = 0;      ///< index in the image
  int position = 0;      ///< of the instruction in its function
  int line = 0;          ///< of the source, 0 when unknown
  double at_ms = 0;      ///< begin of the cycle in which it is executed
  bool command = false;  ///< it calls a GT command
  bool decides = false;  ///< it is a jump or a return with a condition
  std::vector<SlotValue> reads;
  std::vector<SlotChange> writes;
};

bool SameSlot(const vm::SlotAddress& a, const vm::SlotAddress& b);

/// `x`, `a[3]`; a local is one of the function with that index. Empty for a slot without a name.
std::string NameOfSlot(const vm::SlotAddress& slot, int function, const vm::Object& object);
/// The same for a slot that a step accesses.
std::string NameOf(const LoggedStep& step, const vm::SlotAddress& slot, const vm::Object& object);
/// The slot's content as FormatNumber() writes it.
std::string ValueText(const LoggedStep& step, const vm::SlotAddress& slot, int64_t raw,
                      const vm::Object& object);

/// The statements of a run.
struct StepLog {
  /// Maximum number of recorded statements; further ones are only counted.
  static constexpr size_t kStepMax = 100'000;

  std::shared_ptr<const vm::Image> image;  ///< for the names
  std::vector<LoggedStep> steps;
  int64_t executed = 0;
};

/// Observes a card before and after one statement. It copies the state of the virtual machine, so
/// it is meant for short runs that people read.
class StepWatch {
 public:
  /// The controller must outlive the watch and have a program.
  explicit StepWatch(const Controller& controller) : controller_(controller) {}

  void Before();
  /// The statement of a thread that has been executed since.
  LoggedStep After(int thread) const;
  /// The thread that has executed a statement since; -1: none.
  int ThreadOfStep() const;

 private:
  const Controller& controller_;
  std::unique_ptr<vm::MachineState> before_;  // large
  double at_ms_ = 0;
};

/// Controller::RunUntilQuiet(), statement by statement: the same run, with a log of its statements.
RunEnd RunLogged(Controller* controller, int64_t limit_cycles, StepLog* log);

}  // namespace oncard::runtime
