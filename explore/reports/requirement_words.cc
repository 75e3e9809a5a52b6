#include "explore/reports/requirement_words.h"

#include "base/milliseconds.h"

namespace oncard::explore {

Message InWords(const runtime::Requirement& requirement) {
  const std::string expression = requirement.Expression();
  using enum runtime::Scope;
  switch (requirement.scope) {
    case kFinal:
      return MakeMessage("at the end of every run {0} holds", "每次运行结束时 {0} 成立",
                         expression);
    case kAlways:
      return MakeMessage("{0} holds in every state", "{0} 在每个状态下都成立", expression);
    case kNever:
      return MakeMessage("{0} holds in no state", "{0} 在任何状态下都不成立", expression);
    case kEventually:
      return MakeMessage("in every run {0} holds at some time", "每次运行中 {0} 都会在某一时刻成立",
                         expression);
    case kLeads:
      return MakeMessage("whenever {0} holds, {1} holds then or later",
                         "每当 {0} 成立，此时或之后 {1} 成立", requirement.text, requirement.then);
    case kWithin:
      return MakeMessage("whenever {0} holds, {1} holds then or at most {2} ms later",
                         "每当 {0} 成立，此时或至多 {2} ms 之后 {1} 成立", requirement.text,
                         requirement.then, FormatMs(requirement.within_us));
    case kAssert:
      break;
  }
  return MakeMessage("{0} holds whenever a thread is about to execute the statement at {1}",
                     "每当线程即将执行 {1} 处的语句时，{0} 成立", expression, requirement.at);
}

}  // namespace oncard::explore
