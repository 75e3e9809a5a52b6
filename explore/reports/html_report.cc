// Pages of explorations.
#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/markup.h"
#include "explore/reports/claim.h"
#include "explore/reports/counts_text.h"
#include "explore/reports/coverage_text.h"
#include "explore/reports/failure_report.h"
#include "explore/reports/report.h"

namespace oncard::explore {
namespace {

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

std::string ClaimHtml(const Findings& findings, Language language) {
  Claim claim = ClaimOf(findings);
  std::vector<Message> asked = std::move(claim.requirements);
  asked.insert(asked.end(), claim.built_in.begin(), claim.built_in.end());
  const WayOut& way = findings.way_out;
  const std::pair<Message, std::vector<Message>> entries[] = {
      {{"asked", "要求"}, std::move(asked)},
      {{"not asked", "未要求"}, std::move(claim.not_asked)},
      {{"program", "程序"}, std::move(claim.program)},
      {{"cases", "情形"}, std::move(claim.cases)},
      {{"assumes", "前提"}, std::move(claim.assumptions)},
      {{"bounds", "范围"}, std::move(claim.bounds)},
      {{"by", "工具"}, {claim.by}},
      {{"reached", "进度"}, way.reached},
      {{"spent on", "状态用于"}, way.spent},
      {{"try", "可尝试"}, way.next},
      {{"coverage", "覆盖"}, DescribeCoverage(findings)}};
  std::string html = "<table class=\"claim\">\n";
  for (const auto& [label, lines] : entries) {
    if (lines.empty()) continue;
    html += fmt::format("<tr><th>{}</th><td>", EscapeMarkup(label.In(language)));
    for (const Message& line : lines) {
      html += (&line == &lines.front() ? "" : "<br>") + EscapeMarkup(line.In(language));
    }
    html += "</td></tr>\n";
  }
  html += "</table>\n";
  const auto results = UnaskedResultsOf(findings);
  if (!results) return html;
  html += fmt::format("<p>{}</p>\n<ul>\n", EscapeMarkup(results->head.In(language)));
  for (const std::string& end : results->ends) {
    html += fmt::format("<li><code>{}</code></li>\n", EscapeMarkup(end));
  }
  html += "</ul>\n";
  if (results->requirement.empty()) return html;
  return html + fmt::format("<p>{}</p>\n<pre>{}</pre>\n", EscapeMarkup(results->ask.In(language)),
                            EscapeMarkup(results->requirement));
}

}  // namespace

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
  std::string counts;
  for (const Message& line : DescribeLastingCounts(findings)) counts += line.In(language) + '\n';
  page += fmt::format("<pre>{}</pre>\n", EscapeMarkup(counts));
  if (exploration.failure) {
    page += FailureHtml(findings, *exploration.failure, options, language);
  }
  return page + "</body>\n</html>\n";
}

}  // namespace oncard::explore
