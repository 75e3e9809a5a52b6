// What Python hands over to be compiled, run or explored: a file, with others that are given by
// content. Without Python itself. Safe to call from several threads.
// Tested by tests/python/test_run.py.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "runtime/observe/card_warnings.h"
#include "runtime/scenario/file/scenario_keys.h"
#include "session/project.h"

namespace oncard::python {

/// A program, a scenario or a recording.
struct Source {
  std::string main;
  /// Texts by path; what is not there is read from the file system.
  std::map<std::string, std::string> files;
  bool structured = false;  ///< the program is structured C whatever it says itself
};

session::Files FilesOf(const Source& source);

/// Reads it for a use. For a run, the comments of a program that runs by itself complete its
/// scenario. Fails as session::ReadProject() and explore::AddComments(); errors of the program are
/// in the compilation.
Result<session::Project> ReadProject(const Source& source, const session::Files& files,
                                     runtime::ScenarioUse use);

/// A program that was compiled, or the errors because of which it was not.
struct CompiledProgram {
  std::string path;
  compiler::Compilation compilation;
};

/// Compiles the program, or that of the scenario.
Result<CompiledProgram> Compile(const Source& source);

/// How a test treats a scenario.
struct TestKind {
  std::string_view name;  ///< run, explore, host
  std::string verdict;    ///< explore: what is expected
  bool checks = true;     ///< run, explore: it expects or requires something
};

/// Reads a scenario for a test. Those of host programs need not be readable for anything else.
Result<TestKind> KindOfTest(const Source& source);

/// The warnings of the card's supervisor with these names. Fails with the names that there are.
Result<runtime::CardWarnings> WarningsNamed(const std::vector<std::string>& names);

}  // namespace oncard::python
