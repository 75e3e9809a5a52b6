// Executes one thread's decoded code. The virtual machine prepares a Frame, calls Interpret(), and
// applies the result; the choice of threads is not made here.
#pragma once

#include <array>
#include <cstdint>

#include "vm/handlers.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::vm {

/// Why Interpret() returned.
enum class Exit : uint8_t {
  kBudget,    ///< all allowed statements were executed
  kShared,    ///< the next statement may access shared data (kPrivateOnly)
  kFinished,  ///< returned, or reached the end
  kFault,     ///< the last statement faulted and changed nothing
  kBlocked    ///< a GT command made the thread wait or end
};

inline constexpr size_t kLocalBase = static_cast<size_t>(OperandClass::kLocal);
inline constexpr size_t kGlobalBase = static_cast<size_t>(OperandClass::kGlobal);
inline constexpr size_t kConstantBase = static_cast<size_t>(OperandClass::kConstant);

/// The parts of a thread that the interpreter needs; the virtual machine owns them.
struct Frame {
  const ImageFunction* function = nullptr;
  const Code* pc =
      nullptr;  ///< in: next instruction; out: next one, or the last one if the thread ended
  /// The slots of each OperandClass: the thread's page, the globals, the constants (read only: the
  /// linker uses constants only in source operands).
  std::array<int64_t*, 3> bases{};
  const ElementReference* elements = nullptr;
  int wrap_shift = 0;
  int thread = 0;
  Machine* machine = nullptr;
  int64_t left = 0;    ///< out: statements that were allowed but not executed
  int64_t result = 0;  ///< out: value of the executed return
  Fault fault = Fault::kNone;
  int64_t fault_value = 0;
  int64_t fault_limit = 0;

  int64_t* locals() const { return bases[kLocalBase]; }
};

/// Which statements may be executed.
enum class Reach : uint8_t {
  kAll,            ///< any
  kPrivateOnly,    ///< only those that access no data shared by threads
  kOneThenPrivate  ///< any statement first, then as kPrivateOnly
};

/// Maximum number of statements of one call of Interpret().
inline constexpr int64_t kInterpretMax = int64_t{1} << 40;

/// Executes up to `statements` (0..kInterpretMax) of the frame's thread.
Exit Interpret(Frame& frame, int64_t statements, Reach reach);

/// Executes a GT command of a program; implemented in command_call.cc. Stores the return code in
/// the thread; may change frame.locals. kBudget means that the thread continues.
Exit CallCommand(Frame& frame, const CallSite& site);

/// The slot of a packed operand of class kElement; nullptr, with the fault recorded in the frame,
/// if the index is out of bounds.
int64_t* ElementAddress(Frame& frame, uint16_t operand);

}  // namespace oncard::vm
