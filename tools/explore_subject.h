// The input of `oncard explore`: a scenario, or a source with its requirements in comments.
#pragma once

#include <string>
#include <vector>

#include "explore/models/problem.h"
#include "explore/reports/statement_texts.h"
#include "runtime/scenario/file/scenario.h"
#include "tools/invocation.h"

namespace oncard::tools {

/// A file to be explored: its scenario, requirements and program.
struct ExploreSubject {
  runtime::Scenario scenario;
  std::vector<explore::Requirement> requirements;
  vm::Object object;
  explore::ProgramText source;  ///< of a program that was compiled
};

/// How its program is read.
struct SubjectReading {
  bool json = false;        ///< the format of diagnostics
  bool structured = false;  ///< the program is structured C whatever it says itself
};

/// Reads it and reports errors. Returns the exit code; the subject is filled in if that is kExitOk.
int ReadSubject(const Invocation& invocation, const std::string& path, SubjectReading reading,
                ExploreSubject* subject);

}  // namespace oncard::tools
