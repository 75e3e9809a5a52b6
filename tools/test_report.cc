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
    text += fmt::format("{} {}\n", outcome.passed() ? ok : fail, outcome.path);
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
    text += fmt::format("  <testcase name=\"{}\" time=\"{:.6f}\"", EscapeXml(outcome.path),
                        outcome.time_ms / 1000);
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
    text += fmt::format("{} {} - {}\n", outcome.passed() ? "ok" : "not ok", i + 1, outcome.path);
    for (const Message& failure : outcome.failures) {
      text += fmt::format("# {}\n", compiler::DisplayText(failure.In(language)));
    }
    for (const Message& warning : outcome.warnings) {
      text += fmt::format("# {}\n", compiler::DisplayText(Warning(warning).In(language)));
    }
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
    tests.push_back({{"path", outcome.path},
                     {"passed", outcome.passed()},
                     {"time_ms", outcome.time_ms},
                     {"statements", outcome.statements},
                     {"failures", std::move(failures)},
                     {"warnings", std::move(warnings)}});
  }
  const size_t passed = CountPassed(outcomes);
  const Json document = {
      {"passed", passed}, {"failed", outcomes.size() - passed}, {"tests", std::move(tests)}};
  return JsonText(document, 2) + '\n';
}

}  // namespace oncard::tools
