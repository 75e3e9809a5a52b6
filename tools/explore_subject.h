// What `oncard explore` is given: a scenario, or a source that says in comments what must hold.
#pragma once

#include <string>
#include <vector>

#include "explore/models/problem.h"
#include "runtime/scenario/scenario.h"
#include "tools/session.h"

namespace oncard::tools {

/// A file to be explored: its scenario, what it requires, its program.
struct ExploreSubject {
  runtime::Scenario scenario;
  std::vector<explore::Requirement> requirements;
  vm::Object object;
  std::string source;  ///< of a program that was compiled
};

/// Reads it and reports what is wrong. Gives the exit code; the subject is filled in when that is
/// kExitOk.
int ReadSubject(const Session& session, const std::string& path, bool json,
                ExploreSubject* subject);

}  // namespace oncard::tools
