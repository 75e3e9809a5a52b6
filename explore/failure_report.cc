#include "explore/failure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/markup.h"

namespace oncard::explore {
namespace {

std::string_view ScopeName(Scope scope) {
  switch (scope) {
    case Scope::kFinal:
      return "final";
    case Scope::kAlways:
      return "always";
    case Scope::kNever:
      return "never";
    case Scope::kEventually:
      break;
  }
  return "eventually";
}

/// One of two statements that touch the same, as sentences name it.
struct Party {
  int thread = 0;
  int line = 0;
  bool writes = false;
};

Message DescribeParties(const std::string& what, const Party& first, const Party& second) {
  const auto does = [](const Party& party) {
    return party.writes ? Message{"writes", "写"} : Message{"reads", "读"};
  };
  return {
      fmt::format("thread {} {} {} in line {}, thread {} {} it in line {}", first.thread,
                  does(first).en, what, first.line, second.thread, does(second).en, second.line),
      fmt::format("线程 {} 在第 {} 行{} {}，线程 {} 在第 {} 行{}它", first.thread, first.line,
                  does(first).zh, what, second.thread, second.line, does(second).zh)};
}

Party PartyOf(const Subject& subject, const RacingStatement& statement) {
  const ThreadSetup& setup = subject.threads[static_cast<size_t>(statement.thread)];
  const auto& function = subject.image->object.functions[static_cast<size_t>(setup.function)];
  return {setup.thread, function.lines[static_cast<size_t>(statement.position)], statement.writes};
}

Party PartyOf(const Findings& findings, const RacingPair::Statement& statement) {
  const TrailStep& step = findings.trail.steps[statement.step];
  return {findings.subject.threads[static_cast<size_t>(step.thread)].thread, step.line,
          statement.writes};
}

Message DescribeFault(const Subject& subject, const Failure& failure) {
  if (failure.livelock) {
    return {"livelock: all threads can go on for ever without any coming to its end",
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
      return {"threads still run at the scenario's limit_ms", "到场景的 limit_ms 时仍有线程在运行"};
    case Fault::Kind::kRace:
      return DescribeRace(subject, failure.fault.race);
    case Fault::Kind::kNone:
    case Fault::Kind::kRequirement:
      break;
  }
  const Requirement& violated =
      subject.requirements[static_cast<size_t>(failure.fault.requirement)];
  return MakeMessage("{0}: {1} does not hold", "{0}: {1} 不成立", ScopeName(violated.scope),
                     violated.text);
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

/// The line that a statement stands in; empty when there is no source.
std::string_view SourceLine(const TrailStep& step, const std::vector<std::string_view>& lines) {
  if (step.line <= 0 || static_cast<size_t>(step.line) > lines.size()) return {};
  return lines[static_cast<size_t>(step.line) - 1];
}

/// `12  t = x;`, what it read, `[x = 0]`, and the variable that it changed, `-> t = 0`.
std::string TextOf(const TrailStep& step, const std::vector<std::string_view>& lines) {
  std::string text = fmt::format("{:>4}  {}", step.line, SourceLine(step, lines));
  if (!step.read.empty()) text += "   [" + step.read + ']';
  if (!step.written.empty()) text += "   -> " + step.written;
  return text;
}

/// `thread 0 add`.
std::string ThreadHead(const Subject& subject, size_t index, Language language) {
  const ThreadSetup& setup = subject.threads[index];
  const auto& functions = subject.image->object.functions;
  return fmt::format("{} {} {}", language == Language::kChinese ? "线程" : "thread", setup.thread,
                     functions[static_cast<size_t>(setup.function)].name);
}

/// A column per thread. With a card, a line of its own says when a cycle begins.
std::string Table(const Subject& subject, const std::vector<TrailStep>& steps,
                  const std::vector<std::string_view>& lines, int64_t last_escape,
                  Language language) {
  const size_t columns = subject.threads.size();
  std::vector<size_t> widths(columns);
  std::vector<std::string> heads(columns);
  for (size_t i = 0; i < columns; ++i) {
    heads[i] = ThreadHead(subject, i, language);
    widths[i] = heads[i].size();
  }
  std::vector<std::string> texts;
  for (const TrailStep& step : steps) {
    texts.push_back(TextOf(step, lines));
    size_t& width = widths[static_cast<size_t>(step.thread)];
    width = std::max(width, texts.back().size());
  }
  std::string text = "      ";
  for (size_t i = 0; i < columns; ++i) text += fmt::format("  {:<{}}", heads[i], widths[i]);
  while (text.ends_with(' ')) text.pop_back();
  text += '\n';
  double at_ms = -1;
  for (size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].at_ms != at_ms) text += fmt::format("{} ms\n", steps[i].at_ms);
    at_ms = steps[i].at_ms;
    std::string line = fmt::format("{:>6}", i + 1);
    for (size_t column = 0; column < static_cast<size_t>(steps[i].thread); ++column) {
      line += std::string(widths[column] + 2, ' ');
    }
    line += "  " + texts[i];
    if (static_cast<int64_t>(i) == last_escape) {
      line += language == Language::kChinese ? "   <- 此后再无正确结局"
                                             : "   <- from here on every end is bad";
    }
    text += line + '\n';
  }
  return text;
}

/// What is wrong and how it is reached, a line each.
std::string SummaryOf(const Findings& findings, const Failure& failure, Language language) {
  std::string pair;
  if (findings.trail.pair) {
    const RacingPair& racing = *findings.trail.pair;
    const Message touched = DescribeParties(racing.what, PartyOf(findings, racing.first),
                                            PartyOf(findings, racing.second));
    pair = MakeMessage("racing pair: {0}\n", "竞争对：{1}\n", touched.en, touched.zh).In(language);
  }
  return DescribeFault(findings.subject, failure).In(language) + '\n' +
         MakeMessage(
             failure.fewest_preemptions
                 ? "statements: {0}, preemptions: {1}; no schedule with fewer preemptions fails"
                 : "statements: {0}, preemptions: {1}",
             failure.fewest_preemptions ? "{0} 条语句，{1} 次抢占；更少的抢占不会出错"
                                        : "{0} 条语句，{1} 次抢占",
             failure.steps.size(), failure.preemptions)
             .In(language) +
         '\n' + pair;
}

std::string HtmlTable(const Findings& findings, const std::vector<TrailStep>& steps,
                      int64_t last_escape, Language language) {
  const Subject& subject = findings.subject;
  const auto lines = Lines(findings.source);
  std::string table = "<table>\n<tr><th></th><th></th>";
  for (size_t i = 0; i < subject.threads.size(); ++i) {
    table += fmt::format("<th>{}</th>", EscapeMarkup(ThreadHead(subject, i, language)));
  }
  table += "</tr>\n";
  double at_ms = -1;
  for (size_t i = 0; i < steps.size(); ++i) {
    const TrailStep& step = steps[i];
    if (step.at_ms != at_ms) {
      table += fmt::format("<tr class=\"time\"><td colspan=\"{}\">{} ms</td></tr>\n",
                           subject.threads.size() + 2, step.at_ms);
    }
    at_ms = step.at_ms;
    table +=
        fmt::format("<tr><td class=\"number\">{}</td><td class=\"line\">{}</td>", i + 1, step.line);
    for (int column = 0; column < step.thread; ++column) table += "<td></td>";
    table += fmt::format("<td class=\"statement{}\">{}",
                         static_cast<int64_t>(i) == last_escape ? " escape" : "",
                         EscapeMarkup(SourceLine(step, lines)));
    if (!step.read.empty()) {
      table += fmt::format("   <span class=\"read\">[{}]</span>", EscapeMarkup(step.read));
    }
    if (!step.written.empty()) {
      table += fmt::format("   <span class=\"written\">{}</span>", EscapeMarkup(step.written));
    }
    table += "</td></tr>\n";
  }
  return table + "</table>\n";
}

nlohmann::ordered_json PartiesJson(const std::string& what, const Party& first,
                                   const Party& second) {
  nlohmann::ordered_json json;
  json["what"] = what;
  for (const Party& party : {first, second}) {
    json["statements"].push_back(
        {{"thread", party.thread}, {"line", party.line}, {"writes", party.writes}});
  }
  return json;
}

}  // namespace

Message DescribeRace(const Subject& subject, const Race& race) {
  const Message parties =
      DescribeParties(NameOfSlot(subject.image->object.globals, race.cell),
                      PartyOf(subject, race.first), PartyOf(subject, race.second));
  return {"data race: " + parties.en + ", and nothing orders the two",
          "数据竞争：" + parties.zh + "，两者之间没有顺序"};
}

std::string FailureText(const Findings& findings, const Failure& failure, Language language) {
  std::string text = SummaryOf(findings, failure, language) + '\n';
  const auto lines = Lines(findings.source);
  text += Table(findings.subject, findings.trail.steps, lines, failure.last_escape, language);
  if (failure.livelock) {
    text += MakeMessage("\nand then for ever:\n", "\n然后永远重复：\n").In(language);
    text += Table(findings.subject, findings.trail.cycle, lines, -1, language);
  }
  return text;
}

std::string FailureHtml(const Findings& findings, const Failure& failure, Language language) {
  std::string html =
      fmt::format("<pre>{}</pre>\n", EscapeMarkup(SummaryOf(findings, failure, language)));
  html += HtmlTable(findings, findings.trail.steps, failure.last_escape, language);
  const auto paragraph = [&](const Message& message) {
    html += fmt::format("<p>{}</p>\n", message.In(language));
  };
  if (failure.last_escape >= 0) {
    paragraph({"From the red line on every end is bad.", "红线之后再无正确结局。"});
  }
  if (failure.livelock) {
    paragraph({"And then for ever:", "然后永远重复："});
    html += HtmlTable(findings, findings.trail.cycle, -1, language);
  }
  return html;
}

nlohmann::ordered_json RaceJson(const Subject& subject, const Race& race) {
  return PartiesJson(NameOfSlot(subject.image->object.globals, race.cell),
                     PartyOf(subject, race.first), PartyOf(subject, race.second));
}

void AddFailure(const Findings& findings, const Failure& failure, nlohmann::ordered_json* json) {
  (*json)["reason"] = DescribeFault(findings.subject, failure).en;
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
  auto& segments = (*json)["schedule"] = nlohmann::ordered_json::array();
  for (const vm::ScheduleSegment& segment : ScheduleOf(findings.subject, failure).segments) {
    segments.push_back({{"thread", segment.thread}, {"statements", segment.statements}});
  }
}

std::string ChromeReport(const Findings& findings) {
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  const Subject& subject = findings.subject;
  const auto lines = Lines(findings.source);
  for (size_t i = 0; i < subject.threads.size(); ++i) {
    events.push_back({{"ph", "M"},
                      {"pid", 0},
                      {"tid", subject.threads[i].thread},
                      {"name", "thread_name"},
                      {"args", {{"name", ThreadHead(subject, i, Language::kEnglish)}}}});
  }
  int64_t at = 0;
  for (const auto* steps : {&findings.trail.steps, &findings.trail.cycle}) {
    for (const TrailStep& step : *steps) {
      nlohmann::ordered_json arguments = {{"statement", at + 1}, {"line", step.line}};
      if (!step.read.empty()) arguments["read"] = step.read;
      if (!step.written.empty()) arguments["written"] = step.written;
      if (step.at_ms >= 0) arguments["at_ms"] = step.at_ms;
      if (steps == &findings.trail.cycle) arguments["repeats"] = true;
      const std::string_view line = SourceLine(step, lines);
      events.push_back(
          {{"ph", "X"},
           {"pid", 0},
           {"tid", subject.threads[static_cast<size_t>(step.thread)].thread},
           {"ts", at++},
           {"dur", 1},
           {"name", line.empty() ? fmt::format("line {}", step.line) : std::string(line)},
           {"args", std::move(arguments)}});
    }
  }
  const nlohmann::ordered_json report = {{"traceEvents", std::move(events)}};
  return report.dump(1) + '\n';
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
