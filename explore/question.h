// What is asked of a program when a file is explored, for those to whom files come by content.
// Tested by tests/explore/question_test.cc.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/reports/report.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "vm/object.h"

namespace oncard::explore {

/// What is explored, and what must hold.
struct Question {
  runtime::Scenario scenario;
  std::vector<runtime::Requirement> requirements;
};

/// The question of the file `main`, of which `scenario` was read. A program by itself says in the
/// comments of its text, `source`, what must hold. Fails as ReadComments().
Result<Question> QuestionOf(const std::string& main, const runtime::Scenario& scenario,
                            std::string_view source, const vm::Object& object);

/// Checks the one schedule that the scenario's key `explore` names in `follow`; `read` reads its
/// file. Fails as FollowSchedule(), and if the file cannot be read.
Result<Findings> FollowWished(const Question& question, const vm::Object& object,
                              std::string_view source,
                              const std::function<Result<std::string>(const std::string&)>& read);

/// The text of the schedule file of a failure, which is to be beside `main`: lost.schedule of
/// lost.toml. Findings::source is filled in.
Result<std::string> FailureScheduleBeside(const std::string& main, const Question& question,
                                          const vm::Object& object, const Findings& findings);

}  // namespace oncard::explore
