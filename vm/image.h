// A verified program in the form that the virtual machine executes: fixed 64-bit instructions
// decoded once at load time. Immutable and shared by every machine (and snapshot) that runs it.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "vm/command_table.h"
#include "vm/object.h"
#include "vm/verifier.h"

namespace oncard::vm {

/// One decoded instruction. `op` is a number of DecodedOp (handlers.h); the meaning of a, b and d
/// is the handler's.
struct Code {
  uint16_t op = 0;
  uint16_t a = 0;
  uint16_t b = 0;
  uint16_t d = 0;
};
static_assert(sizeof(Code) == 8);

/// An element with a variable index.
struct ElementReference {
  uint16_t base = 0;
  uint16_t size = 0;
  uint16_t index = 0;
  uint8_t array_class = 0;  ///< OperandClass (handlers.h) of the array: local or global
  uint8_t index_class = 0;  ///< of the index variable
  bool operator==(const ElementReference&) const = default;
};

/// One GT call: which command, and where each argument comes from.
struct CallSite {
  struct Argument {
    uint16_t operand = 0;  ///< packed operand (handlers.h)
    DataType type = DataType::kInt;
    bool address = false;
    int count_argument = -1;        ///< argument whose value is the number of elements, -1 for one
    bool elements_on_card = false;  ///< the command table says how many
    /// Address: slots that belong to the variable from the named slot on; for an element with a
    /// variable index, the array's size.
    uint16_t extent = 1;
    std::vector<DataType> slots;  ///< types of one element's slots
  };
  uint16_t command = 0;
  std::vector<Argument> arguments;
};

/// A function, ready to run.
struct ImageFunction {
  std::vector<Code> code;  ///< one per instruction, then kEnd
  std::vector<int64_t> constants;
  std::vector<ElementReference> elements;
  std::vector<CallSite> calls;
};

/// A program, ready to run.
struct Image {
  Object object;  ///< names, types and lines
  std::vector<ImageFunction> functions;
  /// XXH64 of everything that determines what the program does (not of names or lines).
  uint64_t hash = 0;
};

/// Verifies the object and decodes it. Fails as Verify() does, and with 2008 when a function has
/// more distinct literals than an instruction can number.
Result<std::shared_ptr<const Image>> LinkObject(Object object, const CommandTable& commands,
                                                Symbols symbols = Symbols::kRequired);

/// The index of a function by name, or -1.
int FindFunction(const Image& image, std::string_view name);

/// A symbol among the globals, or of one function; nullptr when there is none.
const Symbol* FindGlobal(const Image& image, std::string_view name);
const Symbol* FindLocal(const Image& image, int function, std::string_view name);

}  // namespace oncard::vm
