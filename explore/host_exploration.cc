#include "explore/host_exploration.h"

#include <xxhash.h>

#include <filesystem>
#include <utility>

#include "base/path_bytes.h"
#include "explore/scenario_exploration.h"
#include "runtime/scenario/record/call_replay.h"

namespace oncard::explore {
namespace {

/// What the comments of the record's sources ask for.
Result<std::vector<Requirement>> ReadSources(const std::vector<runtime::RecordedSource>& sources,
                                             runtime::Scenario* scenario) {
  std::vector<Requirement> requirements;
  for (const runtime::RecordedSource& source : sources) {
    if (const int line = FirstAssertLine(source.text); line != 0) {
      return MakeError(1,
                       "{0}:{1}: the record of a host has the program as an object file, which has "
                       "no asserts: write '//@ always:' outside of functions, or remove it",
                       "{0}:{1}：主机记录中的程序是目标文件，其中没有断言：请在函数之外使用“//@ "
                       "always:”，或去掉该断言",
                       source.path, line);
    }
    if (FirstCommentLine(source.text) == 0) continue;
    auto read = ReadCommentLines(source.path, source.text);
    if (!read.ok()) return read.error();
    CommentProblem& problem = read.value();
    if (!problem.scenario.globals.empty()) {
      return MakeError(
          1,
          "{0} has initial values ('//@ init:', '//@ input:'): with the record of a host they are "
          "what the host writes",
          "{0} 含有初值（“//@ init:”、“//@ input:”）：使用主机记录时，初值由主机写入", source.path);
    }
    const runtime::Scenario& said = problem.scenario;
    if (said.races != runtime::Scenario{}.races) scenario->races = said.races;
    scenario->endless = scenario->endless || said.endless;
    if (said.livelock != runtime::Scenario{}.livelock) scenario->livelock = said.livelock;
    if (said.deadlock != runtime::Scenario{}.deadlock) scenario->deadlock = said.deadlock;
    scenario->sync.insert(scenario->sync.end(), said.sync.begin(), said.sync.end());
    requirements.insert(requirements.end(), problem.requirements.begin(),
                        problem.requirements.end());
  }
  return requirements;
}

}  // namespace

Result<Findings> ExploreRecord(const std::string& text, const std::string& path,
                               const ExploreOptions& options) {
  auto opened = runtime::OpenCallRecord(text, path, std::nullopt, 1);
  if (!opened.ok()) return opened.error();
  auto& [scenario, calls, sources, openings] = opened.value();
  if (openings.size() > 1) {
    return MakeError(1,
                     "{0} has the calls for {1} openings of cards: only a host that opens one card "
                     "once can be explored",
                     "{0} 含有 {1} 次打开控制卡的调用：只能探索仅打开一次一张卡的主机程序", path,
                     openings.size());
  }
  auto requirements = ReadSources(sources, &scenario);
  if (!requirements.ok()) return requirements.error();
  runtime::ScenarioErrors errors;
  CheckCardSearch(scenario, options, &errors);
  for (auto& [place, why] : runtime::ClashesWithEndless(scenario, requirements.value())) {
    errors.Add(place, std::move(why));
  }
  for (const auto& program : calls->programs()) {
    runtime::SyncGlobals(scenario, program->object, &errors);
  }
  auto model = CardModel::CreateFromCalls(scenario, requirements.value(), std::move(calls),
                                          std::move(errors));
  if (!model.ok()) return model.error();
  CardModel& card = model.value();
  scenario.program = sources.empty() ? path : sources.front().path;
  Findings findings = FindingsOf(scenario, &card, ExploreCard(&card, options));
  Subject& subject = findings.subject;
  subject.scenario.clear();
  subject.record = FileNameOf(PathOf(path).filename());
  subject.scenario_hash = XXH64(text.data(), text.size(), 0);
  subject.card = CardConditionsOf(scenario);
  if (card.host()->cut())
    subject.card->until_us = card.controller().clock().UsOf(card.host()->end_cycle());
  if (findings.exploration.verdict == Verdict::kIncomplete) {
    findings.way_out = WayOutOf(subject, findings.exploration, options, &card);
  }
  if (!sources.empty()) findings.source.text = sources.front().text;
  return findings;
}

}  // namespace oncard::explore
