// Shared by the compiler's tests: compiling text, listing diagnostics, applying fix-its.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/fix_it_applier.h"
#include "gtcalls/gts/catalogue.h"
#include "tests/compiler/memory_files.h"
#include "vm/command_table.h"

namespace oncard::compiler {

inline Compilation CompileString(const std::string& text, const Options& options = {},
                                 const MemoryFiles& files = {}) {
  return CompileText("test.c", text, options, ReaderOf(files));
}

/// The codes of the diagnostics, in order.
inline std::vector<int> CodesOf(const Compilation& compilation) {
  std::vector<int> codes;
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    codes.push_back(diagnostic.info->code);
  }
  return codes;
}

/// The text after the edits of one diagnostic are applied.
inline std::string ApplyFixIts(const std::string& text, const Diagnostic& diagnostic) {
  return ApplyEdits(text, diagnostic.fixits);
}

/// The program after all fix-its are applied.
inline CorrectedProgram CorrectString(const std::string& text, const MemoryFiles& files = {}) {
  return ApplyAllFixIts("test.c", text, {}, ReaderOf(files));
}

/// The catalogue as needed by the object verifier; executes nothing.
class CatalogueShapes final : public vm::CommandTable {
 public:
  const vm::CommandShape* Find(uint16_t number) const override {
    const gtcalls::Command* command = gtcalls::GtsCatalogue().Find(number);
    return command == nullptr ? nullptr : &gtcalls::GtsCatalogue().ShapeOf(*command);
  }
  int16_t Execute(uint16_t /*number*/, vm::Machine& /*machine*/, int /*thread*/,
                  std::span<vm::CommandArgument> /*arguments*/) override {
    return 0;
  }
};

}  // namespace oncard::compiler
