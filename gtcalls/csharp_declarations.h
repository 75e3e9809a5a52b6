// Declarations of a family's commands for C#, such as Gts.cs: one of the files that the generator
// writes (generate_interface.cc). They are written as hosts have them: a class `mc` in a namespace
// with the name of the library, `int` for a `long`, and the structures of the vendor's basic
// header.
#pragma once

#include <string>

#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {

/// With `multi_card` the functions have a card number in front, and the structures are those of our
/// header, which such functions take. Tested by tests/dotnet/.
std::string CsharpDeclarations(const InterfaceForm& form, bool multi_card);

}  // namespace oncard::gtcalls
