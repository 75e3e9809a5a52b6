#include "runtime/sim/program.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/path_bytes.h"
#include "vm/object_reader.h"

namespace oncard::runtime {

ProgramLoad LoadProgram(const std::string& path, const compiler::Options& options) {
  ProgramLoad load;
  if (path.ends_with(".bin")) {
    auto object = vm::ReadObjectPair(path);
    if (object.ok()) {
      load.object = std::move(object).value();
    } else {
      load.error = object.error();
    }
    return load;
  }
  auto text = compiler::ReadSource(path);
  if (!text.ok()) {
    load.error = text.error();
    return load;
  }
  load.compilation =
      compiler::CompileText(path, std::move(text).value(), options, compiler::ReadSource);
  load.object = load.compilation->object;
  return load;
}

std::string SourcePlace(const std::string& program_path, const vm::Function& function,
                        size_t instruction) {
  const std::filesystem::path folder = PathOf(program_path).parent_path();
  const int line = instruction < function.lines.size() ? function.lines[instruction] : 0;
  return fmt::format("{}:{}", FileNameOf(folder / PathOf(function.file)), line);
}

}  // namespace oncard::runtime
