// Warnings about programs that compile and cannot be meant, found in the translated statements:
// what is never reached, never written, never read, never ends. Each says only what holds on every
// path, so that a good program draws none.
// Tested by tests/lang/warnings.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/reporter.h"
#include "vm/object.h"

namespace oncard::compiler {

/// What a function's translation does not say of its source.
struct FunctionPlaces {
  std::vector<SourceRange> statements;  ///< of each instruction
  uint16_t parameter_slots = 0;         ///< the host writes these
};

/// Reports the warnings of a program without errors; `places` has a row for each function.
void WarnAboutFlow(const vm::Object& object, const std::vector<FunctionPlaces>& places,
                   Reporter& reporter);

}  // namespace oncard::compiler
