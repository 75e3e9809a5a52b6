// The virtual machine's interface to GT commands: the shapes of their arguments, to verify calls
// when a program is loaded, and one entry point to execute them. The command catalogue implements
// this interface; the virtual machine does not know what a command does.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "vm/opcodes.h"

namespace oncard::vm {

class Machine;

/// The caller's number when a command comes from the host, not from a motion-program thread.
inline constexpr int kHostCaller = -1;

/// Shape of one parameter as a motion program sees it.
struct ParameterShape {
  std::string_view name;
  /// The call passes the address of a variable: an output, an input array, or a structure.
  bool address = false;
  /// Types of the consecutive slots behind one element: one for a scalar, one per member for a
  /// structure.
  std::span<const DataType> slots;
  /// Index of the parameter that says how many elements the address covers, or -1 for one.
  int count_parameter = -1;
  /// Without such a parameter: as many elements as CommandTable::Elements() says.
  bool elements_on_card = false;
};

/// Shape of one command.
struct CommandShape {
  uint16_t number = 0;
  std::string_view name;
  std::span<const ParameterShape> parameters;
  bool in_motion_program = false;
};

/// Names one variable slot of the machine.
struct SlotAddress {
  bool global = false;
  uint8_t page = 0;
  uint16_t id = 0;
  DataType type = DataType::kInt;
};

/// One argument. Every scalar of the interface (short, long, unsigned long, double) fits a double
/// exactly, so values are passed as doubles. `cells` is what a pointer points to, one double per
/// scalar, read before the command and written back after it.
struct CommandArgument {
  double value = 0;
  std::span<double> cells;
  bool null = false;     ///< a host passed NULL
  SlotAddress slot;      ///< motion program only: the first slot of `cells`
  void* host = nullptr;  ///< host only: the pointer itself
};

/// Commands by number. One object serves one card; calls come from one thread at a time.
class CommandTable {
 public:
  virtual ~CommandTable() = default;

  /// The shape of a command, or nullptr when no command has this number.
  virtual const CommandShape* Find(uint16_t number) const = 0;

  /// How many elements the address parameter `parameter` of a command covers now, for those that
  /// say elements_on_card; `first` is the command's first argument.
  virtual int64_t Elements(uint16_t /*number*/, size_t /*parameter*/, double /*first*/) const {
    return 1;
  }

  /// Executes a command for a motion-program thread of `machine` and returns its code. The
  /// command may delay the thread, make it wait, or switch its page through Machine.
  virtual int16_t Execute(uint16_t number, Machine& machine, int thread,
                          std::span<CommandArgument> arguments) = 0;
};

}  // namespace oncard::vm
