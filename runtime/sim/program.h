// Loads a motion program from a source or an object file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.h"
#include "compiler/compiler.h"
#include "vm/object.h"

namespace oncard::runtime {

/// The result of loading a program.
struct ProgramLoad {
  /// Present if a source was compiled: its diagnostics, including warnings of a correct program.
  std::optional<compiler::Compilation> compilation;
  /// Present on success.
  std::optional<vm::Object> object;
  /// The reason why a file could not be read. A source that was read and rejected has no error
  /// here.
  std::optional<Error> error;
};

/// Loads the object pair of a path that ends in `.bin`; compiles any other file. Nothing is
/// written.
ProgramLoad LoadProgram(const std::string& path, const compiler::Options& options);

/// `file:line` of an instruction, the file relative to the program.
std::string SourcePlace(const std::string& program_path, const vm::Function& function,
                        size_t instruction);

}  // namespace oncard::runtime
