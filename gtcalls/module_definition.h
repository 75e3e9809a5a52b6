// The module definition of a host library for Windows: the names that it exports. The linker takes
// it for the library, and the makers of import libraries for those who link with it.
#pragma once

#include <string>

#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {

/// What the library exports.
struct ExportedNames {
  /// The plain names are functions with a card number, as declarations for several cards have them.
  bool multi_card = false;
  /// With the decoration of 32 bits, GT_Open@4: the bytes that a function takes from the stack. It
  /// is cut off where the library is linked (--kill-at), and names the function for those who call
  /// it.
  bool decorated = false;
};

/// Tested by tests/gtcalls/windows/.
std::string ModuleDefinition(const InterfaceForm& form, const ExportedNames& names);

}  // namespace oncard::gtcalls
