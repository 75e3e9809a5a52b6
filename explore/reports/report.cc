#include "explore/reports/report.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "explore/reports/claim.h"
#include "explore/reports/counts_text.h"
#include "explore/reports/coverage_text.h"
#include "explore/reports/failure_report.h"

namespace oncard::explore {

std::string TextReport(const Findings& findings, Language language, const ReportOptions& options) {
  const Exploration& exploration = findings.exploration;
  std::string text = std::string(VerdictName(exploration.verdict)) + '\n';
  if (!exploration.why.en.empty()) text += exploration.why.In(language) + '\n';
  for (const Message& remark : findings.untested) {
    text += MakeMessage("remark: {0}", "注意：{1}", remark.en, remark.zh).In(language) + '\n';
  }
  text += ClaimText(findings, language);
  for (const Message& line : DescribeCounts(findings)) text += line.In(language) + '\n';
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
    if (states->symmetric) json["states_symmetric"] = true;
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
    if (!islands->sums.empty()) json["island_sums"] = islands->sums;
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

}  // namespace oncard::explore
