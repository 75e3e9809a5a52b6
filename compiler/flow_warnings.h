// Warnings about programs that compile but are very likely wrong, found in the translated
// statements: code that is never reached, variables never written or never read, loops that never
// end, masks of axes that were not set up. Each warns only of what is true on every path, so that
// correct programs have none. Tested by tests/lang/warnings.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/reporter.h"
#include "gtcalls/catalogue.h"
#include "vm/object.h"

namespace oncard::compiler {

/// Source information that a function's translation does not contain.
struct FunctionPlaces {
  std::vector<SourceRange> statements;  ///< of each instruction
  uint16_t parameter_slots = 0;         ///< the host writes these
  SourceRange body = {};                ///< from the opening brace to the closing one
};

/// Reports the warnings of a program without errors; `places` has a row for each function, and the
/// catalogue has its commands.
void WarnAboutFlow(const vm::Object& object, const std::vector<FunctionPlaces>& places,
                   const gtcalls::Catalogue& catalogue, Reporter& reporter);

}  // namespace oncard::compiler
