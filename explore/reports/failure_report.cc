#include "explore/reports/failure_report.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "base/markup.h"
#include "runtime/observe/race_steps.h"

namespace oncard::explore {
namespace {

/// Maximum number of schedule segments in JSON; a longer schedule goes to a schedule file.
constexpr size_t kSegmentsMax = 10'000;

runtime::PlacedAccess PartyOf(const Subject& subject, const RacingStatement& statement) {
  const ThreadSetup& setup = subject.threads[static_cast<size_t>(statement.thread)];
  const auto& function = subject.image->object.functions[static_cast<size_t>(setup.function)];
  return {setup.thread, function.lines[static_cast<size_t>(statement.position)], statement.writes};
}

runtime::PlacedCommand CommandOf(const Subject& subject, const RacingStatement& statement) {
  const runtime::PlacedAccess party = PartyOf(subject, statement);
  return {party.thread, party.line, statement.command};
}

runtime::PlacedAccess PartyOf(const Findings& findings, const RacingPair::Statement& statement) {
  const TrailStep& step = findings.trail.steps[statement.step];
  return {step.log.thread, step.log.line, statement.writes};
}

/// Describes the results of the two orders of a data race.
Message DescribeOrder(const RaceOrder& order, const std::vector<RaceOrder>& orders) {
  const RaceOrder& other = &order == &orders.front() ? orders.back() : orders.front();
  const Message end = order.end.empty() ? Message{"the ends are the same", "最终结果相同"}
                                        : MakeMessage("at the end {0}", "最终 {0}", order.end);
  return {fmt::format("  thread {} first, then thread {}: {}; {}", order.first, other.first,
                      order.after, end.en),
          fmt::format("  线程 {} 在先，线程 {} 在后：{}；{}", order.first, other.first, order.after,
                      end.zh)};
}

/// Says so if a thread has read and used a value in one statement of its source. Structured C has
/// such statements; on the card they are several.
Message DescribeSplit(const Findings& findings, const Culprit& culprit) {
  if (culprit.steps.size() != 3) return {};
  const runtime::LoggedStep& read = findings.trail.steps[culprit.steps.front()].log;
  const runtime::LoggedStep& use = findings.trail.steps[culprit.steps.back()].log;
  const StatementTexts texts(findings.source, findings.subject.image->object);
  const bool one =
      read.thread == use.thread && read.position != use.position && texts.InOneStatement(read, use);
  if (!one) return {};
  return MakeMessage(
      "steps {0} and {1} belong to one statement of line {2}, '{3}': other threads can run between "
      "them",
      "第 {0} 步和第 {1} 步同属第 {2} 行的语句“{3}”：其间其他线程可以执行",
      culprit.steps.front() + 1, culprit.steps.back() + 1, read.line, texts.Of(read));
}

/// What is wrong, its cause and how it is reached, one line each.
std::vector<Message> SummaryOf(const Findings& findings, const Failure& failure,
                               const std::optional<Culprit>& culprit) {
  const Trail& trail = findings.trail;
  std::vector<Message> lines = {WhatFailed(findings, failure)};
  if (const auto& cases = findings.cases) {
    lines.push_back(MakeMessage("choice: {0}", "选择：{1}", cases->failing.en, cases->failing.zh));
  }
  if (culprit) {
    lines.push_back(culprit->sentence);
    if (Message split = DescribeSplit(findings, *culprit); !split.en.empty()) {
      lines.push_back(std::move(split));
    }
  }
  if (!trail.orders.empty()) {
    lines.push_back({"both orders of the two statements:", "两条语句的两种顺序："});
    for (const RaceOrder& order : trail.orders) {
      lines.push_back(DescribeOrder(order, trail.orders));
    }
  }
  lines.push_back(
      MakeMessage(failure.fewest_preemptions ? "statements: {0}, preemptions: {1}; no schedule "
                                               "with fewer preemptions fails"
                                             : "statements: {0}, preemptions: {1}",
                  failure.fewest_preemptions ? "{0} 条语句，{1} 次抢占；更少的抢占不会出错"
                                             : "{0} 条语句，{1} 次抢占",
                  failure.steps.size(), failure.preemptions));
  if (trail.pair) {
    const Message touched =
        runtime::DescribeRacingPair(trail.pair->what, PartyOf(findings, trail.pair->first),
                                    PartyOf(findings, trail.pair->second));
    lines.push_back({"racing pair: " + touched.en, "竞争对：" + touched.zh});
  }
  if (trail.skipped > 0) {
    lines.push_back(MakeMessage("shown: the last {0} statements, after {1} others",
                                "仅显示最后 {0} 条语句，之前还有 {1} 条", trail.steps.size(),
                                trail.skipped));
  }
  return lines;
}

/// What is not shown, and how to show it.
std::string LeftOutText(const StepView& view, Language language) {
  const size_t count = RowsOf(view, language).left_out;
  if (count == 0) return {};
  return MakeMessage("statements that touch nothing shared are left out: {0} (--full shows them)",
                     "未列出的不涉及共享内容的语句：{0} 条（--full 可全部列出）", count)
             .In(language) +
         '\n';
}

nlohmann::ordered_json PartiesJson(const std::string& what, const runtime::PlacedAccess& first,
                                   const runtime::PlacedAccess& second) {
  nlohmann::ordered_json json;
  json["what"] = what;
  for (const runtime::PlacedAccess& party : {first, second}) {
    json["statements"].push_back(
        {{"thread", party.thread}, {"line", party.line}, {"writes", party.writes}});
  }
  return json;
}

/// How much of a run the reports show.
Detail DetailOf(const ReportOptions& options) {
  return options.full ? Detail::kFull : Detail::kBrief;
}

}  // namespace

Message DescribeFault(const Findings& findings, const Failure& failure) {
  const Subject& subject = findings.subject;
  if (failure.livelock && !failure.fault) {
    if (!findings.trail.starvation.en.empty()) return findings.trail.starvation;
    return {"livelock: the threads can run for ever without any of them ending",
            "活锁：各线程可以一直运行而都不结束"};
  }
  switch (failure.fault.kind) {
    case Fault::Kind::kThread:
      return MakeMessage("thread {0} ends with a fault", "线程 {0} 因故障结束",
                         subject.threads[static_cast<size_t>(failure.fault.thread)].thread);
    case Fault::Kind::kDeadlock:
      return {
          "deadlock: every running thread waits for a variable that nothing can change any more",
          "死锁：所有运行中的线程都在等待不会再改变的变量"};
    case Fault::Kind::kTimeLimit:
      if (subject.host != nullptr) {
        return MakeMessage("threads still run {0} ms after the host closed the card",
                           "主机关闭控制卡 {0} ms 后仍有线程在运行", subject.card->limit_ms);
      }
      return {"threads still run at the scenario's limit_ms", "到场景的 limit_ms 时仍有线程在运行"};
    case Fault::Kind::kRace:
      return DescribeRace(subject, failure.fault.race);
    case Fault::Kind::kHostCall: {
      const std::string call = subject.host->calls().Describe(failure.fault.call);
      return MakeMessage("the card does not answer {0} as in the record of the host",
                         "控制卡对 {0} 的应答与主机记录不同", call);
    }
    case Fault::Kind::kNone:
    case Fault::Kind::kRequirement:
      break;
  }
  const Requirement& violated =
      subject.requirements[static_cast<size_t>(failure.fault.requirement)];
  if (violated.scope == Scope::kAssert) {
    return MakeMessage("{0} does not hold at {1} in thread {2}", "{0} 在 {1} 处（线程 {2}）不成立",
                       violated.Title(), violated.at,
                       subject.threads[static_cast<size_t>(failure.fault.thread)].thread);
  }
  const bool never = violated.scope == Scope::kNever;
  return MakeMessage(never ? "{0} holds" : "{0} does not hold", never ? "{0} 成立" : "{0} 不成立",
                     violated.Title());
}

Message WhatFailed(const Findings& findings, const Failure& failure) {
  Message wrong = DescribeFault(findings, failure);
  const Message& actual = findings.trail.actual;
  if (!actual.en.empty()) wrong = {wrong.en + ": " + actual.en, wrong.zh + "：" + actual.zh};
  return wrong;
}

Message DescribeRace(const Subject& subject, const Race& race) {
  const vm::Object& object = subject.image->object;
  if (runtime::IsSetByCommands(race.cell)) {
    return runtime::DescribeTwoOwners(race.cell, object, CommandOf(subject, race.first),
                                      CommandOf(subject, race.second));
  }
  return runtime::DescribeDataRace(NameOfSlot(object.globals, race.cell),
                                   PartyOf(subject, race.first), PartyOf(subject, race.second));
}

StepView ViewOf(const Findings& findings, const Failure& failure,
                const std::optional<Culprit>& culprit, Detail detail) {
  const Trail& trail = findings.trail;
  StepView view = {findings.subject, trail.steps, findings.source};
  view.detail = detail;
  view.with_card = trail.with_card;
  view.host = trail.host;
  view.trace = trail.trace ? &*trail.trace : nullptr;
  view.last_escape = failure.last_escape - trail.skipped;
  if (culprit) view.named = culprit->steps;
  if (trail.pair) {
    view.named.push_back(trail.pair->first.step);
    view.named.push_back(trail.pair->second.step);
  }
  if (trail.unanswered) view.named.push_back(*trail.unanswered);
  if (failure.fault.kind == Fault::Kind::kThread && !trail.steps.empty()) {
    view.named.push_back(trail.steps.size() - 1);
  }
  return view;
}

StepView CycleOf(const Findings& findings, Detail detail) {
  StepView view = {findings.subject, findings.trail.cycle, findings.source};
  view.detail = detail;
  return view;
}

std::string FailureText(const Findings& findings, const Failure& failure,
                        const ReportOptions& options, Language language) {
  const auto culprit = FindCulprit(findings.subject, failure, findings.trail);
  std::string text;
  for (const Message& line : SummaryOf(findings, failure, culprit)) {
    text += line.In(language) + '\n';
  }
  text += '\n';
  const StepView view = ViewOf(findings, failure, culprit, DetailOf(options));
  text += TextTable(view, options.width, language);
  if (failure.livelock) {
    text += Message{"\nand then for ever:\n", "\n然后永远重复：\n"}.In(language);
    text += TextTable(CycleOf(findings, DetailOf(options)), options.width, language);
  }
  return text + LeftOutText(view, language);
}

std::string FailureHtml(const Findings& findings, const Failure& failure,
                        const ReportOptions& options, Language language) {
  const auto culprit = FindCulprit(findings.subject, failure, findings.trail);
  std::string html = "<ul>\n";
  const std::vector<Message> summary = SummaryOf(findings, failure, culprit);
  // What failed is the first line.
  for (const Message& line : std::span(summary).subspan(1)) {
    html += fmt::format("<li>{}</li>\n", EscapeMarkup(line.In(language)));
  }
  html += "</ul>\n";
  const StepView view = ViewOf(findings, failure, culprit, DetailOf(options));
  html += HtmlTable(view, language);
  const auto paragraph = [&](const Message& message) {
    html += fmt::format("<p>{}</p>\n", message.In(language));
  };
  if (failure.last_escape >= 0) {
    paragraph({"From the red line on, every continuation fails.", "红线之后再无正确结局。"});
  }
  if (failure.livelock) {
    paragraph({"And then for ever:", "然后永远重复："});
    html += HtmlTable(CycleOf(findings, DetailOf(options)), language);
  }
  const std::string left_out = LeftOutText(view, language);
  if (!left_out.empty()) html += fmt::format("<p>{}</p>\n", EscapeMarkup(left_out));
  return html;
}

nlohmann::ordered_json RaceJson(const Subject& subject, const Race& race) {
  return PartiesJson(runtime::NameOfCell(race.cell, subject.image->object).en,
                     PartyOf(subject, race.first), PartyOf(subject, race.second));
}

void AddFailure(const Findings& findings, const Failure& failure, nlohmann::ordered_json* json) {
  if (findings.cases) (*json)["choice"] = findings.cases->failing.en;
  (*json)["reason"] = DescribeFault(findings, failure).en;
  const Trail& trail = findings.trail;
  if (!trail.actual.en.empty()) (*json)["actual"] = trail.actual.en;
  if (const auto culprit = FindCulprit(findings.subject, failure, trail)) {
    (*json)["culprit"] = culprit->sentence.en;
  }
  for (const RaceOrder& order : trail.orders) {
    (*json)["orders"].push_back(
        {{"first", order.first}, {"after", order.after}, {"end", order.end}});
  }
  if (failure.fault.kind == Fault::Kind::kRace) {
    (*json)["race"] = RaceJson(findings.subject, failure.fault.race);
  }
  if (failure.fewest_preemptions) {
    (*json)["min_preemptions_to_bad"] = failure.preemptions;
    if (failure.fewest_steps > 0) (*json)["min_steps_to_bad"] = failure.fewest_steps;
  }
  (*json)["preemptions"] = failure.preemptions;
  (*json)["last_escape"] = failure.last_escape;
  if (findings.trail.pair) {
    const RacingPair& pair = *findings.trail.pair;
    (*json)["racing_pair"] =
        PartiesJson(pair.what, PartyOf(findings, pair.first), PartyOf(findings, pair.second));
  }
  const auto schedule = ScheduleOf(findings.subject, failure).segments;
  if (schedule.size() > kSegmentsMax) return;
  auto& segments = (*json)["schedule"] = nlohmann::ordered_json::array();
  for (const vm::ScheduleSegment& segment : schedule) {
    segments.push_back({{"thread", segment.thread}, {"statements", segment.statements}});
  }
}

vm::Schedule ScheduleOf(const Subject& subject, const Failure& failure) {
  vm::Schedule schedule;
  schedule.program_hash = subject.image->hash;
  const auto add = [&](const std::vector<uint8_t>& steps) {
    for (const uint8_t step : steps) {
      const auto thread = static_cast<uint8_t>(subject.threads[step].thread);
      if (schedule.segments.empty() || schedule.segments.back().thread != thread) {
        schedule.segments.push_back({thread, 0});
      }
      ++schedule.segments.back().statements;
    }
  };
  add(failure.steps);
  add(failure.cycle);
  return schedule;
}

}  // namespace oncard::explore
