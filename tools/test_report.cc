#include "tools/test_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "base/markup.h"
#include "compiler/display_text.h"

namespace oncard::tools {
namespace {

size_t CountPassed(const std::vector<TestOutcome>& outcomes) {
  return static_cast<size_t>(std::count_if(outcomes.begin(), outcomes.end(),
                                           [](const TestOutcome& o) { return o.passed(); }));
}

Message Warning(const Message& text) { return {"warning: " + text.en, "警告：" + text.zh}; }

std::string EscapeXml(std::string_view text) { return EscapeMarkup(compiler::DisplayText(text)); }

}  // namespace

std::string FormatTestText(const std::vector<TestOutcome>& outcomes, Language language,
                           bool color) {
  const std::string ok = color ? "\x1b[32mok\x1b[0m  " : "ok  ";
  const std::string fail = color ? "\x1b[1;31mFAIL\x1b[0m" : "FAIL";
  std::string text;
  for (const TestOutcome& outcome : outcomes) {
    text += fmt::format("{} {}\n", outcome.passed() ? ok : fail, outcome.Title());
    for (const Message& failure : outcome.failures) {
      text += fmt::format("     {}\n", failure.In(language));
    }
    for (const Message& warning : outcome.warnings) {
      text += fmt::format("     {}\n", Warning(warning).In(language));
    }
  }
  const size_t passed = CountPassed(outcomes);
  return text + MakeMessage("{0} passed, {1} failed\n", "{0} 个通过，{1} 个失败\n", passed,
                            outcomes.size() - passed)
                    .In(language);
}

std::string FormatTestJunit(const std::vector<TestOutcome>& outcomes, Language language) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"oncard\" tests=\"{}\" failures=\"{}\">\n",
      outcomes.size(), outcomes.size() - CountPassed(outcomes));
  for (const TestOutcome& outcome : outcomes) {
    const bool other = !outcome.program.empty();
    if (other) text += fmt::format("  <testcase classname=\"{}\"", EscapeXml(outcome.path));
    text += fmt::format("{} name=\"{}\" time=\"{:.6f}\"", other ? "" : "  <testcase",
                        EscapeXml(other ? outcome.program : outcome.path), outcome.time_ms / 1000);
    if (outcome.passed() && outcome.warnings.empty()) {
      text += "/>\n";
      continue;
    }
    text += ">\n";
    for (const Message& failure : outcome.failures) {
      text += fmt::format("    <failure message=\"{}\"/>\n", EscapeXml(failure.In(language)));
    }
    for (const Message& warning : outcome.warnings) {
      text += fmt::format("    <system-err>{}</system-err>\n",
                          EscapeXml(Warning(warning).In(language)));
    }
    text += "  </testcase>\n";
  }
  return text + "</testsuite>\n";
}

std::string FormatTestTap(const std::vector<TestOutcome>& outcomes, Language language) {
  std::string text = fmt::format("TAP version 13\n1..{}\n", outcomes.size());
  for (size_t i = 0; i < outcomes.size(); ++i) {
    const TestOutcome& outcome = outcomes[i];
    text += fmt::format("{} {} - {}\n", outcome.passed() ? "ok" : "not ok", i + 1, outcome.Title());
    for (const Message& failure : outcome.failures) {
      text += fmt::format("# {}\n", compiler::DisplayText(failure.In(language)));
    }
    for (const Message& warning : outcome.warnings) {
      text += fmt::format("# {}\n", compiler::DisplayText(Warning(warning).In(language)));
    }
  }
  return text;
}

std::string FormatTestCsv(const std::vector<TestOutcome>& outcomes, Language language) {
  const auto cell = [](std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
  };
  const auto lines = [&](const std::vector<Message>& messages) {
    std::string joined;
    for (const Message& message : messages) {
      joined += (joined.empty() ? "" : "\n") + message.In(language);
    }
    return cell(joined);
  };
  std::string text = "scenario,program,passed,time_ms,statements,failures,warnings\r\n";
  for (const TestOutcome& outcome : outcomes) {
    text += fmt::format("{},{},{},{},{},{},{}\r\n", cell(outcome.path), cell(outcome.program),
                        outcome.passed() ? "yes" : "no", outcome.time_ms, outcome.statements,
                        lines(outcome.failures), lines(outcome.warnings));
  }
  return text;
}

std::string FormatTestJson(const std::vector<TestOutcome>& outcomes, Language language) {
  using Json = nlohmann::ordered_json;
  Json tests = Json::array();
  for (const TestOutcome& outcome : outcomes) {
    Json failures = Json::array();
    for (const Message& failure : outcome.failures) failures.push_back(failure.In(language));
    Json warnings = Json::array();
    for (const Message& warning : outcome.warnings) warnings.push_back(warning.In(language));
    Json test = {{"path", outcome.path}};
    if (!outcome.program.empty()) test["program"] = outcome.program;
    test["passed"] = outcome.passed();
    test["time_ms"] = outcome.time_ms;
    test["statements"] = outcome.statements;
    test["failures"] = std::move(failures);
    test["warnings"] = std::move(warnings);
    tests.push_back(std::move(test));
  }
  const size_t passed = CountPassed(outcomes);
  const Json document = {
      {"passed", passed}, {"failed", outcomes.size() - passed}, {"tests", std::move(tests)}};
  return JsonText(document, 2) + '\n';
}

}  // namespace oncard::tools
