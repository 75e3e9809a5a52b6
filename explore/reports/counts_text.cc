#include "explore/reports/counts_text.h"

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
  return MakeMessage(
      "stateful: {0} {6}states, {1} transitions, {2} bad, {3} different ends{8}{10}{4}",
      "stateful：{0} 个{7}状态，{1} 次转移，错误 {2}，不同结局 {3}{9}{11}{5}", states.states,
      states.transitions, states.bad_states, states.final_full, states.complete ? "" : "; not all",
      states.complete ? "" : "；未搜索完", states.merged ? "merged " : "",
      states.merged ? "合并后的" : "",
      states.in_groups ? "; some counted in several groups of schedules" : "",
      states.in_groups ? "；有的在多组调度中重复计入" : "",
      states.symmetric ? "; up to an exchange of equal threads" : "",
      states.symmetric ? "；相同线程互换的状态算一个" : "");
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

}  // namespace

std::vector<Message> DescribeCounts(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  std::vector<Message> lines;
  if (exploration.traces) lines.push_back(CountsOf(*exploration.traces));
  if (exploration.bounded) lines.push_back(CountsOf(*exploration.bounded));
  if (exploration.samples) lines.push_back(CountsOf(*exploration.samples, exploration.engine));
  if (exploration.states) lines.push_back(CountsOf(*exploration.states));
  if (exploration.islands) lines.push_back(CountsOf(*exploration.islands));
  if (exploration.reduced) lines.push_back(CountsOf(*exploration.reduced));
  for (const FoundRace& found : exploration.races) {
    Message race = DescribeRace(findings.subject, found.race);
    if (found.benign) race = {race.en + " (benign)", race.zh + "（无害）"};
    lines.push_back(std::move(race));
  }
  return lines;
}

std::vector<Message> DescribeLastingCounts(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  if (!exploration.paired || exploration.verdict == Verdict::kIncomplete) {
    return DescribeCounts(findings);
  }
  // Of several cases, those without a failure ended as the clock has it.
  if (const auto& cases = findings.cases) {
    return {MakeMessage("auto: {0} cases", "auto：{0} 种情形", cases->searched)};
  }
  const StateCounts& states = *exploration.states;
  if (exploration.failure) return {CountsOf(states)};
  const int64_t ends = states.complete ? states.final_full : exploration.traces->final_full;
  return {MakeMessage("auto: {0} different ends", "auto：不同结局 {0}", ends)};
}

}  // namespace oncard::explore
