// Writes a lowered program as text of the card's language, with the statements of C as comments.
#pragma once

#include <string>
#include <vector>

#include "compiler/diagnostic.h"
#include "compiler/lowering/ir.h"
#include "compiler/lowering/lowering.h"
#include "compiler/structured_source.h"

namespace oncard::compiler::lowering {

struct PrintedProgram {
  std::string text;
  /// Where each line of the text (from 1, so [0] is line 1) comes from; file -1: from nowhere.
  std::vector<SourceRange> origins;
  std::vector<StatementOfC> statements;  ///< as in Lowering
};

PrintedProgram Print(const Program& program, const StructuredSource& source,
                     const LoweringOptions& options);

}  // namespace oncard::compiler::lowering
