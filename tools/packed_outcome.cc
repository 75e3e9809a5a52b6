#include "tools/packed_outcome.h"

#include <exception>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/json_text.h"
#include "tools/invocation.h"

namespace oncard::tools {
namespace {

std::string Pack(const TestOutcome& outcome) {
  const nlohmann::ordered_json packed = {
      {"failures", JsonOfMessages(outcome.failures)},
      {"warnings", JsonOfMessages(outcome.warnings)},
      {"reasons", JsonOfMessages({outcome.nothing, outcome.skipped})},
      {"time_ms", outcome.time_ms},
      {"search_ms", outcome.search_ms},
      {"statements", outcome.statements},
      {"interrupted", outcome.interrupted}};
  return JsonText(packed);
}

}  // namespace

std::string PackedOutcomeOf(const std::function<TestOutcome()>& work) {
  TestOutcome outcome;
  try {
    outcome = work();
  } catch (const std::exception& error) {
    outcome.failures.push_back(MakeMessage("internal error: {0}", "内部错误：{0}", error.what()));
  }
  return Pack(outcome);
}

bool UnpackOutcome(std::string_view text, TestOutcome* outcome) {
  const nlohmann::ordered_json packed = nlohmann::ordered_json::parse(text, nullptr, false);
  std::vector<Message> reasons;
  if (!packed.is_object() || !ReadMessages(packed.at("failures"), &outcome->failures) ||
      !ReadMessages(packed.at("warnings"), &outcome->warnings) ||
      !ReadMessages(packed.at("reasons"), &reasons)) {
    return false;
  }
  outcome->nothing = reasons.at(0);
  outcome->skipped = reasons.at(1);
  outcome->time_ms = packed.at("time_ms");
  outcome->search_ms = packed.at("search_ms");
  outcome->statements = packed.at("statements");
  outcome->interrupted = packed.at("interrupted");
  return true;
}

Message TookTooLong(int limit_s) {
  return MakeMessage("it took longer than {0} s: --timeout sets the limit",
                     "耗时超过 {0} 秒：可用 --timeout 设定上限", limit_s);
}

Message DescribeCrash(const std::string& name) {
  return MakeMessage("oncard itself crashed on this file ({0}): please report it",
                     "oncard 处理该文件时崩溃（{0}）：请报告此问题", name);
}

Message DescribeExit(int code) {
  if (code == kExitIncomplete) {
    return {"there was not enough memory for it", "内存不足，无法完成"};
  }
  return MakeMessage("oncard ended unexpectedly on this file (exit code {0}): please report it",
                     "oncard 处理该文件时意外结束（退出码 {0}）：请报告此问题", code);
}

}  // namespace oncard::tools
