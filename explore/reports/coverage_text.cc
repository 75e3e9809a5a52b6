#include "explore/reports/coverage_text.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace oncard::explore {
namespace {

struct FunctionCoverage {
  std::string name;
  std::string file;
  std::set<int> reached;  ///< source lines
  std::set<int> not_reached;
  std::set<int> one_way;  ///< lines that were reached, with a condition that went one way
  int ways = 0;
  int ways_gone = 0;
};

FunctionCoverage CoverageOf(const vm::Object& object, size_t number,
                            const StatementCoverage& coverage) {
  const vm::Function& function = object.functions[number];
  FunctionCoverage found;
  found.name = function.name;
  found.file = function.file;
  for (size_t i = 0; i < function.instructions.size(); ++i) {
    const uint8_t noted = coverage.At(number, i);
    const int line = i < function.lines.size() ? function.lines[i] : 0;
    if (line > 0) (noted != 0 ? found.reached : found.not_reached).insert(line);
    if (!HasTwoWays(function.instructions[i])) continue;
    const int gone = ((noted & StatementCoverage::kHeld) != 0 ? 1 : 0) +
                     ((noted & StatementCoverage::kNotHeld) != 0 ? 1 : 0);
    found.ways += 2;
    found.ways_gone += gone;
    if (gone == 1 && line > 0) found.one_way.insert(line);
  }
  for (const int line : found.reached) found.not_reached.erase(line);
  return found;
}

std::vector<FunctionCoverage> FunctionsOf(const Findings& findings) {
  std::vector<FunctionCoverage> functions;
  const StatementCoverage& coverage = findings.exploration.coverage;
  if (coverage.empty()) return functions;
  std::set<size_t> numbers;
  for (const ThreadSetup& setup : findings.subject.threads) {
    numbers.insert(static_cast<size_t>(setup.function));
  }
  for (const size_t number : numbers) {
    functions.push_back(CoverageOf(findings.subject.image->object, number, coverage));
  }
  return functions;
}

}  // namespace

std::vector<LineMark> MarksOf(const Findings& findings) {
  const ProgramText& source = findings.source;
  const auto functions = FunctionsOf(findings);
  if (source.text.empty() || functions.empty()) return {};
  std::vector<LineMark> marks(static_cast<size_t>(std::ranges::count(source.text, '\n')) + 1);
  const auto mark = [&](const std::set<int>& lines, LineMark as) {
    for (const int line : lines) {
      if (static_cast<size_t>(line) <= marks.size()) marks[static_cast<size_t>(line) - 1] = as;
    }
  };
  for (const FunctionCoverage& function : functions) {
    if (!source.file.empty() && function.file != source.file) continue;
    mark(function.reached, LineMark::kReached);
    mark(function.not_reached, LineMark::kMissed);
    mark(function.one_way, LineMark::kOneWay);
  }
  return marks;
}

std::vector<Message> DescribeCoverage(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  if (exploration.coverage.empty()) {
    return {{"not noted by this search", "此搜索未记录覆盖情况"}};
  }
  Message missing = {"not noted as reached", "未见到达的行"};
  if (exploration.verdict == Verdict::kProved) {
    missing = exploration.horizon.at_ms
                  ? Message{"cannot be reached in this time", "在此时间内不可到达的行"}
                  : Message{"cannot be reached", "不可到达的行"};
  }
  std::vector<Message> lines;
  for (const FunctionCoverage& function : FunctionsOf(findings)) {
    const size_t all = function.reached.size() + function.not_reached.size();
    Message line = MakeMessage("{0}: {1} of {2} lines reached, {3} of {4} ways of conditions",
                               "{0}：到达 {1}/{2} 行，条件分支 {3}/{4}", function.name,
                               function.reached.size(), all, function.ways_gone, function.ways);
    if (!function.not_reached.empty()) {
      const std::string numbers = fmt::format("{}", fmt::join(function.not_reached, ", "));
      line.en += fmt::format("; {}: {}", missing.en, numbers);
      line.zh += fmt::format("；{}：{}", missing.zh, numbers);
    }
    if (!function.one_way.empty()) {
      const std::string numbers = fmt::format("{}", fmt::join(function.one_way, ", "));
      line.en += "; one way only: " + numbers;
      line.zh += "；只走一个分支的行：" + numbers;
    }
    lines.push_back(std::move(line));
  }
  if (exploration.islands) {
    lines.push_back(
        {"with any timing of the other threads: what is reached may be more than the "
         "program reaches",
         "其余线程的时序任意：所到达的可能多于程序实际到达的"});
  }
  return lines;
}

void AddCoverage(const Findings& findings, nlohmann::ordered_json* json) {
  for (const FunctionCoverage& function : FunctionsOf(findings)) {
    (*json)["coverage"].push_back({{"function", function.name},
                                   {"lines", function.reached.size() + function.not_reached.size()},
                                   {"lines_reached", function.reached.size()},
                                   {"ways", function.ways},
                                   {"ways_gone", function.ways_gone},
                                   {"not_reached", function.not_reached},
                                   {"one_way", function.one_way}});
  }
}

}  // namespace oncard::explore
