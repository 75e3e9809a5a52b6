// Applies fix-its, those of one diagnostic or of a whole program until none is left. Tested by
// tests/compiler/rewriter_test.cc and tests/differential/structured_test.cc.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/compiler.h"

namespace oncard::compiler {

/// A program after its fix-its.
struct CorrectedProgram {
  /// The remaining diagnostics, which no fix-it corrects.
  Compilation compilation;
  /// Number of diagnostics that were corrected.
  int count = 0;
  /// The files that changed, by path, with their texts.
  std::map<std::string, std::string> files;
};

/// The text after the edits, which must not overlap. Insertions at the same place keep their order.
std::string ApplyEdits(const std::string& text, std::vector<FixIt> edits);

/// Compiles, applies, and compiles again. If the ranges of fix-its touch, the first one is applied
/// and the others are computed again, because each applies to the current text. Included files are
/// corrected as well. Ends with an edit that leads back to an earlier text, and after many passes.
CorrectedProgram ApplyAllFixIts(const std::string& path, std::string text, const Options& options,
                                const FileReader& reader);

}  // namespace oncard::compiler
