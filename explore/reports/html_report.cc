// Pages of explorations.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/markup.h"
#include "explore/reports/claim.h"
#include "explore/reports/counts_text.h"
#include "explore/reports/coverage_text.h"
#include "explore/reports/failure_report.h"
#include "explore/reports/page_style.h"
#include "explore/reports/report.h"
#include "explore/reports/requirement_words.h"

namespace oncard::explore {
namespace {

/// A longer schedule is not on the page: `--save` writes it.
constexpr int64_t kScheduleLinesMax = 400;

/// What the verdict says, beside it.
Message Sentence(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  switch (exploration.verdict) {
    case Verdict::kProved:
      return {"no schedule fails, under the assumptions and within the bounds of this report",
              "在本报告的前提与范围内，没有任何调度出错"};
    case Verdict::kFailed:
      return WhatFailed(findings, *exploration.failure);
    case Verdict::kPassed:
    case Verdict::kIncomplete:
      break;
  }
  return exploration.why;
}

/// What the verdict says of a requirement. With a failure, the others were not decided.
Message ResultOf(const Findings& findings, size_t requirement) {
  const Exploration& exploration = findings.exploration;
  switch (exploration.verdict) {
    case Verdict::kProved:
      return {"holds", "成立"};
    case Verdict::kPassed:
      return {"no violation was found", "未发现违反"};
    case Verdict::kFailed: {
      const Fault& fault = exploration.failure->fault;
      const bool this_one = fault.kind == Fault::Kind::kRequirement &&
                            static_cast<size_t>(fault.requirement) == requirement;
      if (this_one) return {"violated", "被违反"};
      break;
    }
    case Verdict::kIncomplete:
      break;
  }
  return {"not decided", "未判定"};
}

/// What a search does not look at, because something else stands for it. Both engines of `auto` are
/// named: which one answered depends on the clock.
std::vector<Message> Reductions(const Exploration& exploration) {
  std::vector<Message> lines;
  if (exploration.paired || exploration.traces) {
    lines.push_back(
        {"dpor: of schedules that differ only in the order of statements without common variables, "
         "one stands for all",
         "dpor：若若干调度仅在无共同变量的语句的先后上不同，则其中一个代表全部"});
  }
  if (exploration.paired || exploration.states || exploration.islands) {
    lines.push_back(
        {"stateful: a state that is reached again is not searched again; states are told apart by "
         "keys of 128 bits",
         "stateful：再次到达的状态不再搜索；状态以 128 位键区分"});
  }
  if (exploration.paired || (exploration.states && exploration.states->merged)) {
    lines.push_back(
        {"stateful: a statement that accesses no global can be one step with the one before it, "
         "where no requirement sees what is between them",
         "stateful：不访问全局变量的语句可与前一条合为一步，前提是没有要求能看到其间的状态"});
  }
  if (exploration.states && exploration.states->symmetric) {
    lines.push_back({"stateful: states that differ only in an exchange of equal threads are one",
                     "stateful：仅相同线程互换位置的状态算作一个"});
  }
  if (exploration.reduced) {
    lines.push_back(
        {"reduced: statements of a cycle that nobody notices were executed in one order; locals "
         "that are not read any more, and what is left of ended moves and stops, do not count",
         "约简：周期内不影响任何线程和要求的语句只按一种次序执行；不再读取的局部变量以及已结束的"
         "运动和停止所留下的数据不计入状态"});
  }
  if (exploration.islands) {
    lines.push_back(
        {"islands: threads that share nothing were searched apart, with any timing of the others: "
         "more than can happen, so that what holds there holds in the program",
         "islands：互不相关的线程分别搜索，其余线程的时序任意：涵盖多于实际可能的情况，"
         "故在其中成立者在程序中也成立"});
  }
  return lines;
}

std::vector<Message> AssumptionsOf(const Findings& findings, const Claim& claim) {
  std::vector<Message> lines = claim.assumptions;
  if (findings.subject.card) {
    lines.push_back(
        {"the card is the simulated one of oncard: it does what the manuals say, and where they "
         "leave something open what docs/assumptions.md says; time passes in whole cycles, and "
         "nothing but the world above acts on it",
         "控制卡为 oncard 所仿真者：其行为依据手册，手册未明之处依据 "
         "docs/assumptions.md；时间以整周期推进，除上述外部世界外无其他作用"});
  }
  if (findings.cases) {
    lines.push_back(
        {"of each choice the environment takes one value", "外部环境对每项选择取其中一个值"});
  }
  for (Message& line : Reductions(findings.exploration)) lines.push_back(std::move(line));
  return lines;
}

/// What is known of what the verdict has not put to the test.
std::vector<Message> Untested(const Findings& findings) {
  if (!findings.untested.empty()) return findings.untested;
  if (findings.knows_untested) {
    return {
        {"nothing: every requirement could have failed in some state, every assert was reached, "
         "and every event of the world came in some run",
         "无：每项要求都在某个状态下有可能不成立，每条断言都被到达，外部世界的每个事件都在某次运行"
         "中发生"}};
  }
  switch (findings.exploration.verdict) {
    case Verdict::kFailed:
      return {{"not said of a search that a failure has ended", "搜索因出错而结束，故不作说明"}};
    case Verdict::kIncomplete:
      return {{"not said of a search that is not complete; what it has reached is above",
               "搜索未完成，故不作说明；进度见上"}};
    case Verdict::kProved:
    case Verdict::kPassed:
      break;
  }
  return {{"not noted by this search", "此搜索未作记录"}};
}

class Page {
 public:
  Page(const Findings& findings, Language language, const ReportOptions& options)
      : findings_(findings),
        subject_(findings.subject),
        language_(language),
        options_(options),
        claim_(ClaimOf(findings)) {}

  std::string Make() {
    Begin();
    AddQuestion();
    if (const auto& failure = findings_.exploration.failure) {
      Head({"Failure", "出错过程"});
      html_ += FailureHtml(findings_, *failure, options_, language_);
    }
    Head({"Assumptions", "前提"});
    AddList(AssumptionsOf(findings_, claim_));
    AddBounds();
    AddCoverage();
    Head({"Not put to the test", "未经检验的内容"});
    AddList(Untested(findings_));
    AddIdentity();
    AddRepetition();
    return html_ + "</main>\n</body>\n</html>\n";
  }

 private:
  std::string Text(const Message& message) const { return EscapeMarkup(message.In(language_)); }
  void Head(const Message& title) { html_ += fmt::format("<h2>{}</h2>\n", Text(title)); }
  void SubHead(const Message& title) { html_ += fmt::format("<h3>{}</h3>\n", Text(title)); }
  void AddParagraph(const Message& text) { html_ += fmt::format("<p>{}</p>\n", Text(text)); }
  void AddBlock(std::string_view text) {
    html_ += fmt::format("<pre>{}</pre>\n", EscapeMarkup(text));
  }
  void AddList(const std::vector<Message>& lines) {
    html_ += "<ul>\n";
    for (const Message& line : lines) html_ += fmt::format("<li>{}</li>\n", Text(line));
    html_ += "</ul>\n";
  }

  void Begin() {
    const auto verdict = std::string(VerdictName(findings_.exploration.verdict));
    std::string name = subject_.program;
    for (const std::string& file : {subject_.scenario, subject_.record}) {
      if (file.empty()) continue;
      if (!name.empty()) name.insert(0, ": ");
      name.insert(0, file);
    }
    if (name.empty()) name = "oncard explore";
    html_ = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"{0}\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>{1}: {2}</title>\n<style>\n{3}</style>\n</head>\n<body>\n<main>\n<header>\n"
        "<p class=\"kind\">{4}</p>\n<h1>{1}</h1>\n"
        "<p class=\"verdict {2}\"><strong>{2}</strong>{5}</p>\n</header>\n",
        language_ == Language::kChinese ? "zh" : "en", EscapeMarkup(name), verdict, kPageStyle,
        Text({"oncard explore: report of a search for schedules that fail",
              "oncard explore：查找出错调度的搜索报告"}),
        Text(Sentence(findings_)));
  }

  void AddQuestion() {
    Head({"Question", "要求"});
    if (!subject_.requirements.empty()) {
      html_ += fmt::format(
          "<div class=\"wide\">\n<table class=\"facts\">\n"
          "<thead><tr><th>{}</th><th>{}</th><th>{}</th></tr></thead>\n",
          Text({"must hold", "必须成立"}), Text({"as written", "原文"}), Text({"result", "结果"}));
      for (size_t i = 0; i < subject_.requirements.size(); ++i) {
        html_ += fmt::format("<tr><td>{}</td><td><code>{}</code></td><td>{}</td></tr>\n",
                             Text(InWords(subject_.requirements[i])), Text(claim_.requirements[i]),
                             Text(ResultOf(findings_, i)));
      }
      html_ += "</table>\n</div>\n";
    }
    AddParagraph({"Also asked:", "此外还要求："});
    AddList(claim_.built_in);
    for (const Message& line : claim_.not_asked) {
      AddParagraph({"Not asked: " + line.en, "未要求：" + line.zh});
    }
    const auto results = UnaskedResultsOf(findings_);
    if (!results) return;
    AddParagraph(results->head);
    html_ += "<ul>\n";
    for (const std::string& end : results->ends) {
      html_ += fmt::format("<li><code>{}</code></li>\n", EscapeMarkup(end));
    }
    html_ += "</ul>\n";
    if (results->requirement.empty()) return;
    AddParagraph(results->ask);
    AddBlock(results->requirement);
  }

  void AddBounds() {
    Head({"Bounds", "范围"});
    std::vector<Message> lines = claim_.bounds;
    lines.insert(lines.end(), claim_.cases.begin(), claim_.cases.end());
    for (Message& count : DescribeLastingCounts(findings_)) lines.push_back(std::move(count));
    AddList(lines);
    const WayOut& way = findings_.way_out;
    const std::pair<Message, const std::vector<Message>&> parts[] = {
        {{"How far it came", "进度"}, way.reached},
        {{"What it spends its states on", "状态用于何处"}, way.spent},
        {{"What to try", "可尝试"}, way.next}};
    for (const auto& [title, texts] : parts) {
      if (texts.empty()) continue;
      SubHead(title);
      AddList(texts);
    }
  }

  void AddCoverage() {
    Head({"Coverage", "覆盖"});
    std::vector<Message> lines = claim_.covered;
    for (Message& line : DescribeCoverage(findings_)) lines.push_back(std::move(line));
    AddList(lines);
    const std::vector<LineMark> marks = MarksOf(findings_);
    if (marks.empty()) return;
    AddParagraph({"● reached, ◐ reached and a condition went one way only, ○ not reached",
                  "● 已到达，◐ 已到达但条件只走一个分支，○ 未到达"});
    html_ += "<div class=\"wide\">\n<table class=\"source\">\n";
    std::string_view text = findings_.source.text;
    for (size_t i = 0; !text.empty(); ++i) {
      const size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      if (line.ends_with('\r')) line.remove_suffix(1);
      html_ += fmt::format("<tr{}><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                           marks[i] == LineMark::kMissed ? " class=\"missed\"" : "", i + 1,
                           SignOf(marks[i]), EscapeMarkup(line));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    html_ += "</table>\n</div>\n";
  }

  static std::string_view SignOf(LineMark mark) {
    switch (mark) {
      case LineMark::kMissed:
        return "○";
      case LineMark::kReached:
        return "●";
      case LineMark::kOneWay:
        return "◐";
      case LineMark::kNone:
        break;
    }
    return "";
  }

  void AddIdentity() {
    Head({"What was searched", "搜索对象"});
    std::vector<Message> lines = claim_.program;
    lines.push_back(claim_.by);
    for (const std::string& file : findings_.repetition.searches) {
      lines.push_back({"search file " + file, "搜索文件 " + file});
    }
    AddList(lines);
  }

  void AddRepetition() {
    const Repetition& repetition = findings_.repetition;
    if (repetition.command.empty()) return;
    Head({"How to repeat it", "如何重复"});
    AddBlock(repetition.command);
    if (!findings_.exploration.failure || repetition.schedule.empty()) return;
    const std::string file = subject_.program.substr(0, subject_.program.rfind('.')) + ".schedule";
    const auto lines = std::ranges::count(repetition.schedule, '\n');
    const bool shown = lines <= kScheduleLinesMax;
    AddParagraph(shown ? MakeMessage("The failing run alone, with this text in {0}:",
                                     "仅重复出错的运行，其中 {0} 的内容如下：", file)
                       : MakeMessage("The failing run alone; {0} has {1} lines:",
                                     "仅重复出错的运行；{0} 共 {1} 行：", file, lines));
    if (!shown) AddBlock(fmt::format("{} --save {}", repetition.command, file));
    AddBlock("oncard replay " + file);
    if (shown) AddBlock(repetition.schedule);
  }

  const Findings& findings_;
  const Subject& subject_;
  Language language_;
  const ReportOptions& options_;
  Claim claim_;
  std::string html_;
};

}  // namespace

std::string HtmlReport(const Findings& findings, Language language, const ReportOptions& options) {
  return Page(findings, language, options).Make();
}

}  // namespace oncard::explore
