#include "explore/question.h"

#include <utility>

#include "base/path_bytes.h"
#include "explore/failure_files.h"
#include "explore/scenario_exploration.h"
#include "vm/schedule.h"

namespace oncard::explore {

Result<Question> QuestionOf(const std::string& main, const runtime::Scenario& scenario,
                            std::string_view source, const vm::Object& object) {
  if (scenario.program != main) return Question{scenario, runtime::RequirementsOf(scenario)};
  auto read = ReadComments(main, source, object);
  if (!read.ok()) return read.error();
  Question question = {std::move(read.value().scenario), std::move(read.value().requirements)};
  question.scenario.structured = scenario.structured;
  return question;
}

Result<Findings> FollowWished(const Question& question, const vm::Object& object,
                              std::string_view source,
                              const std::function<Result<std::string>(const std::string&)>& read) {
  const runtime::Scenario& scenario = question.scenario;
  const std::string path = runtime::PathFromScenario(scenario, scenario.explore->follow);
  const auto text = read(path);
  if (!text.ok()) return text.error();
  const auto schedule = vm::ParseScheduleFile(path, text.value());
  if (!schedule.ok()) return schedule.error();
  return FollowSchedule(scenario, question.requirements, object, source, schedule.value());
}

Result<std::string> FailureScheduleBeside(const std::string& main, const Question& question,
                                          const vm::Object& object, const Findings& findings) {
  return FailureSchedule({question.scenario, question.requirements, object, findings.source.text},
                         findings, FileNameOf(PathOf(main).replace_extension(".schedule")));
}

}  // namespace oncard::explore
