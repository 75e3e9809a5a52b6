#include "tools/test_report.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "base/markup.h"
#include "compiler/display_text.h"

namespace oncard::tools {
namespace {

size_t CountOf(const std::vector<TestOutcome>& outcomes, TestStatus status) {
  return static_cast<size_t>(
      std::ranges::count(outcomes, status, [](const TestOutcome& o) { return o.status(); }));
}

/// As CSV and JSON name it.
std::string_view NameOf(TestStatus status, std::string_view passed, std::string_view failed) {
  switch (status) {
    case TestStatus::kPassed:
      return passed;
    case TestStatus::kFailed:
      return failed;
    case TestStatus::kNothing:
      return "nothing";
    case TestStatus::kSkipped:
      break;
  }
  return "skipped";
}

/// The lines of a text, safe to show.
std::vector<std::string> LinesOf(std::string_view text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(compiler::DisplayText(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return lines;
}

/// The message with its names made safe: a line end in one does not begin a line of the report.
std::string TextOf(const Message& message, const TestOutcome& outcome, Language language) {
  std::string text = message.In(language);
  for (const std::string& name : {outcome.path, outcome.program}) {
    const std::string shown = compiler::DisplayText(name);
    if (shown == name) continue;
    for (size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += shown.size()) {
      text.replace(at, name.size(), shown);
    }
  }
  return text;
}

std::vector<std::string> TextsOf(const std::vector<Message>& messages, const TestOutcome& outcome,
                                 Language language) {
  std::vector<std::string> texts;
  texts.reserve(messages.size());
  for (const Message& message : messages) texts.push_back(TextOf(message, outcome, language));
  return texts;
}

std::vector<std::string> FailuresOf(const TestOutcome& outcome, Language language) {
  return TextsOf(outcome.failures, outcome, language);
}

std::vector<std::string> WarningsOf(const TestOutcome& outcome, Language language) {
  std::vector<std::string> texts = TextsOf(outcome.warnings, outcome, language);
  const Message warning = {"warning: ", "警告："};
  for (std::string& text : texts) text.insert(0, warning.In(language));
  return texts;
}

/// What stands below the name of a test, without why it is neither passed nor failed.
std::vector<std::string> DetailsOf(const TestOutcome& outcome, Language language) {
  std::vector<std::string> texts = FailuresOf(outcome, language);
  const std::vector<std::string> warnings = WarningsOf(outcome, language);
  texts.insert(texts.end(), warnings.begin(), warnings.end());
  return texts;
}

/// Empty unless the test is neither passed nor failed.
std::string WhyOf(const TestOutcome& outcome, Language language) {
  if (outcome.status() == TestStatus::kFailed) return {};
  return compiler::DisplayText(outcome.why().In(language));
}

std::string EscapeXml(std::string_view text) { return EscapeMarkup(compiler::DisplayText(text)); }

/// A name that is no directive of TAP, which `#` begins.
std::string EscapeTap(std::string_view text) {
  std::string escaped;
  for (const char c : compiler::DisplayText(text)) {
    if (c == '#' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// A cell of CSV. An apostrophe before what would be a formula makes it a text.
std::string CellOf(const std::string& text) {
  constexpr std::string_view kFormulas = "=+-@";
  std::string quoted = "\"";
  if (!text.empty() && kFormulas.find(text.front()) != std::string_view::npos) quoted += '\'';
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string CellOfLines(const std::vector<std::string>& texts) {
  std::vector<std::string> lines;
  for (const std::string& text : texts) {
    for (std::string& line : LinesOf(text)) lines.push_back(std::move(line));
  }
  return CellOf(fmt::to_string(fmt::join(lines, "\n")));
}

std::string MarkOf(TestStatus status, bool color) {
  switch (status) {
    case TestStatus::kPassed:
      return color ? "\x1b[32mok\x1b[0m  " : "ok  ";
    case TestStatus::kFailed:
      return color ? "\x1b[1;31mFAIL\x1b[0m" : "FAIL";
    case TestStatus::kNothing:
      return color ? "\x1b[33mnone\x1b[0m" : "none";
    case TestStatus::kSkipped:
      break;
  }
  return color ? "\x1b[33mskip\x1b[0m" : "skip";
}

/// The counts in one line.
std::string SummaryOf(const std::vector<TestOutcome>& outcomes, Language language) {
  Message text =
      MakeMessage("{0} passed, {1} failed", "{0} 个通过，{1} 个失败",
                  CountOf(outcomes, TestStatus::kPassed), CountOf(outcomes, TestStatus::kFailed));
  if (const size_t nothing = CountOf(outcomes, TestStatus::kNothing); nothing > 0) {
    const Message more = MakeMessage(", {0} checked nothing", "，{0} 个未检查任何内容", nothing);
    text = {text.en + more.en, text.zh + more.zh};
  }
  if (const size_t skipped = CountOf(outcomes, TestStatus::kSkipped); skipped > 0) {
    const Message more = MakeMessage(", {0} skipped", "，{0} 个跳过", skipped);
    text = {text.en + more.en, text.zh + more.zh};
  }
  return text.In(language) + '\n';
}

/// `<testcase classname="" name="" time=""`, still open.
std::string JunitHead(const TestOutcome& outcome) {
  const bool other = !outcome.program.empty();
  const std::string of_class =
      other ? fmt::format(" classname=\"{}\"", EscapeXml(outcome.path)) : std::string();
  return fmt::format("  <testcase{} name=\"{}\" time=\"{:.6f}\"", of_class,
                     EscapeXml(other ? outcome.program : outcome.path),
                     (outcome.time_ms + outcome.search_ms) / 1000);
}

}  // namespace

std::string FormatTestText(const std::vector<TestOutcome>& outcomes, Language language,
                           bool color) {
  std::string text;
  for (const TestOutcome& outcome : outcomes) {
    text += fmt::format("{} {}\n", MarkOf(outcome.status(), color),
                        compiler::DisplayText(outcome.Title()));
    const std::string why = WhyOf(outcome, language);
    if (!why.empty()) text += fmt::format("     {}\n", why);
    for (const std::string& detail : DetailsOf(outcome, language)) {
      text += fmt::format("     {}\n", fmt::join(LinesOf(detail), "\n"));
    }
  }
  return text + SummaryOf(outcomes, language);
}

std::string FormatTestJunit(const std::vector<TestOutcome>& outcomes, Language language) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"oncard\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n",
      outcomes.size(), CountOf(outcomes, TestStatus::kFailed),
      CountOf(outcomes, TestStatus::kNothing) + CountOf(outcomes, TestStatus::kSkipped));
  for (const TestOutcome& outcome : outcomes) {
    text += JunitHead(outcome);
    if (outcome.status() == TestStatus::kPassed && outcome.warnings.empty()) {
      text += "/>\n";
      continue;
    }
    text += ">\n";
    for (const std::string& failure : FailuresOf(outcome, language)) {
      text += fmt::format("    <failure message=\"{}\"/>\n", EscapeXml(failure));
    }
    const std::string why = WhyOf(outcome, language);
    if (!why.empty()) text += fmt::format("    <skipped message=\"{}\"/>\n", EscapeXml(why));
    for (const std::string& warning : WarningsOf(outcome, language)) {
      text += fmt::format("    <system-err>{}</system-err>\n", EscapeXml(warning));
    }
    text += "  </testcase>\n";
  }
  return text + "</testsuite>\n";
}

std::string FormatTestTap(const std::vector<TestOutcome>& outcomes, Language language) {
  std::string text = fmt::format("TAP version 13\n1..{}\n", outcomes.size());
  for (size_t i = 0; i < outcomes.size(); ++i) {
    const TestOutcome& outcome = outcomes[i];
    const std::string why = WhyOf(outcome, language);
    text +=
        fmt::format("{} {} - {}{}{}\n", outcome.status() == TestStatus::kFailed ? "not ok" : "ok",
                    i + 1, EscapeTap(outcome.Title()), why.empty() ? "" : " # SKIP ", why);
    for (const std::string& detail : DetailsOf(outcome, language)) {
      text += fmt::format("# {}\n", fmt::join(LinesOf(detail), "\n# "));
    }
  }
  return text;
}

std::string FormatTestCsv(const std::vector<TestOutcome>& outcomes, Language language) {
  std::string text = "scenario,program,passed,time_ms,statements,failures,warnings\r\n";
  for (const TestOutcome& outcome : outcomes) {
    std::vector<std::string> warnings = TextsOf(outcome.warnings, outcome, language);
    const std::string why = WhyOf(outcome, language);
    if (!why.empty()) warnings.insert(warnings.begin(), why);
    text += fmt::format("{},{},{},{},{},{},{}\r\n", CellOf(compiler::DisplayText(outcome.path)),
                        CellOf(compiler::DisplayText(outcome.program)),
                        NameOf(outcome.status(), "yes", "no"), outcome.time_ms, outcome.statements,
                        CellOfLines(FailuresOf(outcome, language)), CellOfLines(warnings));
  }
  return text;
}

std::string FormatTestJson(const std::vector<TestOutcome>& outcomes, Language language) {
  using Json = nlohmann::ordered_json;
  Json tests = Json::array();
  for (const TestOutcome& outcome : outcomes) {
    Json test = {{"path", outcome.path}};
    if (!outcome.program.empty()) test["program"] = outcome.program;
    test["passed"] = outcome.status() == TestStatus::kPassed;
    test["status"] = NameOf(outcome.status(), "passed", "failed");
    const std::string why = WhyOf(outcome, language);
    if (!why.empty()) test["why"] = why;
    test["time_ms"] = outcome.time_ms;
    test["statements"] = outcome.statements;
    test["failures"] = FailuresOf(outcome, language);
    test["warnings"] = TextsOf(outcome.warnings, outcome, language);
    tests.push_back(std::move(test));
  }
  const Json document = {{"passed", CountOf(outcomes, TestStatus::kPassed)},
                         {"failed", CountOf(outcomes, TestStatus::kFailed)},
                         {"checked_nothing", CountOf(outcomes, TestStatus::kNothing)},
                         {"skipped", CountOf(outcomes, TestStatus::kSkipped)},
                         {"tests", std::move(tests)}};
  return JsonText(document, 2) + '\n';
}

}  // namespace oncard::tools
