// One instruction as the words of its `.bin` record, and back. Shared by the object reader and
// writer, the disassembler and the download by words (GT_LoadPlcCommand).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "vm/object.h"

namespace oncard::vm {

/// The words of a record: len, words, k, links. The instruction must have the operands that its
/// opcode asks for (object.h), at most kCommandArgumentMax of a command.
std::vector<uint16_t> EncodeRecord(const Instruction& instruction);

/// A decoded record and the number of words it took.
struct DecodedRecord {
  Instruction instruction;
  size_t word_count = 0;
};

/// Decodes the record at the beginning of `words`. Fails with code 2008 if it is truncated or
/// malformed; Verify() checks whether it is valid in its function.
Result<DecodedRecord> DecodeRecord(std::span<const uint16_t> words);

}  // namespace oncard::vm
