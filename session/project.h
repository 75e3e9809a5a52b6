// The files of a session: a scenario, a program or a recording, and what they refer to. They come
// with the request; a reader supplies those that do not, if the session has a file system.
// Tested by tests/session/host_test.cc.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/compiler.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/record/call_record.h"
#include "vm/schedule.h"

namespace oncard::session {

/// Files by their paths as the scenario and the program write them.
class Files {
 public:
  /// `other` reads the files that are not in `texts`; empty: there are no others.
  Files(std::map<std::string, std::string> texts, compiler::FileReader other)
      : texts_(std::move(texts)), other_(std::move(other)) {}

  Result<std::string> Read(const std::string& path) const;

  /// What was to be read and does not exist, in the order of the first attempts.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  std::map<std::string, std::string> texts_;
  compiler::FileReader other_;
  mutable std::vector<std::string> missing_;
};

/// What is needed to run a program.
struct Project {
  runtime::Scenario scenario;
  /// Of the program, with its warnings, or the errors because of which there is no object.
  compiler::Compilation compilation;
  /// The recording that is to be followed.
  std::shared_ptr<const vm::Schedule> schedule;
  /// The text of a record of host calls, instead of all others.
  std::optional<std::string> calls;
};

/// The source of a program.
struct ProgramSource {
  std::string path;
  std::string text;
  compiler::Options options;
};

/// The source that `main` or its scenario names, whatever the scenario is for. Fails like
/// ReadProject(), and for an object file.
Result<ProgramSource> ReadProgramSource(const std::string& main, const Files& files,
                                        bool structured = false);

/// Reads `main`: a scenario (.toml), a recording (.schedule), a record of host calls (.calls, only
/// for ScenarioUse::kSession), or a program that runs by itself. The
/// program is structured C if `structured` or the scenario or the program says so. Fails if a file
/// is missing, or is not what it should be, or if the scenario has keys that cannot be used for
/// `use`; errors of the program are in the compilation.
Result<Project> ReadProject(const std::string& main, const Files& files, bool structured = false,
                            runtime::ScenarioUse use = runtime::ScenarioUse::kSession);

}  // namespace oncard::session
