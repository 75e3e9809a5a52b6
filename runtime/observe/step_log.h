// What single statements of a run do: which variables each reads and writes, and their values.
// Tested by tests/runtime/scenario_run_test.cc and tests/explore/step_table_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// A variable's slot and what it held. The type of the slot is that of the variable in it.
struct SlotValue {
  vm::SlotAddress slot;
  int64_t raw = 0;
};

/// A slot that was written; the value may be the one that was there.
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

/// `x`, `a[3]`; a local is one of the step's function. Empty for a slot without a name.
std::string NameOf(const LoggedStep& step, const vm::SlotAddress& slot, const vm::Object& object);
/// The slot's content as FormatNumber() writes it.
std::string ValueText(const LoggedStep& step, const vm::SlotAddress& slot, int64_t raw,
                      const vm::Object& object);

/// The statements of a run.
struct StepLog {
  /// More statements than that are counted only.
  static constexpr size_t kStepMax = 100'000;

  std::shared_ptr<const vm::Image> image;  ///< for the names
  std::vector<LoggedStep> steps;
  int64_t executed = 0;
};

/// Looks at a card before and after one statement. Copies the machine's state: for runs of as many
/// statements as people read.
class StepWatch {
 public:
  /// The controller outlives the watch and has a program.
  explicit StepWatch(const Controller& controller) : controller_(controller) {}

  void Before();
  /// The statement of a thread that was executed since.
  LoggedStep After(int thread) const;
  /// The thread of which a statement was executed since; -1: none.
  int ThreadOfStep() const;

 private:
  const Controller& controller_;
  std::unique_ptr<vm::MachineState> before_;  // large
  double at_ms_ = 0;
};

/// Controller::RunUntilQuiet(), statement by statement: the same run, and what its statements did.
RunEnd RunLogged(Controller* controller, int64_t limit_cycles, StepLog* log);

}  // namespace oncard::runtime
