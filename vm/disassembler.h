// Readable listings of objects: what `oncard dump` prints. They work for every object that
// ReadObject() or the compiler yields, verified or not, so that a rejected object can be inspected.
#pragma once

#include <cstddef>
#include <string>

#include "vm/command_table.h"
#include "vm/object.h"

namespace oncard::vm {

/// One instruction in the notation of docs/object-format.md, variables by name:
/// `cc := i > end`, `if cc goto 6`, `GT_SetDo(12, 1)`, `return sum`. A slot that no symbol names
/// is `local:5` or `global:5`.
std::string DescribeInstruction(const Object& object, const Function& function, size_t index,
                                const CommandTable& commands);

/// The whole object: the globals, then per function its variables and per instruction the index,
/// the source line, the statement, and the words of its record with two spaces before the links.
/// Ends in a newline.
std::string Disassemble(const Object& object, const CommandTable& commands);

/// The same facts as one JSON document, indented, ending in a newline. Bytes that are not UTF-8
/// (a source file's name in GBK) become U+FFFD.
std::string DisassembleJson(const Object& object, const CommandTable& commands);

}  // namespace oncard::vm
