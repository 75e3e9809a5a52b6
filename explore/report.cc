#include "explore/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace oncard::explore {
namespace {

std::string_view ScopeName(Scope scope) {
  switch (scope) {
    case Scope::kFinal:
      return "final";
    case Scope::kAlways:
      return "always";
    case Scope::kNever:
      break;
  }
  return "never";
}

Message DescribeFault(const Problem& problem, const Failure& failure) {
  if (failure.livelock) {
    return {"livelock: all threads can go on for ever without any coming to its end",
            "活锁：各线程可以一直运行而都不结束"};
  }
  if (failure.fault.kind == Fault::Kind::kThread) {
    return MakeMessage("thread {0} ends with a fault", "线程 {0} 因故障结束",
                       problem.model.setup(failure.fault.thread).thread);
  }
  const BoundRequirement& violated =
      problem.requirements[static_cast<size_t>(failure.fault.requirement)];
  return MakeMessage("{0}: {1} does not hold", "{0}: {1} 不成立", ScopeName(violated.scope),
                     violated.property.text());
}

std::vector<std::string_view> Lines(std::string_view source) {
  std::vector<std::string_view> lines;
  for (size_t begin = 0; begin < source.size();) {
    const size_t end = std::min(source.find('\n', begin), source.size());
    std::string_view line = source.substr(begin, end - begin);
    const size_t first = line.find_first_not_of(" \t");
    line = first == std::string_view::npos ? std::string_view{} : line.substr(first);
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

/// One statement of the failing schedule.
struct Row {
  int thread = 0;
  std::string text;
};

/// `12  t = x;` and, when it changed a variable, `-> t = 0`.
std::vector<Row> RowsOf(const Problem& problem, const std::vector<uint8_t>& steps,
                        const std::vector<std::string_view>& lines) {
  std::vector<Row> rows;
  Model model = problem.model;
  for (const uint8_t thread : steps) {
    const int line = model.Line(thread);
    model.Step(thread);
    Row row;
    row.thread = thread;
    row.text = fmt::format("{:>4}  ", line);
    if (line > 0 && static_cast<size_t>(line) <= lines.size()) {
      row.text += lines[static_cast<size_t>(line) - 1];
    }
    if (const std::string written = model.LastWrite(); !written.empty()) {
      row.text += "   -> " + written;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string Table(const Problem& problem, const std::vector<Row>& rows, int64_t last_escape,
                  Language language) {
  const auto columns = static_cast<size_t>(problem.model.thread_count());
  std::vector<size_t> widths(columns);
  std::vector<std::string> heads(columns);
  for (size_t i = 0; i < columns; ++i) {
    const ThreadSetup& setup = problem.model.setup(static_cast<int>(i));
    const auto& functions = problem.model.image().object.functions;
    heads[i] = fmt::format("{} {} {}", language == Language::kChinese ? "线程" : "thread",
                           setup.thread, functions[static_cast<size_t>(setup.function)].name);
    widths[i] = heads[i].size();
  }
  for (const Row& row : rows) {
    size_t& width = widths[static_cast<size_t>(row.thread)];
    width = std::max(width, row.text.size());
  }
  std::string text = "      ";
  for (size_t i = 0; i < columns; ++i) text += fmt::format("  {:<{}}", heads[i], widths[i]);
  while (text.ends_with(' ')) text.pop_back();
  text += '\n';
  for (size_t i = 0; i < rows.size(); ++i) {
    std::string line = fmt::format("{:>6}", i + 1);
    for (size_t column = 0; column < static_cast<size_t>(rows[i].thread); ++column) {
      line += std::string(widths[column] + 2, ' ');
    }
    line += "  " + rows[i].text;
    if (static_cast<int64_t>(i) == last_escape) {
      line += language == Language::kChinese ? "   <- 此后再无正确结局"
                                             : "   <- from here on every end is bad";
    }
    text += line + '\n';
  }
  return text;
}

std::string CountsText(const Exploration& exploration, Language language) {
  std::string text;
  const auto add = [&](const Message& message) { text += message.In(language) + '\n'; };
  if (const auto& traces = exploration.traces) {
    add(MakeMessage(
        "dpor: {0} executions ({1} blocked, {2} redundant), {3} bad, {4} different ends{5}",
        "dpor：{0} 次执行（阻塞 {1}，冗余 {2}），错误 {3}，不同结局 {4}{6}", traces->executions,
        traces->blocked, traces->redundant, traces->bad_traces, traces->final_full,
        traces->complete ? "" : "; not all", traces->complete ? "" : "；未搜索完"));
  }
  if (const auto& states = exploration.states) {
    add(MakeMessage("stateful: {0} states, {1} transitions, {2} bad, {3} different ends{4}",
                    "stateful：{0} 个状态，{1} 次转移，错误 {2}，不同结局 {3}{5}", states->states,
                    states->transitions, states->bad_states, states->final_full,
                    states->complete ? "" : "; not all", states->complete ? "" : "；未搜索完"));
  }
  return text;
}

std::string FailureText(const Problem& problem, const Failure& failure, std::string_view source,
                        Language language) {
  std::string text = DescribeFault(problem, failure).In(language) + '\n';
  text += MakeMessage(
              failure.fewest_preemptions
                  ? "statements: {0}, preemptions: {1}; no schedule with fewer preemptions fails"
                  : "statements: {0}, preemptions: {1}",
              failure.fewest_preemptions ? "{0} 条语句，{1} 次抢占；更少的抢占不会出错"
                                         : "{0} 条语句，{1} 次抢占",
              failure.steps.size(), failure.preemptions)
              .In(language) +
          "\n\n";
  const auto lines = Lines(source);
  text += Table(problem, RowsOf(problem, failure.steps, lines), failure.last_escape, language);
  if (failure.livelock) {
    text += MakeMessage("\nand then for ever:\n", "\n然后永远重复：\n").In(language);
    Problem later = problem;
    for (const uint8_t thread : failure.steps) later.model.Step(thread);
    text += Table(problem, RowsOf(later, failure.cycle, lines), -1, language);
  }
  return text;
}

}  // namespace

std::string TextReport(const Problem& problem, const Exploration& exploration,
                       std::string_view source, Language language) {
  std::string text = std::string(VerdictName(exploration.verdict)) + '\n';
  if (exploration.verdict == Verdict::kIncomplete) text += exploration.why.In(language) + '\n';
  text += CountsText(exploration, language);
  if (exploration.failure) {
    text += '\n' + FailureText(problem, *exploration.failure, source, language);
  }
  return text;
}

std::string JsonReport(const Problem& problem, const Exploration& exploration) {
  nlohmann::ordered_json json;
  json["verdict"] = VerdictName(exploration.verdict);
  json["engine"] = EngineName(exploration.engine);
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
  if (const auto& states = exploration.states) {
    json["states"] = states->states;
    json["transitions"] = states->transitions;
    json["states_complete"] = states->complete;
    if (states->complete) {
      json["bad_states"] = states->bad_states;
      json["final_globals"] = states->final_globals;
      json["final_full"] = states->final_full;
      for (size_t bound = 0; bound < states->finals_within.size(); ++bound) {
        json[fmt::format("finals_pb{}", bound)] = states->finals_within[bound];
      }
    }
  }
  if (exploration.verdict == Verdict::kIncomplete) json["why"] = exploration.why.en;
  if (const auto& failure = exploration.failure) {
    json["reason"] = DescribeFault(problem, *failure).en;
    if (failure->fewest_preemptions) {
      json["min_preemptions_to_bad"] = failure->preemptions;
      json["min_steps_to_bad"] = failure->fewest_steps;
    }
    json["preemptions"] = failure->preemptions;
    json["last_escape"] = failure->last_escape;
    auto& segments = json["schedule"] = nlohmann::ordered_json::array();
    for (const vm::ScheduleSegment& segment : ScheduleOf(problem, *failure).segments) {
      segments.push_back({{"thread", segment.thread}, {"statements", segment.statements}});
    }
  }
  return json.dump(2) + '\n';
}

vm::Schedule ScheduleOf(const Problem& problem, const Failure& failure) {
  vm::Schedule schedule;
  schedule.program_hash = problem.model.image().hash;
  const auto add = [&](const std::vector<uint8_t>& steps) {
    for (const uint8_t step : steps) {
      const auto thread = static_cast<uint8_t>(problem.model.setup(step).thread);
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
