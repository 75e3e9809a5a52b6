// A motion program from a file, source or object.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.h"
#include "compiler/compiler.h"
#include "vm/object.h"

namespace oncard::runtime {

/// What came of loading a program.
struct ProgramLoad {
  /// Present when a source was compiled: its diagnostics, warnings of a good program included.
  std::optional<compiler::Compilation> compilation;
  /// Present on success.
  std::optional<vm::Object> object;
  /// Why a file could not be read. A source that was read and rejected has no error here.
  std::optional<Error> error;
};

/// Loads the object pair of a path that ends in `.bin`; compiles any other file. Nothing is
/// written.
ProgramLoad LoadProgram(const std::string& path, const compiler::Options& options);

/// `file:line` of an instruction, the file as it lies beside the program.
std::string SourcePlace(const std::string& program_path, const vm::Function& function,
                        size_t instruction);

}  // namespace oncard::runtime
