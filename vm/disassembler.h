// Readable listings of objects: what `oncard dump` prints.
#pragma once

#include <string>

#include "vm/command_table.h"
#include "vm/object.h"

namespace oncard::vm {

/// One instruction in the notation of docs/object-format.md, variables by name:
/// `cc := i > end`, `if cc goto 6`, `GT_SetDo(12, 1)`, `return sum`.
std::string DescribeInstruction(const Object& object, const Function& function, size_t index,
                                const CommandTable& commands);

/// The whole object: per function its variables, then per instruction the index, the words of its
/// record, the mnemonic and the source line. Ends in a newline.
std::string Disassemble(const Object& object, const CommandTable& commands);

/// The same facts as one JSON document.
std::string DisassembleJson(const Object& object, const CommandTable& commands);

}  // namespace oncard::vm
