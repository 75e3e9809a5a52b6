// What the commands of an explored program cause warnings for, as `oncard explore` and
// `oncard test` tell it.
#pragma once

#include <string>
#include <vector>

#include "explore/reports/report.h"
#include "runtime/observe/card_warnings.h"

namespace oncard::tools {

/// The commands that were refused, then what the supervisor has found, except what is `silent`.
std::vector<Message> ProgramWarnings(const explore::Findings& findings,
                                     const runtime::CardWarnings& silent,
                                     const std::string& program_path);

}  // namespace oncard::tools
