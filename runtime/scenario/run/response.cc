#include "runtime/scenario/run/response.h"

#include <algorithm>

#include "base/milliseconds.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/sim/card_clock.h"

namespace oncard::runtime {

void Owed::Observe(const Requirement& response, bool left, bool right, int64_t now_ns,
                   int64_t count) {
  if (late) return;
  if (pending && now_ns > due_ns) {
    late = true;
  } else if (right) {
    *this = {};
  } else if (left && !pending) {
    pending = true;
    since_ns = now_ns;
    since_count = count;
    if (response.scope == Scope::kWithin) {
      due_ns = now_ns + response.within_us * CardClock::kNsPerUs;
    }
  }
}

Message DescribeUnanswered(const Requirement& response, const Message& since, const Message& late,
                           const Message& values) {
  Message why = response.scope == Scope::kLeads
                    ? MakeMessage("'{0}' held {1}, and '{3}' neither then nor later",
                                  "“{0}”{2}成立，而“{3}”当时及之后均未成立", response.text,
                                  since.en, since.zh, response.then)
                    : MakeMessage("'{0}' held {1}, and '{3}' did not within {4} ms; too late {5}",
                                  "“{0}”{2}成立，而“{3}”在 {4} ms 内未成立；{6}已超时",
                                  response.text, since.en, since.zh, response.then,
                                  FormatMs(response.within_us), late.en, late.zh);
  if (!values.en.empty()) {
    why.en += ": " + values.en;
    why.zh += "：" + values.zh;
  }
  return why;
}

void CheckTimes(const std::vector<Requirement>& requirements, bool has_time, int64_t end_us,
                ScenarioErrors* errors) {
  for (const Requirement& requirement : requirements) {
    if (requirement.scope != Scope::kWithin) continue;
    if (!has_time) {
      errors->AddText(
          requirement.time_place, requirement.Title(),
          {"no time passes in a program that calls no GT commands: use 'leads', or give "
           "the run an end with 'until_ms'",
           "不调用 GT 指令的程序中时间不流逝：应改用“leads”，或用“until_ms”给出运行"
           "的结束时刻"});
    } else if (requirement.within_us > end_us) {
      errors->AddText(
          requirement.time_place, requirement.Title(),
          MakeMessage("nothing can be late: the run ends after {0} ms at the latest; "
                      "require less time, or let the run last longer",
                      "不可能超时：运行最迟在 {0} ms 结束；应缩短所要求的时间，或延长运行",
                      FormatMs(end_us)));
    }
  }
}

void CheckTimes(const std::vector<Requirement>& requirements, const Scenario& scenario,
                const vm::Object& object, ScenarioErrors* errors) {
  const int64_t limit_us = scenario.limit_ms * 1000;
  CheckTimes(requirements, NeedsCard(scenario, object),
             std::min(limit_us, scenario.until_us.value_or(limit_us)), errors);
}

}  // namespace oncard::runtime
