#include "explore/reports/report.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "base/markup.h"
#include "explore/reports/claim.h"
#include "explore/reports/coverage_text.h"
#include "explore/reports/failure_report.h"

namespace oncard::explore {
namespace {

Message CountsOf(const TraceCounts& traces) {
  if (traces.counted) {
    return MakeMessage(
        "dpor: {0} executions, counted without executing each; {1} bad, {2} different ends",
        "dpor：{0} 次执行（由计数得出，并未逐一执行），错误 {1}，不同结局 {2}", traces.executions,
        traces.bad_traces, traces.final_full);
  }
  return MakeMessage(
      "dpor: {0} executions ({1} blocked, {2} redundant), {3} bad, {4} different ends{5}",
      "dpor：{0} 次执行（阻塞 {1}，冗余 {2}），错误 {3}，不同结局 {4}{6}", traces.executions,
      traces.blocked, traces.redundant, traces.bad_traces, traces.final_full,
      traces.complete ? "" : "; not all", traces.complete ? "" : "；未搜索完");
}

Message CountsOf(const StateCounts& states) {
  return MakeMessage("stateful: {0} {6}states, {1} transitions, {2} bad, {3} different ends{8}{4}",
                     "stateful：{0} 个{7}状态，{1} 次转移，错误 {2}，不同结局 {3}{9}{5}",
                     states.states, states.transitions, states.bad_states, states.final_full,
                     states.complete ? "" : "; not all", states.complete ? "" : "；未搜索完",
                     states.merged ? "merged " : "", states.merged ? "合并后的" : "",
                     states.in_groups ? "; some counted in several groups of schedules" : "",
                     states.in_groups ? "；有的在多组调度中重复计入" : "");
}

Message CountsOf(const IslandCounts& islands) {
  return MakeMessage("islands: {0} states, {1} transitions", "islands：{0} 个状态，{1} 次转移",
                     islands.states, islands.transitions);
}

Message CountsOf(const ReducedCounts& reduced) {
  return MakeMessage("reduced: {0} states, {1} transitions, {2} states at the start of a cycle",
                     "约简后：{0} 个状态，{1} 次转移，周期开始处 {2} 个状态", reduced.states,
                     reduced.transitions, reduced.starts);
}

Message CountsOf(const BoundedCounts& bounded) {
  return MakeMessage(
      "bounded: {0} states, {1} different ends, schedules with at most {2} preemptions{3}",
      "bounded：{0} 个状态，不同结局 {1}，抢占不超过 {2} 次的调度{4}", bounded.states,
      bounded.different_ends, bounded.preemptions, bounded.bad ? "; up to a bad one" : "",
      bounded.bad ? "；至首个出错者为止" : "");
}

Message CountsOf(const SampleCounts& samples, EngineKind engine) {
  return MakeMessage(
      "{0}: {1} runs ({2} given up), {3} bad, {4} different ends, {5} statements at most",
      "{0}：{1} 次运行（放弃 {2}），错误 {3}，不同结局 {4}，最多 {5} 条语句", EngineName(engine),
      samples.runs, samples.cut, samples.bad, samples.ends.size(), samples.longest);
}

std::string CountsText(const Findings& findings, Language language) {
  const Exploration& exploration = findings.exploration;
  std::string text;
  const auto add = [&](const Message& message) { text += message.In(language) + '\n'; };
  if (exploration.traces) add(CountsOf(*exploration.traces));
  if (exploration.bounded) add(CountsOf(*exploration.bounded));
  if (exploration.samples) add(CountsOf(*exploration.samples, exploration.engine));
  if (exploration.states) add(CountsOf(*exploration.states));
  if (exploration.islands) add(CountsOf(*exploration.islands));
  if (exploration.reduced) add(CountsOf(*exploration.reduced));
  for (const FoundRace& found : exploration.races) {
    const Message race = DescribeRace(findings.subject, found.race);
    const Message benign = {" (benign)", "（无害）"};
    add({race.en + (found.benign ? benign.en : ""), race.zh + (found.benign ? benign.zh : "")});
  }
  return text;
}

/// The counts of a page, which do not depend on the clock: of two engines that ran beside each
/// other the number of ends, which both find, or with a failure the states, which are then searched
/// to their end.
std::string LastingCountsText(const Findings& findings, Language language) {
  const Exploration& exploration = findings.exploration;
  if (!exploration.paired || exploration.verdict == Verdict::kIncomplete) {
    return CountsText(findings, language);
  }
  // Of several cases, those without a failure ended as the clock has it.
  if (const auto& cases = findings.cases) {
    return MakeMessage("auto: {0} cases", "auto：{0} 种情形", cases->searched).In(language) + '\n';
  }
  const StateCounts& states = *exploration.states;
  if (exploration.failure) return CountsOf(states).In(language) + '\n';
  const int64_t ends = states.complete ? states.final_full : exploration.traces->final_full;
  return MakeMessage("auto: {0} different ends", "auto：不同结局 {0}", ends).In(language) + '\n';
}

// --- HTML ----------------------------------------------------------------------------------------

constexpr std::string_view kPageStyle =
    "body { font-family: sans-serif; margin: 2em; }\n"
    "table { border-collapse: collapse; font-family: monospace; }\n"
    "th, td { padding: 0.15em 0.8em; text-align: left; vertical-align: top; white-space: pre; }\n"
    "th { border-bottom: 2px solid #555; }\n"
    "td.number, td.line { color: #888; text-align: right; }\n"
    "td.statement { background: #eef3fb; }\n"
    "td.repeat { color: #555; font-style: italic; }\n"
    "div.beside { display: flex; gap: 2em; align-items: flex-start; }\n"
    "svg text { font: 11px sans-serif; }\n"
    "td.escape { border-top: 2px solid #c00; }\n"
    "tr.time td { color: #555; border-top: 1px solid #bbb; }\n"
    "table.claim { font-family: inherit; }\n"
    "table.claim th { border: none; }\ntable.claim td { white-space: normal; }\n"
    "span.read { color: #555; }\n"
    "span.written { color: #06592a; }\n"
    "@media (max-width: 600px) { body { margin: 1em; } table { display: block; overflow-x: auto; } "
    "}\n"
    "@media print {\n  @page { size: A4; margin: 15mm; }\n"
    "  body { margin: 0; font-size: 9pt; }\n"
    "  th, td, pre { white-space: pre-wrap; overflow-wrap: anywhere; }\n"
    "  tr, svg { break-inside: avoid; }\n}\n"
    "h1.FAILED { color: #c00; }\nh1.PROVED, h1.PASSED { color: #06592a; }\n";

}  // namespace

std::string TextReport(const Findings& findings, Language language, const ReportOptions& options) {
  const Exploration& exploration = findings.exploration;
  std::string text = std::string(VerdictName(exploration.verdict)) + '\n';
  if (!exploration.why.en.empty()) text += exploration.why.In(language) + '\n';
  for (const Message& remark : findings.untested) {
    text += MakeMessage("remark: {0}", "注意：{1}", remark.en, remark.zh).In(language) + '\n';
  }
  text += ClaimText(findings, language);
  text += CountsText(findings, language);
  if (exploration.failure) {
    text += '\n' + FailureText(findings, *exploration.failure, options, language);
  }
  return text;
}

std::string JsonReport(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  nlohmann::ordered_json json;
  json["verdict"] = VerdictName(exploration.verdict);
  json["engine"] = EngineName(exploration.engine);
  for (const Message& remark : findings.untested) json["untested"].push_back(remark.en);
  AddClaim(findings, &json);
  AddCoverage(findings, &json);
  if (const auto& traces = exploration.traces) {
    json["executions"] = traces->executions;
    json["blocked"] = traces->blocked;
    json["redundant"] = traces->redundant;
    json["executions_complete"] = traces->complete;
    if (traces->complete) {
      json["traces"] = traces->executions - traces->redundant;
      json["bad_traces"] = traces->bad_traces;
      json["final_globals"] = traces->final_globals;
      json["final_full"] = traces->final_full;
    }
  }
  if (const auto& bounded = exploration.bounded) {
    json["bounded_states"] = bounded->states;
    json["bounded_preemptions"] = bounded->preemptions;
    json["different_ends"] = bounded->different_ends;
  }
  if (const auto& samples = exploration.samples) {
    json["runs"] = samples->runs;
    json["bad_runs"] = samples->bad;
    json["given_up"] = samples->cut;
    json["different_ends"] = samples->ends.size();
  }
  if (const auto& states = exploration.states) {
    json["states"] = states->states;
    json["transitions"] = states->transitions;
    json["states_complete"] = states->complete;
    if (states->merged) json["states_merged"] = true;
    if (states->in_groups) json["states_in_groups"] = true;
    if (states->complete) {
      json["bad_states"] = states->bad_states;
      json["final_globals"] = states->final_globals;
      json["final_full"] = states->final_full;
      for (size_t bound = 0; bound < states->finals_within.size(); ++bound) {
        json[fmt::format("finals_pb{}", bound)] = states->finals_within[bound];
      }
    }
  }
  if (const auto& islands = exploration.islands) {
    json["islands"] = islands->threads;
    json["island_states"] = islands->states;
    json["island_transitions"] = islands->transitions;
  }
  if (const auto& reduced = exploration.reduced) {
    json["reduced_states"] = reduced->states;
    json["reduced_transitions"] = reduced->transitions;
    json["reduced_starts"] = reduced->starts;
  }
  for (const FoundRace& found : exploration.races) {
    json["races"].push_back(RaceJson(findings.subject, found.race));
    json["races"].back()["benign"] = found.benign;
  }
  if (!exploration.why.en.empty()) json["why"] = exploration.why.en;
  if (const auto& failure = exploration.failure) {
    AddFailure(findings, *failure, &json);
  }
  return JsonText(json, 2) + '\n';
}

std::string HtmlReport(const Findings& findings, Language language, const ReportOptions& options) {
  const Exploration& exploration = findings.exploration;
  const bool chinese = language == Language::kChinese;
  const auto verdict = std::string(VerdictName(exploration.verdict));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{0}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>oncard explore: {1}</title>\n<style>\n{2}</style>\n</head>\n<body>\n"
      "<h1 class=\"{1}\">{1}</h1>\n",
      chinese ? "zh" : "en", verdict, kPageStyle);
  if (!exploration.why.en.empty()) {
    page += fmt::format("<p>{}</p>\n", EscapeMarkup(exploration.why.In(language)));
  }
  for (const Message& remark : findings.untested) {
    page += fmt::format("<p>{}</p>\n", EscapeMarkup(remark.In(language)));
  }
  page += ClaimHtml(findings, language);
  page += fmt::format("<pre>{}</pre>\n", EscapeMarkup(LastingCountsText(findings, language)));
  if (exploration.failure) {
    page += FailureHtml(findings, *exploration.failure, options, language);
  }
  return page + "</body>\n</html>\n";
}

}  // namespace oncard::explore
